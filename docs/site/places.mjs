// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which documents the site has, where each of them stands in it, and the ids of headings.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const kProject = ['ARCHITECTURE.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'docs/release.md'];

export const kGroups = ['Start', 'Guides', 'Dialects', 'References', 'Project'];
export const kStart = 'docs/README.md';
export const kPlayground = 'build/playground/page/index.html';

export const escaped = (text) => text.replace(/[&<>"]/g, (c) => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

// The id that readers of Markdown give a heading.
export function slug(text, used) {
  const plain = text.toLowerCase().replace(/[^\p{L}\p{N}\s_-]/gu, '').trim().replace(/\s/g, '-');
  const times = used.get(plain) ?? 0;
  used.set(plain, times + 1);
  return times === 0 ? plain : `${plain}-${times}`;
}

// Where a file of the checkout stands in the site.
export function placeOf(path) {
  if (path === kStart) return 'index.html';
  if (/^[A-Z]+\.md$/.test(path)) return `${path.slice(0, -3).toLowerCase()}.html`;
  if (path.endsWith('.md')) return `${path.replace(/^docs\//, '').slice(0, -3)}.html`;
  if (/^docs\/.*\.(svg|png)$/.test(path)) return path.slice('docs/'.length);
  return `source/${path}.html`;
}

export function groupOf(path) {
  if (path === 'README.md' || path === kStart) return 'Start';
  if (kProject.includes(path)) return 'Project';
  if (path.startsWith('docs/guide-')) return 'Guides';
  return path.startsWith('docs/dialects/') ? 'Dialects' : 'References';
}

export function documentsOf(root) {
  const inFolder = (folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith('.md'))
    .sort().map((name) => `${folder}/${name}`);
  const first = ['README.md', kStart, ...kProject].filter((path) => existsSync(join(root, path)));
  return [...new Set([...first, ...inFolder('docs'), ...inFolder('docs/dialects')])];
}
