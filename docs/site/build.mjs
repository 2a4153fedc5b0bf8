#!/usr/bin/env node
// SPDX-License-Identifier: GPL-3.0-or-later
//
// build.mjs OUT [--peers FOLDER] [--playground FOLDER]: the documents of this checkout as a site that opens
// offline, each document a page. `npm ci` in this folder brings the renderer of Markdown.
//
// FOLDER of --peers is a site of `gonogo site`, put in OUT/peers; that of --playground is put in
// OUT/playground. A playground that lies in OUT already is linked as well. Exits with 1 where a
// document links to what is not there, with 2 where it is used wrongly.
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, normalize, relative } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

const here = dirname(fileURLToPath(import.meta.url));
const kGroups = ['Start', 'Guides', 'Dialects', 'References', 'Project'];
const kProject = ['ARCHITECTURE.md', 'CONTRIBUTING.md', 'CHANGELOG.md', 'docs/release.md'];

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
  if (path === 'docs/README.md') return 'index.html';
  if (/^[A-Z]+\.md$/.test(path)) return `${path.slice(0, -3).toLowerCase()}.html`;
  if (path.endsWith('.md')) return `${path.replace(/^docs\//, '').slice(0, -3)}.html`;
  if (/^docs\/.*\.(svg|png)$/.test(path)) return path.slice('docs/'.length);
  return `source/${path}.html`;
}

function groupOf(path) {
  if (path === 'README.md' || path === 'docs/README.md') return 'Start';
  if (kProject.includes(path)) return 'Project';
  if (path.startsWith('docs/guide-')) return 'Guides';
  return path.startsWith('docs/dialects/') ? 'Dialects' : 'References';
}

function documentsOf(root) {
  const inFolder = (folder) => readdirSync(join(root, folder)).filter((name) => name.endsWith('.md'))
    .sort().map((name) => `${folder}/${name}`);
  const first = ['README.md', 'docs/README.md', ...kProject].filter((path) => existsSync(join(root, path)));
  return [...new Set([...first, ...inFolder('docs'), ...inFolder('docs/dialects')])];
}

const kPlayground = 'build/playground/page/index.html';

class Builder {
  constructor(root, out, marked) {
    Object.assign(this, { root, out, marked, faults: [], others: new Set(), links: [] });
    this.documents = documentsOf(root);
    this.titles = new Map(this.documents.map((path) => [path, this.titleOf(path)]));
  }

  read(path) { return readFileSync(join(this.root, path), 'utf8'); }
  titleOf(path) {
    if (path === 'docs/README.md') return 'Documents';
    const heading = /^# (.+)$/m.exec(this.read(path));
    return heading ? heading[1].replace(/[`*]/g, '') : path;
  }

  write(place, text) {
    mkdirSync(dirname(join(this.out, place)), { recursive: true });
    writeFileSync(join(this.out, place), text);
  }

  // A link of a document, as it has to be in the site; null: to a playground that is not there.
  linkOf(document, href) {
    if (/^[a-z]+:/.test(href)) return href;
    const [path, fragment] = href.split('#');
    const end = fragment === undefined ? '' : `#${fragment}`;
    if (path === '') return end;
    const target = normalize(join(dirname(document), path)).replace(/\/$/, '');
    // Built by a script of its own; here it stands where --playground puts it.
    if (target === kPlayground) {
      return this.hasPlayground ? relative(dirname(placeOf(document)), 'playground/index.html') + end : null;
    }
    if (target.startsWith('..') || !existsSync(join(this.root, target))) {
      this.faults.push(`${document}: the link ${href} leads nowhere`);
      return href;
    }
    if (statSync(join(this.root, target)).isDirectory()) {
      this.faults.push(`${document}: the link ${href} is a folder; name a file in it`);
      return href;
    }
    if (!this.documents.includes(target)) this.others.add(target);
    return relative(dirname(placeOf(document)), placeOf(target)) + end;
  }

  navigation(place, extra) {
    const up = (target) => relative(dirname(place), target);
    const item = (target, title) =>
      `<li><a href="${escaped(up(target))}"${target === place ? ' aria-current="page"' : ''}>${escaped(title)}</a></li>`;
    const groups = kGroups.map((group) => {
      const items = this.documents.filter((path) => groupOf(path) === group)
        .map((path) => item(placeOf(path), this.titles.get(path)));
      if (group === 'Start') items.push(...extra.map(([target, title]) => item(target, title)));
      return items.length === 0 ? '' : `<h2>${group}</h2><ul>${items.join('')}</ul>`;
    });
    return groups.join('\n');
  }

  page(place, title, body) {
    const home = relative(dirname(place), 'index.html');
    const style = relative(dirname(place), 'site.css');
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${style}">
<title>${escaped(title)} - GoNoGo</title>
</head>
<body>
<a class="skip-link" href="#content">Skip to the text</a>
<header><p class="brand"><a href="${home}">GoNoGo</a> <span>master gauge for CNC canned cycles</span></p></header>
<div class="columns">
<nav aria-label="Documents">${this.navigation(place, this.extra)}</nav>
<main id="content">
${body}
</main>
</div>
</body>
</html>
`;
  }

  html(document) {
    const used = new Map();
    const tokens = this.marked.lexer(this.read(document));
    this.marked.walkTokens(tokens, (token) => {
      if (token.type === 'link' || token.type === 'image') token.href = this.linkOf(document, token.href);
    });
    const renderer = new this.marked.Renderer();
    renderer.heading = function heading({ tokens: inner, depth, text }) {
      return `<h${depth} id="${escaped(slug(text, used))}">${this.parser.parseInline(inner)}</h${depth}>\n`;
    };
    const plainLink = this.marked.Renderer.prototype.link;
    renderer.link = function link(token) { return token.href === null ? '' : plainLink.call(this, token); };
    renderer.html = ({ text }) => text.replace(/<!--[^]*?-->/g, '');
    const plain = this.marked.Renderer.prototype.table;
    renderer.table = function table(token) { return `<div class="scroll">${plain.call(this, token)}</div>`; };
    return this.marked.parser(tokens, { renderer });
  }

  build(extra) {
    this.extra = extra;
    for (const document of this.documents) {
      const place = placeOf(document);
      this.write(place, this.page(place, this.titles.get(document), this.html(document)));
    }
    // What documents link to: pictures as they are, sources and other files as text.
    for (const path of [...this.others].sort()) {
      const place = placeOf(path);
      if (/\.(svg|png)$/.test(place)) {
        mkdirSync(dirname(join(this.out, place)), { recursive: true });
        cpSync(join(this.root, path), join(this.out, place));
      } else {
        this.write(place, this.page(place, path, path.endsWith('.md') ? this.html(path)
          : `<h1 class="mono">${escaped(path)}</h1>\n<pre>${escaped(this.read(path))}</pre>`));
      }
    }
    cpSync(join(here, 'site.css'), join(this.out, 'site.css'));
  }
}

function putFolder(out, name, from) {
  if (from === undefined) return;
  if (!existsSync(join(from, 'index.html'))) throw new Error(`${from} has no index.html: name the folder of a site`);
  cpSync(from, join(out, name), { recursive: true });
}

// Builds the site of the checkout `root` into `out`; what is wrong with its documents, a sentence each.
export async function buildSite(root, out, { peers, playground } = {}) {
  const { marked } = await import('marked').catch(() => {
    throw new Error(`the renderer of Markdown is missing: run \`npm ci\` in ${here}`);
  });
  mkdirSync(out, { recursive: true });
  putFolder(out, 'peers', peers);
  putFolder(out, 'playground', playground);
  const extra = [['peers/index.html', 'Implementations under the gauge'], ['playground/index.html', 'Playground']]
    .filter(([place]) => existsSync(join(out, place)));
  const builder = new Builder(root, out, marked);
  builder.hasPlayground = existsSync(join(out, 'playground/index.html'));
  builder.build(extra);
  return { pages: builder.documents.length, faults: builder.faults };
}

async function main(words) {
  const folders = {};
  const places = [];
  for (let i = 0; i < words.length; ++i) {
    const option = /^--(peers|playground)$/.exec(words[i]);
    if (option && words[i + 1] !== undefined) folders[option[1]] = words[++i];
    else places.push(words[i]);
  }
  if (places.length !== 1 || places[0].startsWith('-')) {
    console.error('usage: build.mjs OUT [--peers FOLDER] [--playground FOLDER]');
    return 2;
  }
  try {
    const { pages, faults } = await buildSite(join(here, '..', '..'), places[0], folders);
    for (const fault of faults) console.error(fault);
    console.log(`${join(places[0], 'index.html')}: ${pages} documents`);
    return faults.length === 0 ? 0 : 1;
  } catch (error) {
    console.error(`build.mjs: ${error.message}.`);
    return 2;
  }
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  process.exitCode = await main(process.argv.slice(2));
}
