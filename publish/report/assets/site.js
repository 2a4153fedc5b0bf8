// SPDX-License-Identifier: GPL-3.0-or-later
//
// The site of many results: hides rows of the table beside a search that do not have its words. The
// pages show everything without it.
'use strict';

for (const form of document.querySelectorAll('form.filter')) {
  const rows = [...document.querySelectorAll(`#${form.dataset.of} tbody tr`)];
  const told = form.querySelector('output');
  const search = form.querySelector('input');
  const who = form.querySelector('select');
  const apply = () => {
    const words = search.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of rows) {
      row.haystack ??= row.textContent.toLowerCase();
      const has = !who || who.value === '' || (row.dataset.who ?? '').split(' ').includes(who.value);
      row.hidden = !has || !words.every((word) => row.haystack.includes(word));
      if (!row.hidden) ++shown;
    }
    told.textContent = `${shown.toLocaleString('en')} of ${rows.length.toLocaleString('en')} shown`;
  };
  form.hidden = false;
  form.addEventListener('submit', (event) => event.preventDefault());
  form.addEventListener('input', apply);
  apply();
}
