// SPDX-License-Identifier: GPL-3.0-or-later
//
// The search box of every page. Its index is a script, loaded when somebody first goes to the box, because
// a page that is opened from a file may not fetch.
'use strict';

(() => {
  const byId = (id) => document.getElementById(id);
  const [form, box, list, count] = ['search', 'search-words', 'search-found', 'search-count'].map(byId);
  const root = form.dataset.root;
  form.hidden = false;
  let loaded = null;

  function load() {
    loaded ??= new Promise((resolve, reject) => {
      const script = document.createElement('script');
      script.src = `${root}search-index.js`;
      script.onload = resolve;
      script.onerror = () => reject(new Error('search-index.js is missing beside index.html'));
      document.head.append(script);
    });
    return loaded;
  }

  function element(tag, text, css) {
    const node = document.createElement(tag);
    if (css) node.className = css;
    node.textContent = text;
    return node;
  }

  function itemOf({ address, title, heading, excerpt }) {
    const link = document.createElement('a');
    link.href = root + address;
    link.append(element('strong', heading), ' ');
    if (title !== heading) link.append(element('span', title, 'where'));
    link.append(element('span', excerpt, 'excerpt'));
    const item = document.createElement('li');
    item.append(link);
    return item;
  }

  function clear() {
    list.replaceChildren();
    list.hidden = true;
    count.textContent = '';
  }

  async function show() {
    const words = box.value.trim();
    if (words === '') return clear();
    try {
      await load();
    } catch (error) {
      count.textContent = error.message;
      return undefined;
    }
    if (words !== box.value.trim()) return undefined;
    const found = globalThis.gonogoFind(words);
    list.replaceChildren(...found.map(itemOf));
    list.hidden = found.length === 0;
    count.textContent = found.length === 0 ? 'Nothing found' : `${found.length}${found.length === 20 ? ' best' : ''} found`;
    return undefined;
  }

  // Arrows go through box and results, Escape back to an empty box.
  function key(event) {
    const places = [box, ...list.querySelectorAll('a')];
    const at = places.indexOf(document.activeElement);
    const to = { ArrowDown: at + 1, ArrowUp: at - 1 }[event.key];
    if (event.key === 'Escape') {
      box.value = '';
      clear();
      box.focus();
    } else if (to >= 0 && to < places.length) places[to].focus();
    else return;
    event.preventDefault();
  }

  box.addEventListener('focus', () => { load().catch(() => {}); });
  box.addEventListener('input', show);
  form.addEventListener('keydown', key);
  form.addEventListener('submit', async (event) => {
    event.preventDefault();
    await show();
    list.querySelector('a')?.click();
  });
  document.addEventListener('keydown', (event) => {
    if (event.key !== '/' || event.ctrlKey || event.metaKey || event.altKey || event.target.closest('input, textarea')) return;
    event.preventDefault();
    box.focus();
  });
  document.addEventListener('click', (event) => { if (!form.contains(event.target)) clear(); });
})();
