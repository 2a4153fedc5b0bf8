// SPDX-License-Identifier: GPL-3.0-or-later
//
// Behind the library and the sections of all pages in search-index.js: what a search finds.
'use strict';

// NGC-G82-01, ngc.g83.return and G33.1 are words, whole and in their parts.
const wordsOf = (text) => text.toLowerCase().match(/[\p{L}\p{N}]+(?:[-._][\p{L}\p{N}]+)*/gu) ?? [];
const withParts = (text) => wordsOf(text).flatMap((word) => (/[-._]/.test(word) ? [word, ...word.split(/[-._]/)] : [word]));

const kFound = globalThis.gonogoPages.flatMap(([place, title, sections]) => sections.map(([id, heading, text], i) => ({
  address: place + (id && i > 0 ? `#${id}` : ''), title, heading: heading || title, text, first: i === 0,
})));
const kIndex = new globalThis.MiniSearch({
  fields: ['heading', 'title', 'text'], tokenize: withParts, processTerm: (term) => term,
  searchOptions: {
    tokenize: wordsOf, prefix: true, fuzzy: (term) => (/\d/.test(term) || term.length < 5 ? false : 0.2),
    boost: { heading: 6, title: 3 }, boostDocument: (id) => (kFound[id].first ? 2 : 1),
  },
});
kIndex.addAll(kFound.map((section, id) => ({ id, ...section })));

// Some words about the first of the terms that is in the text.
function excerptOf(text, terms) {
  const low = text.toLowerCase();
  const at = Math.min(...terms.map((term) => low.indexOf(term)).filter((place) => place >= 0), text.length);
  const from = at === text.length || at < 60 ? 0 : text.indexOf(' ', at - 60) + 1;
  return (from > 0 ? '\u2026 ' : '') + text.slice(from, from + 160) + (from + 160 < text.length ? ' \u2026' : '');
}

// The best sections for the words, first those that have all of them: { address, title, heading, excerpt }.
globalThis.gonogoFind = (words, most = 20) => {
  const all = kIndex.search(words, { combineWith: 'AND' });
  return (all.length > 0 ? all : kIndex.search(words, { combineWith: 'OR' })).slice(0, most).map(({ id, terms }) => {
    const { address, title, heading, text } = kFound[id];
    return { address, title, heading, excerpt: excerptOf(text, terms) };
  });
};
