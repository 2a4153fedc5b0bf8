// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the filters and the list of cases.
'use strict';


const kRow = 36;
const list = byId('list');
const rows = byId('rows');
let shown = [];
let chosen = -1;  // place in shown
let openCase = null;

function fillSelect(id, values, everything) {
  byId(id).replaceChildren(el('option', { value: '' }, everything),
    ...values.map(([value, label]) => el('option', { value }, label ?? value)));
}

function setUpFilters() {
  const present = (pick) => [...new Set(cases.flatMap(pick))].sort().map((value) => [value]);
  fillSelect('by-verdict', [['@no-go', 'all NO-GO'], ['@undecided', 'all undecided'],
    ['@neither', 'neither GO nor NO-GO'], ['@go', 'all GO'], ...Object.keys(summary.totals).sort().map((value) => [value])], 'all');
  fillSelect('by-dialect', present((c) => c.dialect), 'all');
  fillSelect('by-cycle', present((c) => c.cycle), 'all');
  fillSelect('by-finding', summary.findings.map((finding) => [String(finding.number), `${finding.text} (${count(finding.cases)})`]), 'all');
  byId('by-finding').parentElement.hidden = summary.findings.length === 0;
  fillSelect('by-clause', present((c) => [...c.clauses, c.clause].filter(Boolean)), 'all');
  byId('search').addEventListener('input', applyFilters);
  for (const id of ['by-verdict', 'by-dialect', 'by-cycle', 'by-clause', 'by-finding']) {
    byId(id).addEventListener('change', applyFilters);
  }
  byId('filters').addEventListener('submit', (event) => event.preventDefault());
  byId('filters').addEventListener('reset', () => setTimeout(applyFilters));
  if (summary.headline.noGo > 0) byId('by-verdict').value = '@no-go';
}

function applyFilters() {
  const words = byId('search').value.toLowerCase().split(/\s+/).filter(Boolean);
  const verdict = byId('by-verdict').value;
  const [dialect, cycle, clause, finding] = ['by-dialect', 'by-cycle', 'by-clause', 'by-finding'].map((id) => byId(id).value);
  shown = cases.filter((c) =>
    (!verdict || c.verdict === verdict || `@${decisionOf(c.verdict)}` === verdict) &&
    (!dialect || c.dialect === dialect) && (!cycle || c.cycle === cycle) &&
    (!clause || c.clause === clause || c.clauses.includes(clause)) &&
    (!finding || String(c.finding) === finding) && words.every((word) => textOf(c).includes(word)));
  chosen = shown.findIndex((c) => c === openCase);
  for (const button of document.querySelectorAll('.total')) {
    button.setAttribute('aria-pressed', String(button.dataset.verdict === verdict));
  }
  byId('count').textContent = `${count(shown.length)} of ${counted(cases.length, 'case', 'cases')} shown`;
  rows.style.height = `${Math.max(shown.length * kRow, 1)}px`;
  list.classList.toggle('short', shown.length < 11);
  list.scrollTop = 0;
  showRows();
}

function textOf(c) {
  c.haystack ??= [c.id, c.verdict, c.clause, c.message, ...c.clauses].join(' ').toLowerCase();
  return c.haystack;
}

function showRows() {
  if (shown.length === 0) {
    rows.style.height = 'auto';
    rows.replaceChildren(el('p', { class: 'empty' }, 'No case fits these filters.'));
    return;
  }
  const first = Math.max(0, Math.floor(list.scrollTop / kRow) - 8);
  const last = Math.min(shown.length, first + Math.ceil((list.clientHeight || 400) / kRow) + 16);
  const nodes = [];
  for (let i = first; i < last; ++i) nodes.push(rowNode(shown[i], i));
  rows.replaceChildren(...nodes);
  if (chosen >= 0) list.setAttribute('aria-activedescendant', `row-${chosen}`);
  else list.removeAttribute('aria-activedescendant');
}

function rowNode(c, place) {
  const node = el('div', {
    class: 'row', role: 'option', id: `row-${place}`, 'aria-selected': String(place === chosen),
    'aria-setsize': shown.length, 'aria-posinset': place + 1,
    on: { click: () => choose(place, true) },
  }, el('span', { class: 'mono' }, c.id), el('span', {}, badge(c.verdict)),
  el('span', { class: 'mono', title: c.clause ? clauseTitle(c.clause) : null }, c.clause),
  el('span', {}, c.message));
  node.style.top = `${place * kRow}px`;
  return node;
}

function choose(place, scrollToDetail) {
  if (place < 0 || place >= shown.length) return;
  chosen = place;
  const top = place * kRow;
  if (top < list.scrollTop) list.scrollTop = top;
  else if (top + kRow > list.scrollTop + list.clientHeight) list.scrollTop = top + kRow - list.clientHeight;
  showRows();
  showCase(shown[place]);
  if (scrollToDetail) byId('detail').scrollIntoView({ block: 'start' });
}

list.addEventListener('scroll', showRows);
list.addEventListener('keydown', (event) => {
  const page = Math.floor(list.clientHeight / kRow);
  const step = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page,
    Home: -shown.length, End: shown.length }[event.key];
  if (event.key === 'Enter' && chosen >= 0) {
    byId('detail').scrollIntoView({ block: 'start' });
    byId('detail').focus({ preventScroll: true });
  } else if (step !== undefined) {
    choose(Math.min(Math.max(chosen + step, 0), shown.length - 1), false);
  } else {
    return;
  }
  event.preventDefault();
});
