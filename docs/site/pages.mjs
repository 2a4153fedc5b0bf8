// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes the pages: the documents, one for each cycle, and what documents link to.
import { cpSync, existsSync, mkdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { dirname, join, normalize, relative } from 'node:path';

import { cyclesOf, dialectOf, sharedOf } from './cycles.mjs';
import { frame } from './frame.mjs';
import { documentsOf, escaped, kPlayground, placeOf, slug } from './places.mjs';
import { searchScript, searchedOf } from './search.mjs';

const kScripts = ['site.css', 'search.js'];
const kCyclesMark = '<!-- the cycles, by dialect -->';

export class Builder {
  // `extra`: [place, title] of what the site has besides documents.
  constructor(root, out, marked, extra) {
    Object.assign(this, { root, out, marked, extra, faults: [], others: new Set(), searched: [] });
    this.documents = documentsOf(root);
    this.titles = new Map(this.documents.map((path) => [path, this.titleOf(path)]));
    this.cycles = new Map(this.documents.map((path) => [path, cyclesOf(path, this.read(path))]));
    this.hasPlayground = existsSync(join(out, 'playground/index.html'));
  }

  read(path) { return readFileSync(join(this.root, path), 'utf8'); }
  titleOf(path) {
    const heading = /^# (.+)$/m.exec(this.read(path));
    return heading ? heading[1].replace(/[`*]/g, '') : path;
  }

  write(place, text) {
    mkdirSync(dirname(join(this.out, place)), { recursive: true });
    writeFileSync(join(this.out, place), text);
  }

  writePage(place, title, body) { this.write(place, frame(this, place, title, body)); }

  // A link of a document, as it has to be on the page at `place`; null: to a playground that is not there.
  linkOf(document, href, place) {
    if (/^[a-z]+:/.test(href)) return href;
    const [path, fragment] = href.split('#');
    const end = fragment === undefined ? '' : `#${fragment}`;
    if (path === '') return place === placeOf(document) ? end : relative(dirname(place), placeOf(document)) + end;
    const target = normalize(join(dirname(document), path)).replace(/\/$/, '');
    // Built by a script of its own; here it stands where --playground puts it.
    if (target === kPlayground) return this.hasPlayground ? relative(dirname(place), 'playground/index.html') + end : null;
    if (target.startsWith('..') || !existsSync(join(this.root, target))) {
      this.faults.push(`${document}: the link ${href} leads nowhere`);
      return href;
    }
    if (statSync(join(this.root, target)).isDirectory()) {
      this.faults.push(`${document}: the link ${href} is a folder; name a file in it`);
      return href;
    }
    if (!this.documents.includes(target)) this.others.add(target);
    return relative(dirname(place), placeOf(target)) + end;
  }

  // `text` of a document as HTML for the page at `place`; links to ids of `text` stay on that page.
  html(document, text = this.read(document), place = placeOf(document), raise = 0) {
    const used = new Map();
    const tokens = this.marked.lexer(text);
    const own = new Set([...text.matchAll(/<a id="([^"]+)">/g)].map((match) => `#${match[1]}`));
    this.marked.walkTokens(tokens, (token) => {
      if (token.type !== 'link' && token.type !== 'image') return;
      if (!own.has(token.href)) token.href = this.linkOf(document, token.href, place);
    });
    const renderer = new this.marked.Renderer();
    renderer.heading = function heading({ tokens: inner, depth, text: words }) {
      const level = depth - raise;
      return `<h${level} id="${escaped(slug(words, used))}">${this.parser.parseInline(inner)}</h${level}>\n`;
    };
    const plainLink = this.marked.Renderer.prototype.link;
    renderer.link = function link(token) { return token.href === null ? '' : plainLink.call(this, token); };
    renderer.html = ({ text: raw }) => raw.replace(/<!--[^]*?-->/g, (comment) => (comment === kCyclesMark ? comment : ''));
    const plain = this.marked.Renderer.prototype.table;
    renderer.table = function table(token) { return `<div class="scroll">${plain.call(this, token)}</div>`; };
    return this.marked.parser(tokens, { renderer });
  }

  // Links to the cycles of a document, seen from a page.
  cycleList(document, place) {
    const items = this.cycles.get(document).map((cycle) =>
      `<li><a href="${escaped(relative(dirname(place), cycle.place))}">${escaped(cycle.name)}</a></li>`);
    return `<ul class="cycles">${items.join('')}</ul>`;
  }

  // The cycles of all dialects, for the start page.
  everyCycle(place) {
    return this.documents.filter(dialectOf).map((document) => {
      const name = `<h3><a href="${relative(dirname(place), placeOf(document))}">${dialectOf(document)}</a></h3>`;
      return `<div>${name}${this.cycles.get(document).length > 0 ? this.cycleList(document, place) : '<p>path commands</p>'}</div>`;
    }).join('\n');
  }

  writeDocument(document) {
    const place = placeOf(document);
    const title = this.titles.get(document);
    let body = this.html(document);
    const cycles = this.cycles.get(document);
    let searched = body;
    if (cycles.length > 0) {
      const pieces = body.split(/(?=<a id="(?:section-\d+|codes|outside)">)/);
      // A cycle is found on its own page.
      searched = pieces.filter((piece) => !cycles.some(({ id }) => piece.startsWith(`<a id="${id}">`))).join('');
      body = body.replace(/<\/h1>/, `</h1>\n<p>Each cycle on a page of its own; this page has all sections:</p>\n${this.cycleList(document, place)}`);
    }
    body = body.replace(kCyclesMark, () => `<div class="dialects">${this.everyCycle(place)}</div>`);
    this.writePage(place, title, body);
    this.searched.push({ place, title, sections: searchedOf(searched) });
    cycles.forEach((cycle, i) => this.writeCycle(document, cycle, cycles[i - 1], cycles[i + 1]));
  }

  writeCycle(document, cycle, before, behind) {
    const to = (place) => escaped(relative(dirname(cycle.place), place));
    const whole = to(placeOf(document));
    const shared = sharedOf(this.read(document));
    const text = this.html(document, cycle.text, cycle.place, 1);
    const body = `<p class="path"><a href="${whole}">Dialect ${cycle.dialect}</a> &rsaquo; ${escaped(cycle.name)}</p>
${text}
<h2 id="more">More</h2>
<ul>
${shared ? `<li><a href="${whole}#${shared.id}">${escaped(shared.title)}</a></li>\n` : ''}<li><a href="${whole}">What clauses, readings and drawings are, and all other sections</a></li>
<li><a href="${whole}#codes">Codes and words of the dialect</a>, <a href="${whole}#outside">what is not covered</a></li>
${before ? `<li>Before: <a href="${to(before.place)}" rel="prev">${escaped(before.name)}</a></li>\n` : ''}${behind ? `<li>Next: <a href="${to(behind.place)}" rel="next">${escaped(behind.name)}</a></li>\n` : ''}</ul>`;
    const title = `${cycle.name} (${cycle.dialect})`;
    this.writePage(cycle.place, title, body);
    this.searched.push({ place: cycle.place, title, sections: searchedOf(text) });
  }

  // What documents link to: pictures as they are, sources and other files as text.
  writeOther(path) {
    const place = placeOf(path);
    if (/\.(svg|png)$/.test(place)) {
      mkdirSync(dirname(join(this.out, place)), { recursive: true });
      cpSync(join(this.root, path), join(this.out, place));
    } else if (path.endsWith('.md')) {
      const body = this.html(path);
      this.writePage(place, path, body);
      this.searched.push({ place, title: this.titleOf(path), sections: searchedOf(body) });
    } else {
      this.writePage(place, path, `<h1 class="mono">${escaped(path)}</h1>\n<pre>${escaped(this.read(path))}</pre>`);
    }
  }

  // `own`: the folder of this program.
  build(own) {
    for (const document of this.documents) this.writeDocument(document);
    for (const path of [...this.others].sort()) this.writeOther(path);
    for (const name of kScripts) cpSync(join(own, name), join(this.out, name));
    this.write('search-index.js', searchScript(own, this.searched));
  }
}
