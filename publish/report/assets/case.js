// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the evidence of the chosen case.
'use strict';


function showCase(c) {
  openCase = c;
  stepper = null;
  const block = byId(`d${c.index}`);
  const data = block ? unpack(block) : null;
  const place = shown.indexOf(c);
  const detail = byId('detail');
  detail.hidden = false;
  detail.replaceChildren(
    el('div', { class: 'detail-head' }, el('h2', {}, c.id), badge(c.verdict), el('span', { class: 'spring' }),
      el('button', { type: 'button', id: 'previous', disabled: place <= 0, on: { click: () => choose(place - 1, false) } }, 'Previous case'),
      el('button', { type: 'button', id: 'next', disabled: place < 0 || place + 1 >= shown.length, on: { click: () => choose(place + 1, false) } }, 'Next case')),
    ...(c.verdict !== 'advice' ? [] : [el('p', { class: 'note' }, 'An advice: no text of a manual states what was expected here, so this is no NO-GO.')]),
    el('p', { class: 'message' }, c.message || (decisionOf(c.verdict) === 'go' ? 'This case is GO.' : 'No message.')));
  if (data) showFailure(detail, c, data);
  else showPass(detail, c, passOf(c.index));
  detail.append(commandBox([c.id, data?.readings?.against].filter(Boolean), [c.verdict, data?.departure].includes('state-leak')));
  // Back leads from the first case to where it was chosen; stepping along the list leaves no trail.
  const hash = `#case=${encodeURIComponent(c.id)}`;
  if (location.hash === hash) return;
  if (location.hash.startsWith('#case=')) history.replaceState(null, '', hash);
  else history.pushState(null, '', hash);
}

function closeCase() {
  openCase = null;
  stepper = null;
  chosen = -1;
  byId('detail').hidden = true;
  byId('detail').replaceChildren();
  showRows();
}

// The rules of the acceptance relation.
const kRules = { R1: 'correspondence', R2: 'place', R3: 'label', R4: 'traverse', R5: 'event', R6: 'alarm', R7: 'silence', R8: 'free step' };

function clauseList(ids) {
  return ids.flatMap((id, i) => [i > 0 ? ', ' : '', el('span', { class: 'mono', title: clauseTitle(id) }, id)]);
}

// ---- a case that is GO, or was not judged: its program, its clauses, the path of the reference ----

// Many passes lie packed together; the pack that was opened last is kept.
const packs = [...document.querySelectorAll('script.passes')].map((node) => ({ node, first: Number(node.dataset.first), last: Number(node.dataset.last) }));
let openPack = null;

function passOf(index) {
  const pack = packs.find(({ first, last }) => index >= first && index <= last);
  if (!pack) return null;
  if (openPack?.pack !== pack) openPack = { pack, cases: unpack(pack.node) };
  return openPack.cases[index] ?? null;
}

function showPass(detail, c, data) {
  const facts = el('dl', { class: 'pairs' }, el('dt', {}, 'Dialect, cycle'), el('dd', {}, `${c.dialect}, ${c.cycle}`));
  if (data?.comment) facts.append(el('dt', {}, 'About'), el('dd', {}, data.comment));
  if (data?.profile && Object.keys(data.profile).length > 0) facts.append(el('dt', {}, 'Profile'), el('dd', { class: 'mono' }, JSON.stringify(data.profile)));
  const left = el('div', {}, facts, clauseTable(c.clauses));
  if (!data) {
    detail.append(left, el('p', { class: 'note' }, 'The program of this case is not in this page: only so many passes are. Run the command for this case to see it.'));
    return;
  }
  detail.append(el('div', { class: 'columns' }, left, programBox(data)));
  const space = data.moves ? spaceBox(data) : null;
  if (!space) return;
  detail.append(...space.nodes, motionTable(data, space.view));
}

function clauseTable(ids) {
  if (ids.length === 0) return el('p', { class: 'note' }, 'No clause.');
  return el('div', {}, el('h3', {}, 'Clauses'), el('dl', { class: 'pairs', id: 'case-clauses' }, ...ids.flatMap((id) => {
    const clause = catalog.get(id);
    return [el('dt', { class: 'mono' }, id), el('dd', {}, clause ? clause.text : 'not in the catalog',
      clause && el('div', { class: 'level' }, `${clause.source}; ${clause.level}`))];
  })));
}

// The reference's motions, each with its clause; a choice marks it in the drawing.
function motionTable(data, view) {
  const rows = data.motions.map(([kind, block, clause], index) => {
    const row = el('tr', { title: clause ? clauseTitle(clause) : null, on: { click: () => choose_(index) } }, el('td', {}, String(index + 1)),
      el('td', {}, kind), el('td', {}, block > 0 ? `line ${block}` : ''), el('td', { class: 'mono' }, clause));
    return row;
  });
  const choose_ = (index) => {
    rows.forEach((row, i) => row.classList.toggle('now', i === index));
    view.show('r', index);
    for (const line of document.querySelectorAll('#program .line')) line.classList.toggle('now', Number(line.dataset.n) === data.motions[index][1]);
  };
  return el('div', {}, el('h3', {}, 'Motions of the reference'), el('div', { class: 'scroll motions', tabindex: 0 }, el('table', { id: 'motions' },
    el('thead', {}, el('tr', {}, ...['', 'Motion', 'Line', 'Clause'].map((name) => el('th', { scope: 'col' }, name)))), el('tbody', {}, ...rows))));
}

function showFailure(detail, c, data) {
  const facts = el('dl', { class: 'pairs', id: 'told' });
  const fact = (name, ...value) => facts.append(el('dt', {}, name), el('dd', {}, ...value));
  if (data.comment) fact('About', data.comment);
  if (data.machine) fact('Machine', data.machine);
  if (data.inForce) fact('In force', data.inForce);
  if (data.steps) fact('Want and got', ...data.steps.split(' / ').flatMap((step, i) => [i > 0 ? el('br', {}) : '', step]));
  fact('Dialect, cycle', `${c.dialect}, ${c.cycle}`);
  if (c.clause) {
    const clause = catalog.get(c.clause);
    fact('Clause', el('strong', { class: 'mono' }, c.clause), clause ? ` ${clause.text} ` : ' not in the catalog',
      clause ? el('span', { class: 'level' }, `${clause.source}; ${clause.level}`) : null);
  }
  if (data.departure && c.verdict === 'xfail') fact('Fails with', el('span', { class: 'mono' }, data.departure), ' as it is known to');
  else if (data.departure) fact('Would be', el('span', { class: 'mono' }, data.departure), ' if a text stated it');
  if (data.rule) fact('Rule', el('span', { class: 'mono' }, data.rule), ` ${kRules[data.rule] ?? ''}`);
  if (data.gap) fact('Undecided for', el('span', { class: 'mono' }, data.gap));
  if (data.basis) fact('Stands on', { text: 'a text of the manual', derived: 'what follows from a text', silent: 'no text: our judgement' }[data.basis] ?? data.basis);
  if (c.clauses.length > 0) fact('Clauses of the case', ...clauseList(c.clauses));
  if (data.b !== undefined) fact('Block', `line ${data.b}${data.word ? `, word ${data.word}` : ''}`);
  if (data.record !== undefined) fact('Subject\u2019s record', `number ${data.record + 1}`);
  if (data.deviation) fact('Deviation', deviationText(data.deviation));
  if (data.witness) fact('Witness', pointText(data.witness));
  if (data.attempts > 1) fact('Attempts', String(data.attempts));
  const cause = summary.findings.find((finding) => finding.number === c.finding)?.causeText;
  if (cause) fact('Likely cause', cause);
  const told = el('div', { class: 'told' }, programBox(data), facts);
  if (data.reading) {
    told.append(el('p', { class: 'other' }, 'Under the reading ', el('strong', { class: 'mono' }, data.reading), ' the answer would be GO.'));
  }
  const drawn = el('div', { class: 'drawn' });
  detail.append(el('div', { class: data.svg ? 'case' : '' }, told, drawn));
  const wanted = [];
  if (data.want !== undefined || data.got !== undefined) {
    const cards = el('div', { class: 'records', id: 'want-got' }, recordCard('Want: the reference', 'reference', data.want, data.got),
      recordCard('Got: the subject', 'subject', data.got, data.want));
    wanted.push(el('h3', {}, 'Want and got'), cards);
  }
  // Beside the drawing, which stays in sight while they are read.
  const beside = el('div', { class: 'beside' });
  told.append(...wanted, beside, ...(data.times ? timesTable(data.times) : []));
  showDrawing({ drawn, beside, detail }, data);
  if (data.notes) detail.append(el('h3', {}, 'What the subject noted or wrote to stderr'), el('pre', { tabindex: 0 }, el('span', { class: 'line plain' }, data.notes)));
}

// ---- how long both sides take ----

const kTimeNames = { cuts: 'Cuts', dwells: 'Dwells', turns: 'Turns of the spindle', traverses: 'Traverses' };

function timesTable({ rows, leftOut }) {
  const parted = rows[0][2] !== '';
  const hinted = rows.some((row) => row[4] !== '');
  const heads = ['', 'Reference', ...(parted ? ['Reference, to the departure', 'Subject, to the departure'] : ['Subject, as far as it was read']),
    ...(hinted ? [''] : [])];
  const body = rows.map(([what, whole, due, got, hint]) => el('tr', {}, el('th', { scope: 'row' }, kTimeNames[what] ?? what),
    ...[whole, ...(parted ? [due] : []), got, ...(hinted ? [hint.trim()] : [])].map((cell) => el('td', {}, cell))));
  const notes = leftOut > 0 ? [el('p', { class: 'note' }, `Without ${counted(leftOut, 'motion', 'motions')} of rotary axes, or askew in space.`)] : [];
  return [el('h3', {}, 'Times'), el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Times' }, el('table', { id: 'times' },
    el('thead', {}, el('tr', {}, ...heads.map((head) => el('th', { scope: 'col' }, head)))), el('tbody', {}, ...body))), ...notes];
}

function pointText(point) {
  if (typeof point !== 'object') return String(point);
  return Object.entries(point).map(([axis, at]) => {
    const decimals = decimalText(at);
    return `${axis.toUpperCase()} ${decimals ? `${decimals} (exactly ${exactText(at)})` : exactText(at)}`;
  }).join('   ');
}

// Bytes that are not UTF-8 are most often a Chinese comment.
function programText(program) {
  if (typeof program === 'string') return [program, ''];
  const bytes = Uint8Array.from(atob(program.base64), (c) => c.charCodeAt(0));
  for (const label of ['utf-8', 'gb18030']) {
    try { return [new TextDecoder(label, { fatal: true }).decode(bytes), `Bytes shown as ${label.toUpperCase()}.`]; } catch { /* the next one */ }
  }
  return [new TextDecoder('iso-8859-1').decode(bytes), 'Bytes shown as ISO-8859-1.'];
}

const kProgramLines = 2000;

function programBox(data) {
  const box = el('div', {}, el('h3', { class: 'first' }, 'Program'));
  if (data.program === undefined) {
    box.append(el('p', { class: 'note' }, data.note ?? 'The results file holds no program for this case.'));
    return box;
  }
  const [text, encoding] = programText(data.program);
  const lines = text.split(/\r\n|\n|\r/);
  if (lines.length > 1 && lines.at(-1) === '') lines.pop();
  const first = lines.length <= kProgramLines ? 0 : Math.max(0, Math.min((data.b ?? 1) - kProgramLines / 2, lines.length - kProgramLines));
  const pre = el('pre', { id: 'program', tabindex: 0, 'aria-label': 'Program' });
  lines.slice(first, first + kProgramLines).forEach((line, i) => {
    const number = first + i + 1;
    pre.append(el('span', { class: number === data.b ? 'line at-fault' : 'line', 'data-n': number }, line));
  });
  box.append(pre);
  const notes = [encoding];
  if (lines.length > kProgramLines) notes.push(`Lines ${first + 1} to ${first + kProgramLines} of ${lines.length}.`);
  if (notes.some(Boolean)) box.append(el('p', { class: 'note' }, notes.filter(Boolean).join(' ')));
  requestAnimationFrame(() => {
    const fault = pre.querySelector('.at-fault');
    if (fault) pre.scrollTop = fault.offsetTop - pre.offsetTop - pre.clientHeight / 2;
  });
  return box;
}

// ---- the command that runs the case again ----

// A word for a shell.
const quoted = (word) => (/^[\w@%+=:,./-]+$/.test(word) ? word : `'${word.replaceAll("'", "'\\''")}'`);

// What contradicts another case is seen beside it.
const isFresh = (id) => id.startsWith('fresh.');
const commandLine = (ids) => (isFresh(ids[0]) ? summary.freshCommand : summary.command) + ids.map(quoted).join(' --case ');

// Alone, a case shows nothing of what an earlier one left behind.
function commandBox(ids, isLeak) {
  const pre = el('pre', { id: 'command', tabindex: 0 }, isLeak ? summary.runCommand : commandLine(ids));
  const button = el('button', { type: 'button', on: { click: async () => {
    try {
      await navigator.clipboard.writeText(pre.textContent);
      button.textContent = 'Copied';
    } catch {
      getSelection().selectAllChildren(pre);
    }
  } } }, 'Copy');
  return el('div', {}, el('h3', {}, isLeak ? 'Run all cases again, one after the other' : 'Run this case again'), el('div', { class: 'command' }, pre, button));
}
