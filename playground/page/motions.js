// SPDX-License-Identifier: GPL-3.0-or-later
//
// The path and its motions, one after the other: in space, in the list, and by the line of the program.
'use strict';

const kMostRows = 2000;  // motions listed
const kPart = 100;       // rows laid out together

let stepped = null;

function showPaths(base, other) {
  byId('path').hidden = !base.steps || base.steps.length === 0;
  stepped = null;
  markLine(0);
  if (byId('path').hidden) return;
  const lists = { r: base.steps, s: other?.found.steps ?? [] };
  const view = new View3d({ lathe: base.lathe, moves: { r: base.moves, s: other?.found.moves }, limits: base.limits });
  const position = el('output', { id: 'position', 'aria-live': 'polite' });
  const slider = el('input', { type: 'range', id: 'slider', min: 0, max: lists.r.length - 1, value: 0, 'aria-label': 'Record', on: { input: (event) => goTo('r', Number(event.target.value)) } });
  const button = (id, label, title, act) => el('button', { type: 'button', id, title, on: { click: act } }, label);
  const bar = el('div', { class: 'stepper', role: 'group', 'aria-label': 'Step through the motions' },
    button('back', '\u25c0 Back', 'One record back (left arrow)', () => step(-1)), button('forward', 'Forward \u25b6', 'One record on (right arrow)', () => step(1)), slider, position);
  const looks = el('div', { class: 'stepper', role: 'group', 'aria-label': 'The view in space' },
    ...[['Front', 'front'], ['Top', 'top'], ['Side', 'side'], ['Isometric', 'isometric']].map(([label, name]) => button(`view-${name}`, label, label, () => view.reset(name))),
    button('larger', '+', 'Magnify', () => view.magnify(1.6)), button('smaller', '\u2212', 'Make smaller', () => view.magnify(0.625)),
    el('span', { class: 'note' }, 'Drag turns, with Shift it moves; the wheel magnifies.'));
  const box = el('div', { class: 'sheet space', id: 'space' });
  if (!view.empty) box.append(view.build());
  const legend = el('p', { class: 'note sheet-legend' }, ...view.legend(other ? { r: `${other.name} as chosen`, s: other.other } : {}));
  byId('view').replaceChildren(...(view.empty ? [] : [box, legend, looks]), bar, el('div', { id: 'clause' }));
  const tables = [motionTable('r', other ? `${other.name} as chosen` : 'Motions', lists.r, other ? lists.s : null)];
  if (other) tables.push(motionTable('s', `${other.name} = ${other.other}`, lists.s, lists.r));
  byId('steps').classList.toggle('one', !other);
  byId('steps').replaceChildren(...tables);
  stepped = { view, lists, slider, position, owner: 'r', at: 0 };
  // Whoever writes stays where the cursor is.
  const first = document.activeElement === byId('program') ? firstOf(cursorLine()) : 0;
  goTo('r', Math.max(first, 0));
}

// The first motion of a line of the program; -1: it has none.
const firstOf = (line) => stepped.lists.r.findIndex(({ b }) => b === line);

function goToLine(line) {
  if (!stepped || line === stepped.lists[stepped.owner][stepped.at].b) return;
  const first = firstOf(line);
  if (first >= 0) goTo('r', first);
}

function motionTable(owner, title, steps, against) {
  const rows = steps.slice(0, kMostRows).map((one, i) => el('tr', {
    'data-owner': owner, 'data-at': i, class: against && stepKey(one) !== stepKey(against[i]) ? 'differs' : null,
    on: { click: () => goTo(owner, i) },
  }, el('td', {}, one.b > 0 ? String(one.b) : ''), el('td', {}, one.text), el('td', { class: 'mono' }, one.clause)));
  return el('div', { class: `motions ${owner}`, tabindex: 0 }, el('h3', {}, title), ...partsOf(rows),
    steps.length > kMostRows && el('p', { class: 'note' }, `and ${steps.length - kMostRows} more`));
}

// Rows in tables of a hundred, of which the browser lays out those that are seen: two thousand rows in one
// took it a third of a second.
function partsOf(rows) {
  const parts = [];
  for (let i = 0; i < rows.length; i += kPart) {
    const some = rows.slice(i, i + kPart);
    parts.push(el('div', { class: 'part', style: `--rows: ${some.length}` }, el('table', {}, el('tbody', {}, ...some))));
  }
  return parts;
}

function goTo(owner, index) {
  const s = stepped;
  s.owner = owner;
  s.at = Math.min(Math.max(index, 0), s.lists[owner].length - 1);
  const now = s.lists[owner][s.at];
  s.slider.max = s.lists[owner].length - 1;
  s.slider.value = s.at;
  s.position.textContent = `record ${s.at + 1} of ${s.lists[owner].length}${now.b > 0 ? `, line ${now.b}` : ''}`;
  markLine(now.b);
  if (!s.view.empty) s.view.show(owner, s.at);
  byId('clause').replaceChildren(el('p', {}, now.text), ...[clauseNote(now.clause)].filter(Boolean));
  for (const row of byId('steps').querySelectorAll('tr.now')) row.classList.remove('now');
  byId('steps').querySelector(`tr[data-owner="${owner}"][data-at="${s.at}"]`)?.classList.add('now');
  for (const row of byId('steps').querySelectorAll(`tr[data-at="${s.at}"]`)) showRow(row);
}

// Within its list; the page stays where it is.
function showRow(row) {
  const list = row.closest('.motions');
  const [inner, outer] = [row.getBoundingClientRect(), list.getBoundingClientRect()];
  const head = list.querySelector('h3').offsetHeight;
  if (inner.top < outer.top + head || inner.bottom > outer.bottom) list.scrollTop += inner.top - outer.top - head - 60;
}

const step = (by) => stepped && goTo(stepped.owner, stepped.at + by);

document.addEventListener('keydown', (event) => {
  if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest('input, select, textarea, pre')) return;
  if (event.key === 'ArrowLeft') step(-1);
  else if (event.key === 'ArrowRight') step(1);
  else return;
  event.preventDefault();
});
