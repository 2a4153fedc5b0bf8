// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the views of a drawing sheet, laid out for the room that there is. A unit
// is a CSS pixel: strokes, texts and marks keep their size, however far a view is magnified, and its
// numbers are made anew.
'use strict';

const kRoom = { left: 58, right: 18, top: 34, bottom: 34 };  // about the field of a view, as on the sheet
const kFill = 0.86;          // of a field by what a view is fitted to
const kMostMagnified = 400;
const kMostFitted = 40;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const along = (at, direction, length) => at.map((value, i) => value + direction[i] * length);
const numbersIn = (text) => text.trim().split(/\s+/).map(Number);

function fieldOf({ x, y, width, height }) {
  const field = { x: x + kRoom.left, y: y + kRoom.top, width: width - kRoom.left - kRoom.right, height: height - kRoom.top - kRoom.bottom };
  return { ...field, middle: [field.x + field.width / 2, field.y + field.height / 2] };
}

// 1, 2 or 5 times a power of ten.
function niceStep(least) {
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5].find((factor) => factor * power >= least) ?? 10);
}

function stepLabel(value, step) {
  const text = value.toFixed(Math.min(12, Math.max(0, -Math.floor(Math.log10(step) + 1e-9))));
  return /[1-9]/.test(text) ? text.replace('-', '\u2212') : text.replace('-', '');
}

// One view: what moves and grows with it, what keeps its size at a place of it, and what stands at its frame.
class SheetView {
  constructor(node) {
    const [x, y, width, height] = numbersIn(node.dataset.frame);
    Object.assign(this, { node, key: node.dataset.view, drawn: { x, y, width, height }, from: fieldOf({ x, y, width, height }),
      right: numbersIn(node.dataset.right), up: numbersIn(node.dataset.up), middle: numbersIn(node.dataset.middle),
      scale: Number(node.dataset.scale), diameters: 'diameters' in node.dataset });
    this.isometric = this.right.filter((part) => part !== 0).length > 1;
    this.name = node.querySelector('.gs-name').textContent;
    this.takeApart();
  }

  takeApart() {
    const group = (css, ...nodes) => {
      const made = svgNode('g', css);
      made.append(...nodes);
      return made;
    };
    const children = [...this.node.children];
    const of = (...css) => children.filter((child) => css.some((one) => child.classList.contains(one)));
    const titleLine = String(this.drawn.y + 18);
    const [title, ...letters] = of('gs-name');
    const legend = [...of('gs-patch-cut', 'gs-patch-uncut', 'gs-patch-gouged'), ...of('gs-label').filter((label) => label.getAttribute('y') === titleLine)];
    this.planes = of('gs-plane').map((path) => this.plane(path));
    const planes = this.planes.flatMap(({ path, text }) => [path, text]);
    this.pinned = [...of('gs-start', 'gs-end', 'gs-witness'), ...of('gs-point').filter((text) => !planes.includes(text))].map((one) => ({ node: one, at: anchorOf(one) }));
    const heads = of('gs-head');
    const apart = new Set([title, ...letters, ...legend, ...planes, ...heads, ...this.pinned.map((pin) => pin.node), ...of('gs-label', 'gs-grid', 'gs-zero', 'gs-axis', 'gs-tip')]);
    this.numbers = group('gs-numbers');
    this.head = group('gs-title', title, ...legend);
    this.corner = group('gs-corner', ...of('gs-axis', 'gs-tip'), ...letters);
    this.content = group('gs-content', ...children.filter((child) => !apart.has(child)));
    this.clipped = group('gs-clipped', ...planes, this.content, ...heads, ...this.pinned.map((pin) => pin.node));
    this.clip = svgNode('clipPath', '');
    this.clip.id = `clip-${this.key}`;
    this.clip.append(svgNode('rect', ''));
    this.clipped.setAttribute('clip-path', `url(#${this.clip.id})`);
    this.node.replaceChildren(this.clip, this.numbers, this.clipped, this.head, this.corner);
  }

  // A plane that is seen as a line, and its name at the frame.
  plane(path) {
    const [, x, y, way] = /^M(\S+) ([^hv]+)([hv])/.exec(path.getAttribute('d'));
    const text = path.nextElementSibling;
    const level = way === 'h';
    const place = ['x', 'y'].map((name) => Number(text.getAttribute(name)));
    const aside = level ? this.from.x + this.from.width - place[0] : place[1] - this.from.y;
    return { path, text, level, at: [Number(x), Number(y)], aside, off: level ? place[1] - y : place[0] - x };
  }

  // Where a point of the machine lies on the sheet as it came.
  placeOnSheet(point) {
    return [this.from.middle[0] + (dot(this.right, point) - this.middle[0]) * this.scale,
      this.from.middle[1] - (dot(this.up, point) - this.middle[1]) * this.scale];
  }

  // From the sheet as it came to where it is seen.
  seen([x, y]) {
    return [this.field.middle[0] + (x - this.centre[0]) * this.by, this.field.middle[1] + (y - this.centre[1]) * this.by];
  }

  holds([x, y]) {
    const { field } = this;
    return x >= field.x && x <= field.x + field.width && y >= field.y && y <= field.y + field.height;
  }

  // Whether a box of the machine's points has room, at which magnification of the sheet as it came.
  fitting(points) {
    const places = points.map((point) => this.placeOnSheet(point));
    const span = [0, 1].map((i) => Math.max(...places.map((at) => at[i])) - Math.min(...places.map((at) => at[i])));
    return kFill * Math.min(this.field.width / span[0], this.field.height / span[1]);
  }

  set(frame) {
    this.frame = frame;
    this.field = fieldOf(frame);
    this.whole = Math.min(this.field.width / this.from.width, this.field.height / this.from.height);
  }

  draw(at, by) {
    this.by = by;
    this.centre = this.placeOnSheet(at);
    this.at = at;
    const [dx, dy] = this.seen([0, 0]);
    this.transform = `translate(${dx} ${dy}) scale(${by})`;
    this.content.setAttribute('transform', this.transform);
    const { field, frame, drawn } = this;
    for (const name of ['x', 'y', 'width', 'height']) this.clip.firstChild.setAttribute(name, field[name]);
    this.head.setAttribute('transform', `translate(${frame.x - drawn.x} ${frame.y - drawn.y})`);
    this.corner.setAttribute('transform', `translate(${frame.x + frame.width - drawn.x - drawn.width} ${frame.y - drawn.y})`);
    for (const { node, at: anchor } of this.pinned) {
      const [x, y] = this.seen(anchor);
      node.setAttribute('transform', `translate(${x - anchor[0]} ${y - anchor[1]})`);
    }
    for (const plane of this.planes) this.drawPlane(plane);
    if (!this.isometric) this.drawNumbers();
  }

  drawPlane({ path, text, level, at, aside, off }) {
    const { field } = this;
    const [x, y] = this.seen(at);
    path.setAttribute('d', level ? `M${field.x} ${y}h${field.width}` : `M${x} ${field.y}v${field.height}`);
    // As far along the line as on the sheet, which may be longer.
    const along = aside * Math.min(1, level ? field.width / this.from.width : field.height / this.from.height);
    const place = level ? [field.x + field.width - Math.max(4, along), y + off] : [x + off, field.y + Math.max(10, along)];
    text.setAttribute('x', place[0]);
    text.setAttribute('y', place[1]);
    if (text.hasAttribute('transform')) text.setAttribute('transform', `rotate(-90 ${place.join(' ')})`);  // upright
  }

  // Numbers of one direction, so far apart that no two of them meet.
  lines(direction, middle, length, least) {
    const axis = direction.findIndex((part) => part !== 0);
    const times = this.diameters && axis === 0 ? 2 : 1;
    const scale = this.scale * this.by;
    const made = (gap) => {
      const step = niceStep(times * gap / scale) / times;
      const half = length / 2 / scale;
      const first = Math.ceil((middle - half) / step);
      const found = [];
      for (let i = first; i * step <= middle + half && found.length < 60; ++i) {
        found.push({ offset: (i * step - middle) * scale, label: stepLabel(direction[axis] * i * step * times, step * times), zero: i === 0 });
      }
      return found;
    };
    const lines = made(58);
    const widest = Math.max(0, ...lines.map((line) => 6.6 * line.label.length + 8));
    return direction === this.right && widest > 58 ? made(widest) : lines;
  }

  drawNumbers() {
    const { field } = this;
    const d = { true: '', false: '' };
    const labels = [];
    const label = (x, y, anchor, words) => {
      const text = svgNode('text', 'gs-label');
      for (const [name, value] of [['x', x], ['y', y], ['text-anchor', anchor]]) text.setAttribute(name, value);
      text.textContent = words;
      labels.push(text);
    };
    for (const line of this.lines(this.right, dot(this.right, this.at), field.width)) {
      const x = field.middle[0] + line.offset;
      d[line.zero] += `M${x} ${field.y}v${field.height}`;
      label(x, field.y + field.height + 17, 'middle', line.label);
    }
    for (const line of this.lines(this.up, dot(this.up, this.at), field.height)) {
      const y = field.middle[1] - line.offset;
      d[line.zero] += `M${field.x} ${y}h${field.width}`;
      label(field.x - 6, y + 3.5, 'end', line.label);
    }
    const path = (css, way) => { const made = svgNode('path', css); made.setAttribute('d', way); return made; };
    const frame = `M${field.x} ${field.y}h${field.width}v${field.height}h${-field.width}Z`;
    this.numbers.replaceChildren(path('gs-grid', d.false + frame), path('gs-zero', d.true), ...labels);
  }
}

// What a mark that keeps its size stands at.
function anchorOf(node) {
  const of = (from, x, y, dx = 0, dy = 0) => [Number(from.getAttribute(x)) + dx, Number(from.getAttribute(y)) + dy];
  if (node.matches('circle')) return of(node, 'cx', 'cy');
  if (node.matches('rect')) return of(node, 'x', 'y', 3.5, 3.5);
  if (node.matches('text')) return numbersIn(node.dataset.at);  // names stand beside their points
  return of(node.querySelector('circle'), 'cx', 'cy');
}

// All views of a sheet, looking at one place of the machine: those of third angle at one scale.
class SheetViews {
  constructor(svg, layer, { views, redrawn }) {
    Object.assign(this, { svg, layer, views, redrawn, shown: null, isometric: 1 });
    this.flat = this.views.filter((view) => !view.isometric);
    const right = (box) => box.x + box.width;
    const bottom = (box) => box.y + box.height;
    const boxes = views.map((view) => view.drawn);
    this.area = { x: Math.min(...boxes.map((box) => box.x)), y: Math.min(...boxes.map((box) => box.y)) };
    this.area.width = Math.max(...boxes.map(right)) - this.area.x;
    this.area.height = Math.max(...boxes.map(bottom)) - this.area.y;
    this.middle = [0, 0, 0];
    for (const view of this.flat) {
      for (const [direction, at] of [[view.right, view.middle[0]], [view.up, view.middle[1]]]) {
        const axis = direction.findIndex((part) => part !== 0);
        this.middle[axis] = at / direction[axis];
      }
    }
    this.camera = { at: this.middle, by: 1 };
  }

  // Sets all views, or the one that is shown, into a box of pixels.
  layOut(width, height) {
    for (const one of [this.svg, this.layer]) {
      one.setAttribute('viewBox', `0 0 ${width} ${height}`);
      one.removeAttribute('width');
      one.removeAttribute('height');
    }
    const { area } = this;
    const [wide, high] = [width / area.width, height / area.height];
    for (const view of this.views) {
      const { x, y, width: w, height: h } = view.drawn;
      view.set(this.shown ? { x: 0, y: 0, width, height } : { x: (x - area.x) * wide, y: (y - area.y) * high, width: w * wide, height: h * high });
      view.node.style.display = view.seenNow = !this.shown || view === this.shown ? '' : 'none';
    }
    const common = Math.min(...this.inSight(this.flat).map((view) => view.whole));
    for (const view of this.flat) view.base = this.shown ? view.whole : common;
    for (const view of this.views) if (view.isometric) view.base = view.whole;
  }

  inSight(views = this.views) {
    const all = views.filter((view) => !this.shown || view === this.shown);
    return all.length > 0 ? all : views;
  }

  draw() {
    const { at, by } = this.camera;
    for (const view of this.views) view.draw(at, view.base * by * (view.isometric ? this.isometric : 1));
    this.redrawn();
  }

  lookAtAll() {
    this.isometric = 1;
    this.camera = { at: this.middle, by: 1 };
    this.draw();
  }

  // At a box of points, each direction from its middle.
  lookAt(points) {
    const ends = [Math.min, Math.max].map((end) => [0, 1, 2].map((i) => end(...points.map((point) => point[i]))));
    const corners = [...Array(8).keys()].map((corner) => [0, 1, 2].map((i) => ends[(corner >> i) & 1][i]));
    const fit = (views) => Math.min(kMostFitted, ...views.map((view) => view.fitting(corners) / view.base));
    const by = Math.max(1, fit(this.inSight(this.flat)));
    const space = this.views.filter((view) => view.isometric);
    this.isometric = space.length > 0 ? Math.max(1, fit(space)) / by : 1;
    this.camera = { at: by > 1 || this.isometric !== 1 ? ends[0].map((low, i) => (low + ends[1][i]) / 2) : this.middle, by };
    this.draw();
  }

  // About a point of the machine, which stays where it is.
  magnify(times, about = this.camera.at) {
    const by = Math.min(kMostMagnified, Math.max(1, this.camera.by * times));
    if (by === 1) return this.lookAtAll();
    const rest = this.camera.by / by;
    this.camera = { at: about.map((value, i) => value + (this.camera.at[i] - value) * rest), by };
    this.draw();
  }

  // The point of the machine under a place of a view, as deep as what is looked at.
  pointAt(view, place) {
    const pixels = view.scale * view.by;
    const [dx, dy] = place.map((value, i) => (value - view.field.middle[i]) / pixels);
    return along(along(this.camera.at, view.right, dx), view.up, -dy);
  }

  move(view, dx, dy) {
    const pixels = view.scale * view.by;
    this.camera.at = along(along(this.camera.at, view.right, -dx / pixels), view.up, dy / pixels);
    this.draw();
  }

  inSightOf(view, point) {
    return view.holds(view.seen(view.placeOnSheet(point)));
  }

  // So that a point of the machine is in sight.
  reveal(point) {
    if (this.inSight().some((view) => this.inSightOf(view, point))) return;
    this.camera.at = point;
    this.draw();
  }

  viewAt([x, y]) {
    return this.inSight().find(({ frame }) => x >= frame.x && x <= frame.x + frame.width && y >= frame.y && y <= frame.y + frame.height);
  }
}
