// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: headline and totals, what was run, clauses and cycles, what was not
// checked.
'use strict';

// A line of some ten features is read at a glance; a longer one is folded under its short form.
const longestHead = 240;

function headLine(headline) {
  const whole = el('p', { class: 'head', id: 'head-line' }, headline.head);
  if (headline.head.length <= longestHead) return whole;
  return el('details', { class: 'head' }, el('summary', {}, headline.short), whole);
}

function showHeadline() {
  const { headline } = summary;
  const subject = header.subject ?? {};
  const tone = { GO: 'go', 'NO-GO': 'no-go' }[headline.decision] ?? 'undecided';
  const parts = [`${count(headline.judged)} of ${counted(headline.cases, 'case', 'cases')} judged`, `${count(headline.go)} GO`,
    `${count(headline.noGo)} NO-GO`];
  if (headline.known > 0) parts.push(`${count(headline.known)} known to fail`);
  if (headline.advices > 0) parts.push(counted(headline.advices, 'advice', 'advices'));
  if (headline.undecided > 0) parts.push(`${count(headline.undecided)} undecided`);
  if (headline.notClaimed > 0) parts.push(`${count(headline.notClaimed)} not claimed`);
  if (headline.notCovered > 0) parts.push(`${count(headline.notCovered)} not covered by the gauge`);
  if (summary.written) parts.push(`page of ${summary.written}`);
  const name = [subject.name, subject.version].filter(Boolean).join(' ') || subject.spec || '';
  const words = el('div', { class: 'words' },
    el('p', { class: 'subject' }, name), headLine(headline), el('p', { class: 'note' }, parts.join(' \u00b7 ')));
  if (headline.undecided > 0) {
    words.append(el('p', { class: 'note' },
      'Undecided: the gauge cannot say, so these cases count neither way.'));
  }
  byId('headline').replaceChildren(
    el('h1', { class: tone, id: 'decision' }, headline.decision), words);
  showCycles();
  if (headline.incomplete.length > 0) {
    byId('headline').append(el('div', { class: 'banner undecided', id: 'incomplete', role: 'alert' },
      el('strong', {}, headline.decision === 'UNDECIDED' ? 'This run decides nothing.' : 'This run is incomplete.'),
      el('ul', {}, ...headline.incomplete.map((reason) => el('li', {}, reason)))));
  }
  const broken = summary.scope.declared_but_skipped;
  if (broken.length > 0) {
    byId('headline').append(el('div', { class: 'banner no-go', id: 'declaration', role: 'alert' },
      el('strong', {}, 'The subject declares what it then skips, which makes the run NO-GO.'),
      el('ul', {}, ...broken.map((group) => el('li', {}, `${group.cycle} of ${group.dialect}, ${counted(group.cases, 'case', 'cases')}: ${group.reason}`)))));
  }
  const stale = summary.footer?.stale;
  if (Array.isArray(stale) && stale.length > 0) {
    byId('headline').append(el('div', { class: 'banner', id: 'stale', role: 'alert' },
      el('strong', {}, 'The subject\u2019s own files are stale, which makes the run NO-GO.'),
      el('ul', {}, ...stale.map((entry) => el('li', {}, String(entry))))));
  }
  document.title = `${headline.decision} \u2013 ${name || 'GoNoGo'} \u2013 GoNoGo report`;
}

// The cycles under the head line: those that fail, and the others, which fold.
function showCycles() {
  const { columns, used, rows, others, counting } = summary.scope.cycles;
  if (rows.length === 0) return;
  const shown = columns.map((name, i) => i).filter((i) => used[i]);
  const tableOf = (some) => table(['Cycle', ...shown.map((i) => columns[i])], some.map((row) => el('tr', {},
    el('th', { scope: 'row', class: 'mono' }, casesButton(row.name, () => { byId('by-cycle').value = row.cycle; })),
    ...shown.map((i) => el('td', { class: 'number' }, count(row.cases[i]))))));
  const failing = rows.filter((row) => row.cases[2] > 0);
  const further = rows.filter((row) => row.cases[2] === 0);
  byId('headline').append(el('div', { id: 'by-cycles' },
    failing.length > 0 && el('div', { class: 'fails' }, tableOf(failing)),
    further.length > 0 && el('details', { open: rows.length <= 20 },
      el('summary', {}, counted(further.length, 'cycle', 'cycles'), failing.length > 0 && ' without a NO-GO'), tableOf(further)),
    counting && el('p', { class: 'note' }, counting),
    others && el('p', { class: 'note' }, `Nothing judged: ${others}.`)));
}

function showTotals() {
  const rank = { 'no-go': 0, undecided: 1, neither: 2, go: 3 };
  const verdicts = Object.keys(summary.totals).sort((a, b) =>
    rank[decisionOf(a)] - rank[decisionOf(b)] || summary.totals[b] - summary.totals[a]);
  byId('totals').append(...verdicts.map((verdict) => el('button', {
    type: 'button', class: 'total', 'data-verdict': verdict, 'aria-pressed': 'false',
    on: { click: () => {
      byId('by-verdict').value = byId('by-verdict').value === verdict ? '' : verdict;
      applyFilters();
    } },
  }, badge(verdict), el('b', {}, count(summary.totals[verdict])))));
}

// ---- findings: what is not GO, each kind once ----

function showFindings() {
  const findings = summary.findings;
  byId('findings').hidden = findings.length === 0;
  if (findings.length === 0) return;
  const body = [];
  let cause = '';
  for (const finding of findings) {
    if ((finding.cause ?? '') !== cause) {
      body.push(el('tr', { class: 'cause' }, el('th', { colspan: 5, scope: 'rowgroup' },
        finding.cause ? finding.causeText : 'Cause not named')));
    }
    cause = finding.cause ?? '';
    body.push(findingRow(finding));
  }
  byId('findings').append(
    el('p', { class: 'note' }, `Cases that depart in the same way, the gravest first. ${counted(findings.length, 'finding', 'findings')}`,
      el('span', { class: 'on-screen' }, '; open the smallest case of one to see what it is'), '.'),
    table(['Finding', 'What the manual says', 'Cases', 'By cycle', 'Smallest'], body));
}

function findingRow(finding) {
  const clause = catalog.get(finding.clause);
  const cycles = Object.entries(finding.cycles).sort((a, b) => b[1] - a[1]);
  const verdicts = Object.entries(finding.verdicts);
  const badges = verdicts.flatMap(([verdict, n]) => [badge(verdict), verdicts.length > 1 ? ` ${count(n)} ` : ' ']);
  return el('tr', {}, el('th', { scope: 'row' }, ...badges, el('span', { class: 'mono' }, finding.clause),
    el('div', { class: 'level' }, finding.text.replace(/^[^(]*/, '').replace(/[()]/g, ''))),
  el('td', {}, clause ? clause.text : finding.smallest.message),
  el('td', {}, casesButton(count(finding.cases), () => { byId('by-finding').value = String(finding.number); })),
  el('td', {}, cycles.map(([cycle, n]) => `${cycle} ${count(n)}`).join(', ')),
  el('td', {}, el('a', { href: `#case=${encodeURIComponent(finding.smallest.id)}`, class: 'mono' }, finding.smallest.id),
    finding.smallest.blocks > 0 && `, ${counted(finding.smallest.blocks, 'block', 'blocks')}`,
    clause && el('div', { class: 'level' }, finding.smallest.message)));
}

// ---- what was run ----

function showRun() {
  const facts = byId('facts');
  const fact = (name, value, mono = false) => value && facts.append(el('dt', {}, name), el('dd', { class: mono ? 'mono' : null }, value));
  const subject = header.subject ?? {};
  const numeric = subject.numeric ?? {};
  fact('Subject', [subject.name, subject.version].filter(Boolean).join(' '));
  fact('Given as', subject.spec, true);
  fact('Numbers', Object.entries(numeric).map(([key, value]) => `${key.replace('_', ' ')} ${exactText(value)}`).join(', '));
  const dialects = subject.dialects;
  if (dialects !== undefined) {
    fact('Declares', dialects === null ? 'no dialects: what it skips it does not claim'
      : Object.entries(dialects).map(([dialect, features]) => `${dialect}: ${features.join(', ') || 'everything'}`).join('; '));
  }
  fact('Features', Array.isArray(subject.features) ? subject.features.join(', ') || 'none declared' : '');
  for (const one of header.capped ?? []) {
    fact('Not granted', `${one.what.replace('_', ' ')} ${exactText(one.declared)} of ${one.dialect}: ${exactText(one.counts)} counts`);
  }
  fact('Gauge', [`gonogo ${header.gonogo ?? '(version not given)'}`, header.gauge?.commit && `commit ${header.gauge.commit}`,
    header.gauge?.sha256 && `SHA-256 of the program ${header.gauge.sha256}`].filter(Boolean).join(', '));
  fact('Corpus', header.corpus ? `version ${header.corpus.version}, SHA-256 ${header.corpus.sha256}` : '');
  const profile = header.profile ?? {};
  fact('Profile', Object.keys(profile).length > 0 ? JSON.stringify(profile) : 'that of each case', Object.keys(profile).length > 0);
  if (Array.isArray(header.readings) && header.readings.length > 0) fact('Readings asked for', header.readings.join(', '), true);
  fact('Tolerance', header.tolerance != null ? `${exactText(header.tolerance)} mm, set by the certifier` : 'as the subject and the profile declare it');
  fact('Chord', header.chord != null ? `${exactText(header.chord)} mm` : 'none');
  if (header.feed_resolution != null) fact('Feed resolution', `${exactText(header.feed_resolution)}, set by the certifier`);
  if (header.blend != null) fact('Blend', `${exactText(header.blend)} mm, set by the certifier`);
  if (header.feed_tolerance != null) fact('Feed tolerance', `${exactText(header.feed_tolerance)} %, set by the certifier`);
  if (header.show_ids === true) fact('Names of cases', 'are told to the subject (--show-ids)');
  fact('Advices', header.strict ? 'are NO-GO (--strict)' : 'are listed, and are no NO-GO');
  fact('Seed, shard', `${header.seed ?? '?'}, ${header.shard ?? '?'}`);
  fact('Command', Array.isArray(header.argv) ? header.argv.map((word) => quoted(String(word))).join(' ') : '', true);
  if (summary.footer?.left_out > 0) fact('Left out', `${counted(summary.footer.left_out, 'case', 'cases')} that contradict the profile or the readings asked for`);
  fact('Judged', Object.entries(summary.judged).map(([dialect, n]) => `${dialect} ${count(n)}`).join(', '));
  fact('What passed follows', summary.follows);
  for (const [dialect, text] of Object.entries(summary.coordinates)) fact(`Coordinates of ${dialect}`, text);
  fact('Results SHA-256', summary.footer?.sha256, true);
}

// ---- clauses and cycles ----

const failingFirst = (all, fails) => [...all.filter(fails), ...all.filter((one) => !fails(one))];

function showMatrix() {
  const known = new Set(summary.catalog.map((clause) => clause.id));
  const strangers = Object.keys(summary.matrix).filter((id) => !known.has(id)).map((id) => ({ id, level: '', source: '', text: 'not in the catalog of this gauge' }));
  const all = [...summary.catalog, ...strangers];
  const hit = all.filter((clause) => summary.matrix[clause.id]).length;
  const words = [`${count(hit)} of ${count(all.length)} clauses were hit by a judged case; the others were not checked.`];
  if (summary.otherClauses > 0) words.push(`${count(summary.otherClauses)} clauses of other dialects are left out: no case of theirs was judged.`);
  // What departs stands first, row by row and column by column, in the order that it has.
  const departs = (id, cycle) => (summary.matrix[id]?.[cycle]?.[1] ?? 0) > 0;
  const cycles = failingFirst(summary.cycles, (cycle) => all.some((clause) => departs(clause.id, cycle)));
  const body = el('tbody');
  for (const clause of failingFirst(all, (one) => cycles.some((cycle) => departs(one.id, cycle)))) {
    const row = el('tr', {}, el('th', { scope: 'row', class: 'mono', title: clauseTitle(clause.id) }, clause.id),
      el('td', { class: 'text' }, clause.text, ' ', el('span', { class: 'level' }, clause.level)));
    const cells = summary.matrix[clause.id];
    if (!cells) row.append(el('td', { class: 'unhit', colspan: cycles.length || 1 }, 'not checked'));
    else for (const cycle of cycles) row.append(matrixCell(clause, cycle, cells[cycle]));
    body.append(row);
  }
  byId('matrix').append(el('p', { class: 'note' }, words.join(' ')),
    el('p', { class: 'note' }, '\u2713 passed, \u2717 departed at this clause, ? undecided, + departed at another clause, failed as expected, or an advice. Choose a cell to see its cases.'),
    el('div', { class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Matrix' }, el('table', {},
      el('thead', {}, el('tr', {}, el('th', { scope: 'col' }, 'Clause'), el('th', { scope: 'col' }, 'What it says'),
        ...cycles.map((cycle) => el('th', { scope: 'col' }, cycle)))), body)));
}

function matrixCell(clause, cycle, cell) {
  if (!cell) return el('td', { class: 'cell', title: clauseTitle(clause.id) }, '');
  const [passed, failed, undecided, elsewhere] = cell;
  const parts = [passed && `\u2713${count(passed)}`, failed && `\u2717${count(failed)}`, undecided && `?${count(undecided)}`, elsewhere && `+${count(elsewhere)}`];
  const tone = failed ? 'no-go' : undecided ? 'undecided' : passed ? 'go' : 'plain';
  const label = `${clause.id} ${cycle}: ${passed} passed, ${failed} departed here, ${undecided} undecided, ${elsewhere} departed elsewhere`;
  return el('td', { class: 'cell', 'data-cycle': cycle }, el('button', { type: 'button', class: tone, title: `${clauseTitle(clause.id)}\n${label}`, 'aria-label': label,
    on: { click: () => {
      byId('filters').reset();
      byId('by-clause').value = clause.id;
      byId('by-cycle').value = cycle;
      setTimeout(() => {
        byId('by-clause').value = clause.id;
        byId('by-cycle').value = cycle;
        applyFilters();
        byId('cases').scrollIntoView();
        list.focus({ preventScroll: true });
      }, 1);
    } } }, parts.filter(Boolean).join(' ')));
}

// ---- advices, and what the subject does not claim ----

// A button that shows the cases of a filter in the list.
function casesButton(label, set) {
  return el('button', { type: 'button', on: { click: () => {
    byId('filters').reset();
    setTimeout(() => {
      set();
      applyFilters();
      byId('cases').scrollIntoView();
      list.focus({ preventScroll: true });
    }, 1);
  } } }, label);
}

function table(columns, body) {
  return el('div', { class: 'scroll', tabindex: 0 }, el('table', {},
    el('thead', {}, el('tr', {}, ...columns.map((name) => el('th', { scope: 'col' }, name)))), el('tbody', {}, ...body)));
}

function showAdvices() {
  const groups = summary.scope.advices;
  byId('advices').hidden = groups.length === 0;
  if (groups.length === 0) return;
  byId('advices').append(
    el('p', { class: 'note' }, 'The subject departs from what the gauge expects, but no text of a manual states the expectation: it is our judgement alone. An advice counts neither for nor against the subject.',
      el('span', { class: 'on-screen' }, ' Choose one to see its program, its path and the exact numbers.')),
    table(['Clause', 'What is expected', 'Would be', 'Cases'], groups.map((group) => el('tr', {},
      el('th', { scope: 'row', class: 'mono', title: clauseTitle(group.clause) }, group.clause || 'no clause'),
      el('td', {}, catalog.get(group.clause)?.text ?? ''), el('td', { class: 'mono' }, group.departure),
      el('td', {}, casesButton(counted(group.cases, 'case', 'cases'), () => {
        byId('by-verdict').value = 'advice';
        byId('by-clause').value = group.clause;
      }))))));
}

// Feature by feature, each with what the dialects have of it.
function showNotClaimed() {
  const groups = summary.scope.not_claimed;
  byId('not-claimed').hidden = groups.length === 0;
  if (groups.length === 0) return;
  const features = new Map();
  for (const group of groups) {
    const key = group.feature ?? '';
    features.set(key, [...(features.get(key) ?? []), group]);
  }
  const names = [...features.keys()].sort((a, b) => (a === '') - (b === '') || a.localeCompare(b, 'en', { numeric: true }));
  byId('not-claimed').append(
    el('p', { class: 'note' }, `The subject does not say that it has these: ${counted(summary.headline.notClaimed, 'case of them was', 'cases of them were')} not judged. The decision says nothing of them.`),
    table(['Feature', 'Of', 'Cases'], names.map((name) => el('tr', {},
      el('th', { scope: 'row', class: name ? 'mono' : null }, name || 'for other reasons'),
      el('td', {}, ...features.get(name).map((group) => el('div', {}, skippedButton(group), group.feature ? null : ` ${group.reason ?? 'no reason given'}`))),
      el('td', {}, count(features.get(name).reduce((sum, group) => sum + group.cases, 0)))))));
}

function skippedButton(group) {
  return casesButton(`${group.dialect} ${count(group.cases)}`, () => {
    byId('by-verdict').value = 'skip';
    byId('by-dialect').value = group.dialect;
    byId('search').value = group.feature ? `declare ${group.feature} in` : (group.reason ?? '');
  });
}

// ---- what this run did not check ----

function showGaps() {
  const gaps = summary.notChecked;
  const items = el('ul');
  const item = (...parts) => items.append(el('li', {}, ...parts));
  item('The way of a rapid between its ends: controllers differ in it, so only the end is judged, and that every axis runs monotonically.');
  if (gaps.m) item('M functions: the subject does not declare the feature ', el('code', {}, 'm'), '.');
  if (gaps.blocks) item('The block that a motion comes from: the subject does not declare the feature ', el('code', {}, 'blocks'), '.');
  const unhit = summary.catalog.filter((clause) => !summary.matrix[clause.id]);
  if (unhit.length > 0) {
    item(`${counted(unhit.length, 'clause', 'clauses')} that no judged case hit.`, el('details', {}, el('summary', {}, 'Which'),
      el('ul', { class: 'codes' }, ...unhit.map((clause) => el('li', {}, el('strong', { class: 'mono' }, clause.id), ` ${clause.text}`)))));
  }
  if (gaps.open.length > 0) {
    item(`Other readings of ${counted(gaps.open.length, 'clause', 'clauses')} that the manuals leave open: the judge followed the reading named here.`, el('details', {}, el('summary', {}, 'Which'),
      el('ul', {}, ...gaps.open.map(openClause))));
  }
  for (const [dialect, codes] of Object.entries(gaps.outside)) {
    item(`${dialect}: ${counted(codes.length, 'code', 'codes')} that the maker has and the gauge does not read; a case that comes to one ends there.`,
      el('details', {}, el('summary', {}, 'Which'), el('ul', { class: 'codes' }, ...codes.map((code) =>
        el('li', {}, el('strong', { class: 'mono' }, code.code), code.title ? ` ${code.title}` : '')))));
  }
  if (summary.headline.undecided > 0) item(`${counted(summary.headline.undecided, 'case', 'cases')} that the gauge could not decide.`);
  byId('gaps').append(items);
}

function openClause({ clause, readings }) {
  const node = el('li', {}, el('strong', { class: 'mono' }, clause), ` ${catalog.get(clause)?.text ?? ''}`);
  if (readings.length > 0) {
    node.append(el('ul', {}, ...readings.map((reading) => el('li', {}, el('span', { class: 'mono' }, `${reading.name} = ${reading.value}`),
      ` ${reading.default ? '(default)' : '(set by the certifier)'}: ${reading.text}`))));
  }
  return node;
}
