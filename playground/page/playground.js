// SPDX-License-Identifier: GPL-3.0-or-later
//
// The playground: a program goes to the worker, what the reference says of it comes back and is shown:
// the path in space, each motion with its clause, what other readings would do, what is wrong.
'use strict';

const byId = (id) => document.getElementById(id);
const kPatience = 15000;  // ms that a program may run
const kMost = 200_000;    // records that a program may give

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
  const [first] = examples();
  byId('program').value = parts.get('program') ?? first.program;
  byId('profile').value = parts.get('profile') ?? (parts.has('program') ? '' : first.profile ?? '');
  chosen.clear();
  for (const choice of parts.getAll('reading')) {
    const at = choice.indexOf('=');
    chosen.set(choice.slice(0, at), choice.slice(at + 1));
  }
  showExamples();
}

// ---- examples ----

const examples = () => kExamples[byId('dialect').value];
const isShown = ({ program, profile }) => byId('program').value === program && byId('profile').value === (profile ?? '');

// Those of the dialect, with the one that is shown chosen.
function showExamples() {
  const at = examples().findIndex(isShown);
  byId('example').replaceChildren(...(at < 0 ? [el('option', { value: '' }, 'none of these:')] : []),
    ...examples().map(({ name }, i) => el('option', { value: i, selected: i === at }, name)));
}

function takeExample({ program, profile }) {
  byId('program').value = program;
  byId('program').scrollTop = 0;
  byId('profile').value = profile ?? '';
  chosen.clear();
  showExamples();
  run();
}

// A program of the reader's stays; an example makes way for one of the other dialect.
function changeDialect() {
  chosen.clear();
  if (Object.values(kExamples).flat().some(isShown)) return takeExample(examples()[0]);
  showExamples();
  return run();
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
    stepped = null;
    markLine(0);
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

// ---- the beginning ----

(async () => {
  try {
    const catalog = await startWorker();
    const byKey = (list, key) => new Map(list.map((one) => [one[key], one]));
    dialects = new Map(catalog.map(({ name, clauses, readings }) => [name, { clauses: byKey(clauses, 'id'), readings: byKey(readings, 'name') }]));
    byId('dialect').append(...[...dialects.keys()].map((name) => el('option', { value: name }, name)));
    readAddress();
    byId('run').addEventListener('click', run);
    byId('dialect').addEventListener('change', changeDialect);
    byId('example').addEventListener('change', () => takeExample(examples()[byId('example').value || 0]));
    onCursor(goToLine);
    byId('link').addEventListener('click', () => { byId('link').href = asAddress(); });
    window.addEventListener('hashchange', () => { readAddress(); run(); });
    let pause = 0;
    for (const id of ['program', 'profile']) {
      byId(id).addEventListener('input', () => {
        showExamples();
        clearTimeout(pause);
        pause = setTimeout(run, 400);
      });
    }
    await run();
  } catch (error) {
    byId('state').textContent = `The playground cannot run here: ${error.message}`;
  }
})();
