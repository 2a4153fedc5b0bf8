// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: what a drawing sheet looks at, the buttons about it and its legend.
'use strict';

const kNarrow = 600;      // pixels: narrower, one view is shown
const kStripHeight = 250;  // of a sheet, below its title block
const kApart = 60;        // pixels between what is due and what came, where the departure is magnified

// What the failing block does, without its approach: that is cut at the frame.
function pointsOfBlock(data, paths) {
  const points = [];
  for (const [path, records, departing] of [[paths.r, data.reference, data.wanted], [paths.s, data.trace, data.record]]) {
    const of = path.filter((_, i) => records[i]?.[1] === data.b);
    const first = of.findIndex((motion) => motion.points.length > 0 && !motion.rapid);
    of.forEach((motion, i) => {
      if (i >= first) points.push(...motion.points);
      else if (i === first - 1) points.push(motion.end);
    });
    if (path[departing]?.points.length > 0) points.push(path[departing].end);
  }
  if (points.length > 0 && data.at) points.push(data.at);
  return points;
}

// The view in which what is due and what came lie farthest apart.
function departureOf(data, paths, views) {
  if (!data.at) return null;
  const due = paths.r[data.wanted]?.end ?? data.at;
  const apart = (view) => Math.hypot(...[view.right, view.up].map((way) => dot(way, due) - dot(way, data.at)));
  const view = views.flat.reduce((best, one) => (apart(one) > apart(best) * 1.001 ? one : best));
  return { view, at: data.at, apart: apart(view) };
}

function showDeparture(views, { view, at, apart }, fit) {
  views.shown = view;
  fit();
  const pixels = apart * view.scale * view.base;
  const by = Math.max(views.camera.by * 2, pixels > 0.01 ? kApart / pixels : 8);
  views.camera = { at, by: Math.min(kMostMagnified, by) };
  views.draw();
}

// The room of the drawing: all that its column leaves of the window.
function sheetSize(box) {
  const width = Math.max(260, box.clientWidth);
  const drawn = box.closest('.drawn');
  const beside = [...drawn.children].filter((one) => one !== box).reduce((sum, one) => {
    const { marginTop, marginBottom } = getComputedStyle(one);
    return sum + one.offsetHeight + parseFloat(marginTop) + parseFloat(marginBottom);
  }, 0);
  const room = width < kNarrow ? innerHeight * 0.6 : innerHeight - beside - 24;
  return [width, Math.round(Math.max(260, Math.min(width * (width < kNarrow ? 1 : 0.7), room)))];
}

function sheetBox(svg, layer, data, redrawn) {
  const views = new SheetViews(svg, layer, { views: [...svg.querySelectorAll('[data-frame]')].map((node) => new SheetView(node)), redrawn });
  const paths = { r: pathOf(data.moves?.r), s: pathOf(data.moves?.s) };
  const box = el('div', { class: 'sheet', id: 'sheet' }, el('div', { class: 'layers' }, svg, layer));
  const points = pointsOfBlock(data, paths);
  const departure = departureOf(data, paths, views);
  const chooser = views.views.length > 1 && el('select', { id: 'sheet-view', 'aria-label': 'View', on: { change: (event) => show(event.target.value) } },
    el('option', { value: '' }, 'All views'), ...views.views.map((view) => el('option', { value: view.key }, view.name.split('  ')[0].toLowerCase())));
  const fit = () => {
    views.layOut(...sheetSize(box));
    if (chooser) chooser.value = views.shown?.key ?? '';
  };
  const lookAtBlock = () => (points.length > 0 ? views.lookAt(points) : views.lookAtAll());
  const narrow = () => box.clientWidth < kNarrow;
  const show = (key) => {
    views.shown = views.views.find((view) => view.key === key) ?? null;
    fit();
    lookAtBlock();
  };
  const usual = () => (narrow() ? (views.shown ?? departure?.view ?? views.views[0]) : null)?.key;
  const resized = () => { fit(); views.draw(); };
  const open = () => {
    show(usual());
    let width = box.clientWidth;
    new ResizeObserver(() => {
      if (!box.isConnected || box.clientWidth === width || box.clientWidth === 0) return;
      const was = width < kNarrow;
      width = box.clientWidth;
      if (was === narrow()) resized();
      else show(usual());
    }).observe(box);
  };
  const showAll = () => {
    views.shown = views.views.find((view) => view.key === usual()) ?? null;
    fit();
    views.lookAtAll();
  };
  const look = { all: showAll, block: points.length > 0 && (() => show(usual())),
    departure: departure && (() => showDeparture(views, departure, fit)),
    // About the departure as long as it is in sight.
    closer: (times) => views.magnify(times, departure && views.inSight().every((view) => views.inSightOf(view, departure.at)) ? departure.at : undefined) };
  listenToSheet(svg, views);
  return { views, box, paths, open, tools: zoomBar(views, chooser, look) };
}

function zoomBar(views, chooser, look) {
  const button = (id, label, title, act) => el('button', { type: 'button', id, title, on: { click: act } }, label);
  return el('div', { class: 'sheet-tools', role: 'group', 'aria-label': 'Magnify the drawing' }, chooser,
    button('zoom-in', '+', 'Magnify', () => look.closer(1.6)), button('zoom-out', '\u2212', 'Make smaller', () => look.closer(0.625)),
    look.departure && button('zoom-departure', 'Departure', 'Magnify the departure in the view where it shows', look.departure),
    look.block && button('zoom-block', 'Block', 'The block at fault', look.block),
    button('zoom-all', 'Whole', 'The whole path', look.all),
    el('span', { class: 'note' }, 'The wheel magnifies, a drag moves.'));
}

// The wheel magnifies about the pointer, a drag moves what is magnified.
function listenToSheet(svg, views) {
  const placeOf = (event) => {
    const box = svg.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  svg.addEventListener('wheel', (event) => {
    if (!event.ctrlKey && views.camera.by === 1 && event.deltaY > 0) return;  // the page scrolls on
    event.preventDefault();
    const place = placeOf(event);
    const view = views.viewAt(place);
    views.magnify(event.deltaY < 0 ? 1.25 : 0.8, view && views.pointAt(view, place));
  }, { passive: false });
  let drag = null;
  svg.addEventListener('pointerdown', (event) => {
    const view = views.viewAt(placeOf(event));
    drag = view && views.camera.by > 1 && event.pointerType !== 'touch' ? { view, last: placeOf(event), moved: 0 } : null;
  });
  svg.addEventListener('pointermove', (event) => {
    if (!drag || event.buttons === 0) return;
    const place = placeOf(event);
    const [dx, dy] = place.map((value, i) => value - drag.last[i]);
    drag = { ...drag, last: place, moved: drag.moved + Math.hypot(dx, dy) };
    views.move(drag.view, dx, dy);
  });
  // What was dragged is not chosen.
  svg.addEventListener('click', (event) => {
    if (drag?.moved > 4) event.stopImmediatePropagation();
    drag = null;
  });
  svg.addEventListener('pointerleave', () => { drag = null; });
}

// What stands below the title block of a sheet: motion beside motion, and a departure too small to be seen.
function stripOf(svg) {
  const parts = [...svg.querySelectorAll(':scope > [data-view=unfolded], :scope > .gs-inset')];
  if (parts.length === 0) return null;
  const [, , width, height] = numbersIn(svg.getAttribute('viewBox'));
  const strip = svgNode('svg', 'gs-sheet');
  strip.setAttribute('viewBox', `0 ${height - kStripHeight} ${width} ${kStripHeight}`);
  strip.append(...parts);
  return strip;
}

const kLegend = [['gs-r gs-feed', 'reference, feed'], ['gs-r gs-rapid', 'reference, rapid'], ['gs-r gs-thread', 'reference, thread'],
  ['gs-s gs-feed', 'subject, feed'], ['gs-s gs-rapid', 'subject, rapid'], ['gs-s gs-thread', 'subject, thread']];

// The legend of what is drawn; that of the sheet itself is for paper.
function sheetLegend(svg) {
  const lathe = svg.querySelector('[data-diameters]') !== null;
  return el('p', { class: 'note sheet-legend' },
    ...kLegend.filter(([css]) => svg.querySelector(`[data-view] .${css.replace(' ', '.')}`)).map(([css, words]) => legendEntry(css, words)),
    el('span', {}, `Millimetres${lathe ? ', X as a diameter' : ''}. Only the ends of rapids are specified.`));
}
