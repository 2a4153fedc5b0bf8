// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cycles of a dialect's page: its sections whose heading names a cycle's code, each a page of its own.

// By dialect, since a code means another thing elsewhere: G90 is a cycle of gsk988ta alone.
const kCodes = {
  gsk988ta: /\bG(9[024]|11[0-7])\b/g,
  hnc21t: /\bG(7[45]|8[0-2])\b/g,
  rs274: /\bG(7[346]|8[1-9]|33(\.1)?)(?![\d.])/g,
  sinumerik802s: /\bLCYC\d+\b/g,
};
// What cycles of a dialect have in common, where that is a section.
const kShared = /canned cycles, what all of them share|simple cycles, introduction/;
const kSection = /^<a id="(section-\d+|codes|outside)"><\/a>$/m;

export const dialectOf = (document) => /^docs\/dialects\/(\w+)\.md$/.exec(document)?.[1];

// A dialect's page in pieces, each the id of its section ('' before the first) and its text.
function sectionsOf(text) {
  const pieces = text.split(kSection);
  const sections = [{ id: '', text: pieces[0] }];
  for (let i = 1; i < pieces.length; i += 2) sections.push({ id: pieces[i], text: pieces[i + 1] });
  return sections;
}

// What a cycle is called in a list, without the name of the manual: "G81 and G82, drilling".
function nameOf(title, codes) {
  return title.slice(title.indexOf(codes[0])).trim();
}

// The cycles of a document: { id, codes, name, title, place, text }; none where it is no dialect's page.
export function cyclesOf(document, text) {
  const dialect = dialectOf(document);
  if (!kCodes[dialect]) return [];
  return sectionsOf(text).flatMap((section) => {
    const title = /^## (.+)$/m.exec(section.text)?.[1] ?? '';
    const codes = [...new Set(title.match(kCodes[dialect]) ?? [])];
    if (!/^section-/.test(section.id) || codes.length === 0) return [];
    const place = `dialects/${dialect}/${codes.join('-').toLowerCase()}.html`;
    return [{ ...section, dialect, codes, title, name: nameOf(title, codes), place }];
  });
}

// The section about all cycles of the dialect: { id, title }, or nothing.
export function sharedOf(text) {
  for (const section of sectionsOf(text)) {
    const title = /^## (.+)$/m.exec(section.text)?.[1] ?? '';
    if (kShared.test(title)) return { id: section.id, title };
  }
  return undefined;
}
