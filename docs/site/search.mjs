// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the site's search looks through: the sections of every page, and each clause as one of its own.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';

const kEntities = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&quot;': '"', '&#39;': "'" };
const plain = (html) => html.replace(/<thead>[^]*?<\/thead>/g, '').replace(/<(br|\/td|\/th|\/li|\/p|\/h\d|\/pre)\b[^>]*>/g, ' ').replace(/<[^>]*>/g, '')
  .replace(/&(amp|lt|gt|quot|#39);/g, (entity) => kEntities[entity]).replace(/\s+/g, ' ').trim();

// A row of a table whose first cell has an id: a clause. Its last cell names sources.
const kClause = /<tr>\s*<td><a id="([^"]+)"><\/a>([^<]+)<\/td>([^]*?)<\/tr>/g;

// Sections of a page's body: [id, heading, text].
export function searchedOf(body) {
  const found = [];
  const pieces = body.split(/<h[1-6] id="([^"]*)">([^]*?)<\/h[1-6]>/);
  for (let i = 0; i < pieces.length; i += 3) {
    const clauses = [];
    const rest = pieces[i].replace(kClause, (row, id, name, cells) => {
      clauses.push([id, plain(name), plain(cells.replace(/<td><a href[^]*/, ''))]);
      return '';
    });
    const [id, heading] = i === 0 ? ['', ''] : [pieces[i - 2], plain(pieces[i - 1])];
    if (heading || plain(rest)) found.push([id, heading, plain(rest)]);
    found.push(...clauses);
  }
  return found;
}

// The script that a page loads when somebody searches: the library with its licence, how it is asked, and
// the sections of `pages`, each { place, title, sections }.
export function searchScript(folder, pages) {
  const library = join(folder, 'node_modules/minisearch');
  const licence = readFileSync(join(library, 'LICENSE.txt'), 'utf8').trim();
  const data = pages.map(({ place, title, sections }) => [place, title, sections]);
  return [`/* MiniSearch. ${licence} */`, readFileSync(join(library, 'dist/umd/index.js'), 'utf8').replace(/^\/\/# source.*$/m, ''),
    `globalThis.gonogoPages = [\n${data.map((page) => JSON.stringify(page)).join(',\n')}\n];`,
    readFileSync(join(folder, 'find.js'), 'utf8')].join('\n');
}
