// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the drawing sheet, motion by motion.
'use strict';


let stepper = null;

function numbersOf(ranges) {
  return ranges.split(' ').filter(Boolean).flatMap((range) => {
    const [from, to = from] = range.split('-').map(Number);
    return Array.from({ length: to - from + 1 }, (_, i) => from + i);
  });
}

// Each <path> holds many motions, one a subpath; taken apart once.
function strandsOf(svg) {
  return [...svg.querySelectorAll('path[data-m]')].map((node) => ({
    node, owner: node.dataset.p, view: node.closest('[data-view]').dataset.view,
    head: node.classList.contains('gs-head'), records: numbersOf(node.dataset.m),
    parts: node.getAttribute('d').split('M').slice(1).map((part) => `M${part}`),
  }));
}

// The sheet with its stepper in one box, what it shows of each step beside it, the view in space below.
function showDrawing({ drawn, beside, detail }, data) {
  if (!data.svg) {
    if (data.note && data.program !== undefined) detail.append(el('h3', {}, 'Drawing'), el('p', { class: 'note' }, data.note));
    return;
  }
  const parsed = new DOMParser().parseFromString(data.svg, 'image/svg+xml').documentElement;
  const svg = document.importNode(parsed, true);
  const strip = stripOf(svg);
  // The marks lie in a layer of their own, so that a step does not draw the paths again.
  const layer = svgNode('svg', 'gs-sheet gs-layer');
  layer.setAttribute('aria-hidden', 'true');
  const s = { data, svg, marks: new Map(), strands: [svg, strip].flatMap((one) => (one ? strandsOf(one) : [])),
    lists: { r: data.reference, s: data.trace }, owner: data.trace.length > 0 ? 's' : 'r', at: { r: 0, s: 0 }, upTo: false };
  s.last = { r: Math.max(0, s.lists.r.length - 1), s: Math.max(0, s.lists.s.length - 1) };
  indexParts(s);
  s.sheet = sheetBox(svg, layer, data, () => followViews(s));
  for (const view of s.sheet.views.views) addMarks(s, layer, view.key, view);
  if (strip) addMarks(s, strip, 'unfolded', null);
  stepper = s;
  for (const one of [svg, strip]) one?.addEventListener('click', (event) => pick(s, event));
  const space = data.moves ? spaceBox(data) : null;
  s.space = space?.view;
  drawn.append(el('h3', { class: 'first' }, 'Drawing'), s.sheet.tools, s.sheet.box, sheetLegend(svg), controls(s));
  beside.append(el('h3', {}, 'Stepped to'), el('div', { class: 'records', id: 'stepped' }));
  if (strip) detail.append(el('h3', {}, 'Motion beside motion'), el('div', { class: 'sheet strip', id: 'strip', tabindex: 0, role: 'region', 'aria-label': 'Motion beside motion' }, strip));
  detail.append(...(space?.nodes ?? []));
  for (const note of [data.referenceNote, data.traceNote, data.note,
    data.referenceCut && 'The reference\u2019s path is longer than what is shown.',
    data.traceCut && 'The subject\u2019s path is longer than what is shown.']) {
    if (note) detail.append(el('p', { class: 'note' }, note));
  }
  const departed = data.record !== undefined && data.record < s.lists.s.length;
  if (departed) goTo('s', data.record);
  else if (data.wanted !== undefined) goTo('r', data.wanted);
  else goTo(s.owner, s.owner === 's' ? s.last.s : 0);
  s.sheet.open();
}

// What is stepped to, in one view: the motion and the tool where it ends.
function addMarks(s, layer, key, view) {
  const mark = { view, rim: svgNode('path', 'gs-now'), core: svgNode('path', 'gs-now-core'), tool: svgNode('circle', 'gs-tool'), motion: svgNode('g', 'gs-moved') };
  mark.tool.setAttribute('r', '5');
  mark.motion.append(mark.rim, mark.core);
  const group = svgNode('g', 'gs-marks');
  group.dataset.marks = key;
  if (view) group.setAttribute('clip-path', `url(#${view.clip.id})`);
  group.append(mark.motion, mark.tool);
  layer.append(group);
  s.marks.set(key, mark);
}

// After the views have moved: marks, and arrowheads, which keep their size.
function followViews(s) {
  for (const [key, mark] of s.marks) {
    if (!mark.view) continue;
    mark.motion.setAttribute('transform', mark.view.transform);
    mark.tool.parentNode.style.display = mark.view.seenNow ? '' : 'none';
    placeTool(s, key, mark, s.at[s.owner]);
  }
  for (const strand of s.strands) if (strand.head) drawStrand(s, strand);
}

function drawStrand(s, strand) {
  const most = s.upTo ? s.at[strand.owner] : Infinity;
  const view = strand.head ? s.marks.get(strand.view)?.view : null;
  strand.node.setAttribute('d', strand.parts.filter((_, i) => strand.records[i] <= most).map((part) => (view ? headIn(view, part) : part)).join(''));
}

// An arrowhead moved with its tip, the second of its three corners.
function headIn(view, part) {
  const n = part.match(/-?[\d.]+/g).map(Number);
  const [x, y] = view.seen([n[2], n[3]]);
  const at = (i) => `${n[i] - n[2] + x} ${n[i + 1] - n[3] + y}`;
  return `M${at(0)}L${at(2)}L${at(4)}Z`;
}

function indexParts(s) {
  s.parts = new Map();
  for (const strand of s.strands) {
    if (strand.head) continue;
    strand.records.forEach((record, i) => s.parts.set(`${strand.view} ${strand.owner} ${record}`, strand.parts[i]));
  }
  // Place of each record within its block, to find its counterpart in the other path.
  s.keys = {};
  s.places = {};
  for (const owner of ['r', 's']) {
    const seen = new Map();
    s.keys[owner] = s.lists[owner].map(([, block]) => {
      seen.set(block, (seen.get(block) ?? 0) + 1);
      return `${block} ${seen.get(block)}`;
    });
    s.places[owner] = new Map(s.keys[owner].map((key, i) => [key, i]));
  }
}

function counterpart(s, owner, index) {
  if (owner === 's' && index === s.data.record && s.data.wanted !== undefined) return s.data.wanted;
  const other = owner === 'r' ? 's' : 'r';
  return s.places[other].get(s.keys[owner][index]);
}

function controls(s) {
  const radio = (owner, label) => el('label', {}, el('input', {
    type: 'radio', name: 'owner', value: owner, checked: s.owner === owner, disabled: s.lists[owner].length === 0,
    on: { change: () => goTo(owner, Math.min(s.at[owner], s.last[owner])) },
  }), label);
  const button = (id, label, title, step) => el('button', { type: 'button', id, title, on: { click: step } }, label);
  return el('div', { class: 'stepper', id: 'stepper', role: 'group', 'aria-label': 'Step through the motions' },
    el('fieldset', {}, el('legend', {}, 'Step the'), radio('r', 'reference'), radio('s', 'subject')),
    button('first', '|\u25c0', 'First record (Home)', () => goTo(s.owner, 0)),
    button('back', '\u25c0 Back', 'One record back (left arrow)', () => step(-1)),
    button('forward', 'Forward \u25b6', 'One record on (right arrow)', () => step(1)),
    button('last', '\u25b6|', 'Last record (End)', () => goTo(s.owner, s.last[s.owner])),
    s.data.record !== undefined && s.data.record <= s.last.s && button('departure', 'Departure', 'The record at fault', () => goTo('s', s.data.record)),
    timeline(s, el('input', { type: 'range', id: 'slider', min: 0, max: s.last[s.owner], step: 1, 'aria-label': 'Record',
      on: { input: (event) => goTo(s.owner, Number(event.target.value)) } })),
    el('output', { id: 'position', 'aria-live': 'polite' }),
    el('label', {}, el('input', { type: 'checkbox', id: 'up-to', on: { change: (event) => { s.upTo = event.target.checked; drawSteps(s); } } }), 'only up to here'),
    el('span', { class: 'note' }, el('kbd', {}, '\u2190'), ' ', el('kbd', {}, '\u2192')));
}

const step = (by) => stepper && goTo(stepper.owner, stepper.at[stepper.owner] + by);

function goTo(owner, index) {
  const s = stepper;
  s.owner = owner;
  s.at[owner] = Math.min(Math.max(index, 0), s.last[owner]);
  const other = owner === 'r' ? 's' : 'r';
  s.pair = counterpart(s, owner, s.at[owner]);
  if (s.pair !== undefined) s.at[other] = s.pair;
  for (const input of document.querySelectorAll('#stepper input[name=owner]')) input.checked = input.value === owner;
  const slider = byId('slider');
  slider.max = s.last[owner];
  slider.value = s.at[owner];
  slider.setAttribute('aria-valuetext', recordText(s, owner, s.at[owner]));
  if (s.timelineOf !== owner) drawTimeline(byId('timeline'), s.lists[owner], s.data.b, owner === 's' ? s.data.record : s.data.wanted);
  s.timelineOf = owner;
  const name = owner === 'r' ? 'reference' : 'subject';
  byId('position').textContent = s.lists[owner].length > 0 ? placeText(s, owner, s.at[owner]) : `${name}: no records`;
  byId('back').disabled = byId('first').disabled = s.at[owner] <= 0;
  byId('forward').disabled = byId('last').disabled = s.at[owner] >= s.last[owner];
  drawSteps(s);
  showRecords(s);
  const end = s.sheet.paths[owner][s.at[owner]]?.end;
  if (s.sheet.views.views[0].by && end) s.sheet.views.reveal(end);
}

function drawSteps(s) {
  const index = s.at[s.owner];
  for (const [view, mark] of s.marks) {
    const now = s.parts.get(`${view} ${s.owner} ${index}`) ?? '';
    mark.rim.setAttribute('d', now);
    mark.core.setAttribute('d', now);
    placeTool(s, view, mark, index);
  }
  s.space?.show(s.owner, index);
  if (!s.upTo && !s.wasUpTo) return;
  s.wasUpTo = s.upTo;
  for (const strand of s.strands) drawStrand(s, strand);
}

// Where the machine stands after the record: the end of the last motion so far.
function placeTool(s, key, { view, tool }, index) {
  let part = '';
  for (let i = index; part === '' && i >= 0; --i) part = s.parts.get(`${key} ${s.owner} ${i}`) ?? '';
  const end = /(-?[\d.]+) (-?[\d.]+)$/.exec(part);
  const known = end !== null && (!view || view.by !== undefined);
  tool.style.display = known ? '' : 'none';
  if (!known) return;
  const place = [Number(end[1]), Number(end[2])];
  const [x, y] = view ? view.seen(place) : place;
  tool.setAttribute('cx', x);
  tool.setAttribute('cy', y);
}

function showRecords(s) {
  const texts = {};
  for (const owner of ['r', 's']) {
    const known = owner === s.owner || s.pair !== undefined;
    texts[owner] = known ? s.lists[owner][s.at[owner]]?.[2] : undefined;
  }
  const card = (owner, title, css) => {
    const other = texts[owner === 'r' ? 's' : 'r'];
    const node = recordCard(`${title}${texts[owner] !== undefined ? `, record ${s.at[owner] + 1}` : ''}`, css, texts[owner], other, clauseOf(texts[owner]));
    node.classList.toggle('active', owner === s.owner);
    return node;
  };
  byId('stepped').replaceChildren(card('r', 'Reference', 'reference'), card('s', 'Subject', 'subject'));
  const block = s.lists[s.owner][s.at[s.owner]]?.[1];
  for (const line of document.querySelectorAll('#program .line')) line.classList.toggle('now', Number(line.dataset.n) === block);
}

function clauseOf(text) {
  const id = /"clause":"([^"]+)"/.exec(text ?? '')?.[1];
  if (!id) return [];
  return [el('p', { class: 'note' }, el('strong', { class: 'mono' }, id), ` ${catalog.get(id)?.text ?? ''}`)];
}

// A click in a view chooses the nearest motion, 14 pixels off at most.
function pick(s, event) {
  const svg = event.currentTarget;
  const inStrip = svg !== s.svg;
  const box = svg.getBoundingClientRect();
  const view = inStrip ? null : s.sheet.views.viewAt([event.clientX - box.left, event.clientY - box.top]);
  const matrix = (view ? view.content : svg).getScreenCTM();
  if (!matrix || (!view && !inStrip)) return;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  let best = { distance: 14 / matrix.a };
  for (const strand of s.strands) {
    if (strand.head || strand.view !== (view?.key ?? 'unfolded')) continue;
    strand.parts.forEach((part, i) => {
      const distance = distanceTo(part, at);
      if (distance < best.distance) best = { distance, owner: strand.owner, record: strand.records[i] };
    });
  }
  if (best.owner) goTo(best.owner, best.record);
}

function distanceTo(part, at) {
  const n = part.slice(1).split(/[L ]/).map(Number);
  let best = Infinity;
  for (let i = 0; i + 3 < n.length; i += 2) {
    const [dx, dy] = [n[i + 2] - n[i], n[i + 3] - n[i + 1]];
    const length = dx * dx + dy * dy;
    const share = length === 0 ? 0 : Math.min(1, Math.max(0, ((at.x - n[i]) * dx + (at.y - n[i + 1]) * dy) / length));
    best = Math.min(best, Math.hypot(n[i] + share * dx - at.x, n[i + 1] + share * dy - at.y));
  }
  return best;
}

document.addEventListener('keydown', (event) => {
  if (!stepper || event.altKey || event.ctrlKey || event.metaKey) return;
  if (event.target.closest('input, select, textarea, #list, pre')) return;
  if (event.key === 'ArrowLeft') step(-1);
  else if (event.key === 'ArrowRight') step(1);
  else if (event.key === 'Home' && event.target.closest('#stepper')) goTo(stepper.owner, 0);
  else if (event.key === 'End' && event.target.closest('#stepper')) goTo(stepper.owner, stepper.last[stepper.owner]);
  else return;
  event.preventDefault();
});
