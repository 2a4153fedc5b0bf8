// SPDX-License-Identifier: GPL-3.0-or-later
//
// The playground: a program goes to the worker, what the reference says of it comes back and is shown:
// the path in space, each motion with its clause, what other readings would do, what is wrong.
'use strict';

const byId = (id) => document.getElementById(id);
const kPatience = 15000;  // ms that a program may run
const kMostRows = 2000;   // motions listed
const kMost = 200_000;    // records that a program may give
const kExample = 'G00 X130 Z5 M3 S500;\nG94 X0 Z0 F200;\nX120 Z-110 F300;\nG00 X120 Z0;\nG94 X108 Z-30 R-10;\nX60 R-50;\nM30;\n';

// ---- the worker ----

let worker = null;
let waiting = new Map();
let lastId = 0;

function moduleBytes() {
  const text = atob(byId('module').textContent.trim());
  return Uint8Array.from(text, (character) => character.charCodeAt(0));
}

function ask(message) {
  return new Promise((resolve, reject) => {
    const id = ++lastId;
    const timer = setTimeout(() => {
      stopWorker('The program was stopped: it ran longer than 15 seconds.');
    }, kPatience);
    waiting.set(id, { resolve, reject, timer });
    worker.postMessage({ id, ...message });
  });
}

function stopWorker(reason) {
  worker.terminate();
  worker = null;
  for (const { reject, timer } of waiting.values()) {
    clearTimeout(timer);
    reject(new Error(reason));
  }
  waiting = new Map();
}

// The catalog.
async function startWorker() {
  worker = new Worker(URL.createObjectURL(new Blob([byId('worker').textContent], { type: 'text/javascript' })));
  worker.onmessage = ({ data: { id, result, failure } }) => {
    const { resolve, reject, timer } = waiting.get(id);
    waiting.delete(id);
    clearTimeout(timer);
    if (failure) reject(new Error(failure));
    else resolve(result);
  };
  return ask({ bytes: moduleBytes() });
}

// ---- what is asked ----

let dialects = new Map();  // name -> { clauses: Map, readings: Map }
const chosen = new Map();  // reading -> value
let turn = 0;              // of the last run; older ones that come back late are dropped
let compared = null;       // [reading, value]

const here = () => dialects.get(byId('dialect').value);
const choices = (extra) => [...new Map([...chosen, ...(extra ? [extra] : [])])].map(([name, value]) => `${name}=${value}`);

async function answer(extra) {
  if (!worker) await startWorker();
  return ask({
    head: { dialect: byId('dialect').value, profile: byId('profile').value, readings: choices(extra), draw: true, most: kMost },
    program: byId('program').value,
  });
}

// What is asked, as the part of an address behind '#'; docs/dialects writes such links.
function asAddress() {
  const parts = new URLSearchParams({ dialect: byId('dialect').value, program: byId('program').value });
  if (byId('profile').value) parts.set('profile', byId('profile').value);
  for (const [name, value] of chosen) parts.append('reading', `${name}=${value}`);
  return `#${parts.toString().replaceAll('+', '%20')}`;
}

function readAddress() {
  const parts = new URLSearchParams(location.hash.slice(1));
  if (dialects.has(parts.get('dialect'))) byId('dialect').value = parts.get('dialect');
  byId('program').value = parts.get('program') ?? kExample;
  byId('profile').value = parts.get('profile') ?? '';
  chosen.clear();
  for (const choice of parts.getAll('reading')) {
    const at = choice.indexOf('=');
    chosen.set(choice.slice(0, at), choice.slice(at + 1));
  }
}

// ---- what is shown ----

function clauseNote(id) {
  const clause = here().clauses.get(id);
  if (!clause) return null;
  return el('p', { class: 'note' }, el('strong', { class: 'mono' }, id), ` ${clause.text} (${clause.source}; ${clause.level})`);
}

async function run() {
  const mine = ++turn;
  compared = null;
  byId('state').textContent = 'Running \u2026';
  byId('link').href = asAddress();
  try {
    const found = await answer();
    if (mine !== turn) return;
    byId('state').textContent = verdictOf(found);
    showMessages(found);
    showReadings(found);
    byId('records').textContent = found.records;
    byId('wire').hidden = found.records === '';
    showPaths(found, null);
    await showOthers(found, mine);
  } catch (error) {
    if (mine !== turn) return;
    byId('state').textContent = error.message;
    for (const id of ['said', 'others', 'path', 'wire']) byId(id).hidden = true;
  }
}

function verdictOf({ exit, steps, stopped }) {
  if (exit === 2) return 'Wrong use';
  if (stopped) return `It was stopped after ${kMost} records.`;
  const motions = steps.length;
  return `${['The program ends', 'An alarm ends it', '', 'Not covered from there on'][exit]}: ${motions} record${motions === 1 ? '' : 's'}`;
}

function showMessages({ messages }) {
  byId('said').hidden = messages === '';
  byId('messages').textContent = messages;
  const ids = new Set([...messages.matchAll(/, ([A-Z0-9]+-[A-Z0-9]+-\d+)\]$/gm)].map((match) => match[1]));
  byId('message-clauses').replaceChildren(...[...ids].map(clauseNote).filter(Boolean));
  // To the place in the program.
  byId('messages').onclick = () => {
    const place = /:(\d+):(\d+): /.exec(messages);
    if (!place) return;
    const lines = byId('program').value.split('\n').slice(0, Number(place[1]));
    const at = lines.slice(0, -1).reduce((sum, line) => sum + line.length + 1, 0) + Number(place[2]) - 1;
    byId('program').focus();
    byId('program').setSelectionRange(at, at + 1);
  };
}

function showReadings({ readings }) {
  const rows = readings.map(({ name, value }) => {
    const reading = here().readings.get(name);
    const values = [...new Set([...reading.alternatives, 'any', value])];
    const select = el('select', { 'data-reading': name, on: { change: (event) => {
      chosen.set(name, event.target.value);
      run();
    } } }, ...values.map((one) => el('option', { value: one, selected: one === value }, one === reading.default ? `${one} (default)` : one)));
    return el('label', { class: 'choice', title: reading.text }, el('span', {}, el('span', { class: 'mono' }, name), el('br'), el('span', { class: 'note' }, reading.text)), select);
  });
  byId('readings').replaceChildren(...(rows.length > 0 ? rows : [el('p', { class: 'note' }, 'None: every reading comes to the same.')]));
}

const stepKey = (step) => (step ? `${step.b} ${step.text}` : '');

// Where two runs part, in words; empty: nowhere.
function departure(base, other) {
  for (let i = 0; i < Math.max(base.steps.length, other.steps.length); ++i) {
    const [before, after] = [base.steps[i], other.steps[i]];
    if (stepKey(before) === stepKey(after)) continue;
    const line = after?.b || before?.b;
    return `${line ? `line ${line}: ` : ''}${after ? after.text : 'no more motion'}${before ? `, instead of ${before.text}` : ''}`;
  }
  return '';
}

// Each other value of each reading that the program asks for.
async function showOthers(base, mine) {
  const rows = [];
  for (const { name, value } of base.readings) {
    for (const other of here().readings.get(name).alternatives) {
      if (other === value) continue;
      const found = await answer([name, other]);
      if (mine !== turn) return;
      const parts = found.exit === 2 ? '' : departure(base, found);
      if (parts) rows.push({ name, other, found, parts });
    }
  }
  byId('others').hidden = base.readings.length === 0;
  const choose = (row, node) => {
    const again = compared === row;
    compared = again ? null : row;
    for (const one of byId('other-list').querySelectorAll('tr')) one.setAttribute('aria-selected', !again && one === node);
    showPaths(base, compared);
  };
  byId('other-list').replaceChildren(rows.length === 0 ? el('p', { class: 'note' }, 'No other reading changes what this program does.')
    : el('table', {}, el('thead', {}, el('tr', {}, el('th', {}, 'Reading'), el('th', {}, 'Value'), el('th', {}, 'What changes first'), el('th', {}))),
      el('tbody', {}, ...rows.map((row) => {
        const node = el('tr', {}, el('td', { class: 'mono' }, row.name), el('td', { class: 'mono' }, row.other), el('td', {}, row.parts),
          el('td', {}, el('button', { type: 'button', on: { click: () => choose(row, node) } }, 'Side by side')));
        return node;
      }))));
}

// ---- the path, motion by motion ----

let stepped = null;

function showPaths(base, other) {
  byId('path').hidden = !base.steps || base.steps.length === 0;
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
  byId('view').replaceChildren(...(view.empty ? [] : [box, looks]), bar, el('div', { id: 'clause' }));
  const tables = [motionTable('r', other ? `${other.name} as chosen` : 'Motions', lists.r, other ? lists.s : null)];
  if (other) tables.push(motionTable('s', `${other.name} = ${other.other}`, lists.s, lists.r));
  byId('steps').classList.toggle('one', !other);
  byId('steps').replaceChildren(...tables);
  stepped = { view, lists, slider, position, owner: 'r', at: 0 };
  goTo('r', 0);
}

function motionTable(owner, title, steps, against) {
  const rows = steps.slice(0, kMostRows).map((one, i) => el('tr', {
    'data-owner': owner, 'data-at': i, class: against && stepKey(one) !== stepKey(against[i]) ? 'differs' : null,
    on: { click: () => goTo(owner, i) },
  }, el('td', {}, one.b > 0 ? String(one.b) : ''), el('td', {}, one.text), el('td', { class: 'mono' }, one.clause)));
  return el('div', { class: `motions ${owner}`, tabindex: 0 }, el('h3', {}, title), el('table', {}, el('tbody', {}, ...rows)),
    steps.length > kMostRows && el('p', { class: 'note' }, `and ${steps.length - kMostRows} more`));
}

function goTo(owner, index) {
  const s = stepped;
  s.owner = owner;
  s.at = Math.min(Math.max(index, 0), s.lists[owner].length - 1);
  const now = s.lists[owner][s.at];
  s.slider.max = s.lists[owner].length - 1;
  s.slider.value = s.at;
  s.position.textContent = `record ${s.at + 1} of ${s.lists[owner].length}${now.b > 0 ? `, line ${now.b}` : ''}`;
  if (!s.view.empty) s.view.show(owner, s.at);
  byId('clause').replaceChildren(el('p', {}, now.text), ...[clauseNote(now.clause)].filter(Boolean));
  for (const row of byId('steps').querySelectorAll('tr.now')) row.classList.remove('now');
  byId('steps').querySelector(`tr[data-owner="${owner}"][data-at="${s.at}"]`)?.classList.add('now');
  for (const row of byId('steps').querySelectorAll(`tr[data-at="${s.at}"]`)) showRow(row);
}

// Within its list; the page stays where it is.
function showRow(row) {
  const list = row.closest('.motions');
  const top = row.offsetTop - list.querySelector('h3').offsetHeight;
  if (top < list.scrollTop || row.offsetTop + row.offsetHeight > list.scrollTop + list.clientHeight) list.scrollTop = top - 60;
}

const step = (by) => stepped && goTo(stepped.owner, stepped.at + by);

document.addEventListener('keydown', (event) => {
  if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest('input, select, textarea, pre')) return;
  if (event.key === 'ArrowLeft') step(-1);
  else if (event.key === 'ArrowRight') step(1);
  else return;
  event.preventDefault();
});

// ---- the beginning ----

(async () => {
  try {
    const catalog = await startWorker();
    const byKey = (list, key) => new Map(list.map((one) => [one[key], one]));
    dialects = new Map(catalog.map(({ name, clauses, readings }) => [name, { clauses: byKey(clauses, 'id'), readings: byKey(readings, 'name') }]));
    byId('dialect').append(...[...dialects.keys()].map((name) => el('option', { value: name }, name)));
    readAddress();
    byId('run').addEventListener('click', run);
    byId('dialect').addEventListener('change', () => { chosen.clear(); run(); });
    byId('link').addEventListener('click', () => { byId('link').href = asAddress(); });
    window.addEventListener('hashchange', () => { readAddress(); run(); });
    let pause = 0;
    for (const id of ['program', 'profile']) {
      byId(id).addEventListener('input', () => { clearTimeout(pause); pause = setTimeout(run, 400); });
    }
    await run();
  } catch (error) {
    byId('state').textContent = `The playground cannot run here: ${error.message}`;
  }
})();
