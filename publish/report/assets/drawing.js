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

// The sheet with its stepper in one box, what it shows of each step and the view in space in the other.
function showDrawing(drawn, detail, data) {
  if (!data.svg) {
    if (data.note && data.program !== undefined) detail.append(el('h3', {}, 'Drawing'), el('p', { class: 'note' }, data.note));
    return;
  }
  const parsed = new DOMParser().parseFromString(data.svg, 'image/svg+xml').documentElement;
  const svg = document.importNode(parsed, true);
  // The marks lie in a layer of their own, so that a step does not draw the paths again.
  const layer = svgNode('svg', 'gs-sheet gs-layer');
  layer.setAttribute('viewBox', svg.getAttribute('viewBox'));
  layer.setAttribute('aria-hidden', 'true');
  const marks = new Map();
  for (const view of svg.querySelectorAll('[data-view]')) {
    const mark = { rim: svgNode('path', 'gs-now'), core: svgNode('path', 'gs-now-core'), tool: svgNode('circle', 'gs-tool') };
    mark.tool.setAttribute('r', '5');
    const group = svgNode('g', 'gs-marks');
    group.dataset.marks = view.dataset.view;
    group.append(mark.rim, mark.core, mark.tool);
    layer.append(group);
    marks.set(view.dataset.view, mark);
  }
  const s = { data, svg, marks, strands: strandsOf(svg), lists: { r: data.reference, s: data.trace },
    owner: data.trace.length > 0 ? 's' : 'r', at: { r: 0, s: 0 }, upTo: false };
  s.last = { r: Math.max(0, s.lists.r.length - 1), s: Math.max(0, s.lists.s.length - 1) };
  indexParts(s);
  stepper = s;
  const sheet = el('div', { class: 'sheet', id: 'sheet' });
  sheet.append(el('div', { class: 'layers' }, svg, layer));
  svg.addEventListener('click', (event) => pick(s, event));
  const space = data.moves ? spaceBox(data) : null;
  s.space = space?.view;
  drawn.append(el('h3', { class: 'first' }, 'Drawing'), zoomBar(svg, layer), sheet, controls(s));
  detail.append(el('div', { class: 'records', id: 'stepped' }), ...(space?.nodes ?? []));
  for (const note of [data.referenceNote, data.traceNote, data.note,
    data.referenceCut && 'The reference\u2019s path is longer than what is shown.',
    data.traceCut && 'The subject\u2019s path is longer than what is shown.']) {
    if (note) detail.append(el('p', { class: 'note' }, note));
  }
  const departed = data.record !== undefined && data.record < s.lists.s.length;
  if (departed) goTo('s', data.record);
  else if (data.wanted !== undefined) goTo('r', data.wanted);
  else goTo(s.owner, s.owner === 's' ? s.last.s : 0);
}

// The sheet magnified and moved: its view box, and that of the layer with the marks.
function zoomBar(svg, layer) {
  const [, , width, height] = svg.getAttribute('viewBox').split(' ').map(Number);
  let box = { x: 0, y: 0, width, height };
  const set = (next) => {
    box = next;
    for (const one of [svg, layer]) one.setAttribute('viewBox', `${box.x} ${box.y} ${box.width} ${box.height}`);
  };
  // About a point of the sheet.
  const zoom = (by, x = box.x + box.width / 2, y = box.y + box.height / 2) => {
    const wide = Math.min(width, Math.max(width / 400, box.width / by));
    const factor = wide / box.width;
    const next = { width: wide, height: box.height * factor };
    next.x = Math.min(width - next.width, Math.max(0, x - (x - box.x) * factor));
    next.y = Math.min(height - next.height, Math.max(0, y - (y - box.y) * factor));
    set(next);
  };
  svg.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && box.width === width && event.deltaY > 0) return;  // the page scrolls on
    event.preventDefault();
    const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    zoom(event.deltaY < 0 ? 1.25 : 0.8, at.x, at.y);
  }, { passive: false });
  let last = null;
  svg.addEventListener('pointerdown', (event) => { last = box.width < width ? [event.clientX, event.clientY] : null; });
  for (const end of ['pointerup', 'pointerleave']) svg.addEventListener(end, () => { last = null; });
  svg.addEventListener('pointermove', (event) => {
    if (!last) return;
    const scale = box.width / Math.max(1, svg.getBoundingClientRect().width);
    const x = box.x - (event.clientX - last[0]) * scale;
    const y = box.y - (event.clientY - last[1]) * scale;
    last = [event.clientX, event.clientY];
    set({ ...box, x: Math.min(width - box.width, Math.max(0, x)), y: Math.min(height - box.height, Math.max(0, y)) });
  });
  const button = (id, label, title, act) => el('button', { type: 'button', id, title, on: { click: act } }, label);
  const witness = svg.querySelector('[data-view] .gs-witness circle');
  return el('div', { class: 'sheet-tools', role: 'group', 'aria-label': 'Magnify the drawing' },
    button('zoom-in', '+', 'Magnify', () => zoom(1.6)), button('zoom-out', '\u2212', 'Make smaller', () => zoom(0.625)),
    witness && button('zoom-departure', 'Departure', 'Magnify the departure', () => {
      set({ x: 0, y: 0, width, height });
      const [x, y] = ['cx', 'cy'].map((name) => Number(witness.getAttribute(name)));
      zoom(8, x, y);
    }),
    button('zoom-all', 'Whole sheet', 'The whole sheet', () => set({ x: 0, y: 0, width, height })),
    el('span', { class: 'note' }, 'The wheel magnifies, a drag moves what is magnified.'));
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
    el('input', { type: 'range', id: 'slider', min: 0, max: s.last[s.owner], step: 1, 'aria-label': 'Record',
      on: { input: (event) => goTo(s.owner, Number(event.target.value)) } }),
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
  const name = owner === 'r' ? 'reference' : 'subject';
  byId('position').textContent = s.lists[owner].length > 0 ? `${name} ${s.at[owner] + 1} of ${s.last[owner] + 1}` : `${name}: no records`;
  byId('back').disabled = byId('first').disabled = s.at[owner] <= 0;
  byId('forward').disabled = byId('last').disabled = s.at[owner] >= s.last[owner];
  drawSteps(s);
  showRecords(s);
}

function drawSteps(s) {
  const index = s.at[s.owner];
  for (const [view, mark] of s.marks) {
    const now = s.parts.get(`${view} ${s.owner} ${index}`) ?? '';
    mark.rim.setAttribute('d', now);
    mark.core.setAttribute('d', now);
    placeTool(s, view, mark.tool, index, now);
  }
  s.space?.show(s.owner, index);
  if (!s.upTo && !s.wasUpTo) return;
  s.wasUpTo = s.upTo;
  for (const strand of s.strands) {
    const most = s.upTo ? s.at[strand.owner] : Infinity;
    strand.node.setAttribute('d', strand.parts.filter((_, i) => strand.records[i] <= most).join(''));
  }
}

// Where the machine stands after the record: the end of the last motion so far.
function placeTool(s, view, tool, index, now) {
  let part = now;
  for (let i = index; part === '' && i >= 0; --i) part = s.parts.get(`${view} ${s.owner} ${i}`) ?? '';
  const end = /(-?[\d.]+) (-?[\d.]+)$/.exec(part);
  tool.style.display = end ? '' : 'none';
  if (!end) return;
  tool.setAttribute('cx', end[1]);
  tool.setAttribute('cy', end[2]);
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

// A click in a view chooses the nearest motion.
function pick(s, event) {
  const view = event.target.closest('[data-view]')?.dataset.view;
  const matrix = s.svg.getScreenCTM();
  if (!matrix) return;
  const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
  let best = { distance: 14 };
  for (const strand of s.strands) {
    if (strand.head || (view && strand.view !== view)) continue;
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
