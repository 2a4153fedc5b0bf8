// SPDX-License-Identifier: GPL-3.0-or-later
//
// What every page has about its text: head, search and navigation.
import { dirname, relative } from 'node:path';

import { escaped, groupOf, kGroups, placeOf } from './places.mjs';

function navigation({ documents, titles, cycles, extra }, place) {
  const item = (target, title, inner = '') => `<li><a href="${escaped(relative(dirname(place), target))}"${
    target === place ? ' aria-current="page"' : ''}>${escaped(title)}</a>${inner}</li>`;
  // The cycles of the dialect that is read.
  const below = (document) => {
    const own = cycles.get(document);
    if (own.length === 0 || ![placeOf(document), ...own.map((cycle) => cycle.place)].includes(place)) return '';
    return `<ul>${own.map((cycle) => item(cycle.place, cycle.name)).join('')}</ul>`;
  };
  const groups = kGroups.map((group) => {
    const items = documents.filter((path) => groupOf(path) === group)
      .map((path) => item(placeOf(path), titles.get(path), below(path)));
    if (group === 'Start') items.push(...extra.map(([target, title]) => item(target, title)));
    return items.length === 0 ? '' : `<h2>${group}</h2><ul>${items.join('')}</ul>`;
  });
  return groups.join('\n');
}

// Shown by its script, without which there is no search.
const search = (root) => `<form id="search" role="search" data-root="${root}" hidden>
<label for="search-words">Search</label>
<input id="search-words" type="search" autocomplete="off" spellcheck="false" placeholder="G83, NGC-G82-01, retract &hellip;" aria-describedby="search-count" aria-controls="search-found">
<output id="search-count" for="search-words" aria-live="polite"></output>
<ol id="search-found" aria-label="What was found" hidden></ol>
</form>`;

// `site`: documents, titles, cycles and extra of a Builder.
export function frame(site, place, title, body) {
  const root = '../'.repeat(place.split('/').length - 1);
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="${root}site.css">
<script src="${root}search.js" defer></script>
<title>${escaped(title)} - GoNoGo</title>
</head>
<body>
<a class="skip-link" href="#content">Skip to the text</a>
<header><p class="brand"><a href="${root}index.html">GoNoGo</a> <span>master gauge for CNC canned cycles</span></p>
${search(root)}</header>
<div class="columns">
<nav aria-label="Documents">${navigation(site, place)}</nav>
<main id="content">
${body}
</main>
</div>
</body>
</html>
`;
}
