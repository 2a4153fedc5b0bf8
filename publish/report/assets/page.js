// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page; the parts are joined into one script in the order of CMakeLists.txt.
// All data lies in the page as JSON; every string of it is untrusted and reaches the page as text
// only. The drawings are SVG made by the gauge, parsed as XML.
'use strict';

const byId = (id) => document.getElementById(id);
const json = (node) => JSON.parse(node.textContent);
const summary = json(byId('summary'));
const cases = [...document.querySelectorAll('script.rows')].flatMap(unpack)
  .map(([id, dialect, cycle, verdict, clause, message, clauses, finding], index) =>
    ({ id, dialect, cycle, verdict, clause, message, clauses, finding, index }));
const catalog = new Map(summary.catalog.map((clause) => [clause.id, clause]));
const header = summary.header;
const count = (n) => n.toLocaleString('en');
const counted = (n, one, many) => `${count(n)} ${n === 1 ? one : many}`;

const decisionOf = (verdict) => summary.decisions[verdict] ?? 'no-go';
const badge = (verdict) => el('span', { class: `badge ${decisionOf(verdict)}` }, verdict);
function clauseTitle(id) {
  const clause = catalog.get(id);
  return clause ? `${clause.text} (${clause.source}; ${clause.level})` : 'not in the catalog';
}

// ---- exact numbers ----

// "3 - 2 times the root of 5" without what is zero or one.
function rootText([a, b, c]) {
  const factor = b.replace('-', '');
  const root = `${factor === '1' ? '' : `${factor}\u00b7`}\u221a${c.includes('/') ? `(${c})` : c}`;
  if (a === '0') return b.startsWith('-') ? `\u2212${root}` : root;
  return `${a} ${b.startsWith('-') ? '\u2212' : '+'} ${root}`;
}

// As people write them; a quotient also as a decimal, which the gauge never computes with.
function exactText(value) {
  if (value && Array.isArray(value.root)) return rootText(value.root);
  if (value && Array.isArray(value.enclosure)) return `between ${value.enclosure.join(' and ')}`;
  if (typeof value === 'string') {
    const quotient = /^(-?\d+)\/(\d+)$/.exec(value);
    if (quotient) {
      return `${value} (\u2248 ${(Number(quotient[1]) / Number(quotient[2])).toPrecision(9)})`;
    }
    return value;
  }
  return JSON.stringify(value);
}

// A deviation; its exact value is a text even where it is a root or an enclosure.
function deviationText({ exact, mm }) {
  if (exact === mm) return `${mm} mm, exactly`;
  return `${mm} mm, exactly ${exactText(exact.startsWith('{') ? JSON.parse(exact) : exact)}`;
}

// With at most nine decimals, where its exact text is another: it may be long.
function decimalText(value) {
  let number = Number(value);
  if (value && Array.isArray(value.root)) {
    const [a, b, c] = value.root.map(quotient);
    number = a + b * Math.sqrt(c);
  } else if (value && Array.isArray(value.enclosure)) {
    number = quotient(value.enclosure[0]);
  } else if (typeof value === 'string') {
    number = quotient(value);
  }
  const text = number.toFixed(9).replace(/\.?0+$/, '');
  return text === value ? '' : text;
}

function quotient(text) {
  const [above, below] = text.split('/').map(Number);
  return below === undefined ? above : above / below;
}

const kFields = { k: 'kind', b: 'block', to: 'to', via: 'via', c: 'centre', f: 'feed', fm: 'feed mode',
  rot: 'turn', s: 'seconds', m: 'M', class: 'class', word: 'word', native: 'native' };

// A record or alarm as pairs of a name and a text.
function pairsOf(text) {
  let record;
  try { record = JSON.parse(text); } catch { return [['text', text]]; }
  if (record === null || typeof record !== 'object') return [['text', text]];
  const pairs = [];
  for (const [key, value] of Object.entries(record)) {
    const isPoint = value && typeof value === 'object' && !Array.isArray(value) && !value.root && !value.enclosure;
    if (isPoint) {
      for (const [axis, at] of Object.entries(value)) pairs.push([`${kFields[key] ?? key.replaceAll('_', ' ')} ${axis.toUpperCase()}`, exactText(at)]);
    } else if (key !== 'clause') {
      pairs.push([kFields[key] ?? key.replaceAll('_', ' '), exactText(value)]);
    }
  }
  return pairs;
}

function recordCard(title, owner, text, other, extra = []) {
  const card = el('div', { class: `record ${owner}` }, el('h4', {}, title));
  if (text === undefined) {
    card.append(el('p', { class: 'note' }, 'nothing here'));
    return card;
  }
  // Two records of one kind are compared value by value; of two kinds, the kind is what differs.
  const ours = pairsOf(text);
  const theirs = new Map(other === undefined ? [] : pairsOf(other));
  const comparable = theirs.get('kind') === new Map(ours).get('kind');
  const dl = el('dl', { class: 'pairs' });
  for (const [name, value] of ours) {
    const differs = theirs.size > 0 && (comparable || name === 'kind') && theirs.get(name) !== value;
    dl.append(el('dt', {}, name), el('dd', { class: differs ? 'differs' : null }, value));
  }
  card.append(dl, ...extra);
  return card;
}
