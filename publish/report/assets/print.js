// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: on paper. After the summary each finding has a sheet of its own, with
// the evidence of its smallest case.
'use strict';

const kMostPrinted = 60;

function printedFinding(finding) {
  const c = cases.find((one) => one.id === finding.smallest.id);
  const block = c && byId(`d${c.index}`);
  if (!block) return null;
  const data = unpack(block);
  const clause = catalog.get(finding.clause);
  const facts = el('dl', { class: 'pairs' });
  const fact = (name, ...value) => facts.append(el('dt', {}, name), el('dd', {}, ...value));
  fact('Finding', `${counted(finding.cases, 'case', 'cases')}: ${Object.entries(finding.cycles).map(([cycle, n]) => `${cycle} ${count(n)}`).join(', ')}`);
  if (data.comment) fact('About', data.comment);
  if (data.machine) fact('Machine', data.machine);
  if (data.inForce) fact('In force', data.inForce);
  if (finding.cause) fact('Cause', finding.causeText);
  if (clause) fact('Clause', `${clause.id}: ${clause.text} (${clause.source})`);
  if (data.b !== undefined) fact('Line', String(data.b));
  if (data.deviation) fact('Deviation', deviationText(data.deviation));
  if (data.steps) fact('Want and got', data.steps);
  for (const [what, , due, got, hint] of data.times?.rows ?? []) {
    if (due !== '' && due !== got) fact(kTimeNames[what] ?? what, `${due} due up to here, ${got} got.${hint}`);
  }
  const page = el('section', { class: 'printed' }, el('h2', {}, finding.text),
    el('p', { class: 'message' }, `${c.id}: ${c.message}`), el('div', { class: 'columns' }, facts, printedProgram(data)));
  if (data.svg) {
    const sheet = el('div', { class: 'sheet' });
    const drawing = document.importNode(new DOMParser().parseFromString(data.svg, 'image/svg+xml').documentElement, true);
    drawing.setAttribute('preserveAspectRatio', 'xMidYMin');
    sheet.append(drawing);
    page.append(sheet);
  }
  return page;
}

// The lines about the one at fault: a page holds so many.
function printedProgram(data) {
  if (data.program === undefined) return el('p', { class: 'note' }, data.note ?? '');
  const lines = programText(data.program)[0].split(/\r\n|\n|\r/);
  const first = Math.max(0, Math.min((data.b ?? 1) - 8, lines.length - 14));
  const pre = el('pre', {});
  lines.slice(first, first + 14).forEach((line, i) => pre.append(
    el('span', { class: first + i + 1 === data.b ? 'line at-fault' : 'line', 'data-n': first + i + 1 }, line)));
  return pre;
}

function layOutForPrint() {
  if (byId('printed')) return;
  const findings = summary.findings;
  const box = el('div', { id: 'printed' });
  for (const finding of findings.slice(0, kMostPrinted)) {
    const page = printedFinding(finding);
    if (page) box.append(page);
  }
  if (findings.length > kMostPrinted) {
    box.append(el('p', { class: 'note' }, `${count(findings.length - kMostPrinted)} further findings are in the report's page.`));
  }
  byId('gaps').before(box);
  // Nobody can unfold paper.
  for (const details of document.querySelectorAll('#gaps details:not([open]), #headline details:not([open])')) {
    details.open = true;
    details.dataset.folded = '';
  }
}

function layOutForScreen() {
  if (location.hash === '#print') return;
  byId('printed')?.remove();
  for (const details of document.querySelectorAll('#gaps details[data-folded], #headline details[data-folded]')) {
    details.open = false;
    delete details.dataset.folded;
  }
}

addEventListener('beforeprint', layOutForPrint);
addEventListener('afterprint', layOutForScreen);
if (location.hash === '#print') layOutForPrint();
