// SPDX-License-Identifier: GPL-3.0-or-later
//
// Part of the report's page: the paths in space, to be turned, moved and magnified. Orthographic, as
// SVG, so that colours and print follow the page.
'use strict';

const kUnit3d = 1e-4;  // mm of a number in the paths
const kView3d = { width: 1160, height: 620 };
const kMotionKinds = ['feed', 'rapid', 'thread'];

// Motions as lists of points; what does not move has none.
function pathOf(moves) {
  let at = [0, 0, 0];
  return (moves ?? []).map((move) => {
    if (move.length === 0) return { points: [], end: at };
    let i = 1;
    if (move[0] & 2) at = [move[i++] * kUnit3d, move[i++] * kUnit3d, move[i++] * kUnit3d];
    const points = [at];
    for (; i + 2 < move.length; i += 3) {
      at = [at[0] + move[i] * kUnit3d, at[1] + move[i + 1] * kUnit3d, at[2] + move[i + 2] * kUnit3d];
      points.push(at);
    }
    return { rapid: (move[0] & 1) === 1, kind: move[0] & 1 ? 'rapid' : move[0] & 4 ? 'thread' : 'feed', points, end: at };
  });
}

// Lines of two points along one axis that meet or lie on one another, as one line. The pecks of a deep hole
// are thousands of those, and dashing each took a browser half a second a picture.
function withoutOverlap(lines) {
  const kept = [];
  const spans = new Map();
  const whole = (point) => point.map((value) => Math.round(value / kUnit3d));
  for (const line of lines) {
    const [from, to] = [whole(line[0]), whole(line.at(-1))];
    const moved = [0, 1, 2].filter((i) => from[i] !== to[i]);
    if (line.length !== 2 || moved.length !== 1) {
      kept.push(line);
      continue;
    }
    const axis = moved[0];
    const key = from.map((value, i) => (i === axis ? '' : value)).join();
    if (!spans.has(key)) spans.set(key, { axis, lines: [] });
    spans.get(key).lines.push(from[axis] < to[axis] ? line : [line[1], line[0]]);
  }
  for (const { axis, lines: along } of spans.values()) {
    along.sort((a, b) => a[0][axis] - b[0][axis]);
    let last = null;
    for (const [low, high] of along) {
      if (!last || low[axis] > last[1][axis] + kUnit3d / 2) kept.push(last = [low, high]);
      else if (high[axis] > last[1][axis]) last[1] = high;
    }
  }
  return kept;
}

function limitOf({ kind, points, tool, axes }) {
  let at = [0, 0, 0];
  const line = [];
  for (let i = 0; i + 2 < points.length; i += 3) {
    at = [at[0] + points[i] * kUnit3d, at[1] + points[i + 1] * kUnit3d, at[2] + points[i + 2] * kUnit3d];
    line.push(at);
  }
  return { kind, line, tool, axes };
}

// Turned about the upright axis, then tilted; as third-angle views stand: right, up, to the viewer.
const kTurns = { front: [0, 0], top: [0, 90], side: [90, 0], isometric: [45, 35.264] };

class View3d {
  constructor(data) {
    this.lathe = data.lathe === true;
    this.paths = { r: pathOf(data.moves?.r), s: pathOf(data.moves?.s) };
    // What is drawn of each, by kind.
    this.lines = Object.fromEntries(Object.entries(this.paths).map(([owner, path]) => [owner, Object.fromEntries(kMotionKinds.map((kind) =>
      [kind, withoutOverlap(path.filter((motion) => motion.points.length > 0 && motion.kind === kind).map((motion) => motion.points))]))]));
    this.limits = (data.limits ?? []).map(limitOf);
    this.witness = data.at ?? null;
    this.hidden = new Set();
    this.now = null;
    this.fit();
    this.turn('isometric');
  }

  everyPoint() {
    return [...Object.values(this.paths).flatMap((path) => path.flatMap((motion) => motion.points)),
      ...this.limits.flatMap((limit) => limit.line), ...(this.witness ? [this.witness] : [])];
  }

  fit() {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (const point of this.everyPoint()) {
      for (let i = 0; i < 3; ++i) {
        low[i] = Math.min(low[i], point[i]);
        high[i] = Math.max(high[i], point[i]);
      }
    }
    this.empty = !Number.isFinite(low[0]);
    this.middle = this.empty ? [0, 0, 0] : low.map((value, i) => (value + high[i]) / 2);
    const span = this.empty ? 1 : Math.hypot(...low.map((value, i) => high[i] - value));
    this.scale = 0.86 * kView3d.height / Math.max(span, 1e-6);
    this.pan = [0, 0];
  }

  turn(name) {
    [this.yaw, this.pitch] = kTurns[name];
    // From the corner between right, front and top.
    if (name === 'isometric') this.yaw = 45;
  }

  // X, Y, Z of the machine as right, up, towards the viewer of the front view.
  axes([x, y, z]) {
    return this.lathe ? [z, x, y] : [x, z, -y];
  }

  place(point) {
    const [r, u, t] = this.axes(point.map((value, i) => value - this.middle[i]));
    return this.project(r, u, t).map((value, i) => (i === 0 ? kView3d.width / 2 : kView3d.height / 2) + value * this.scale * (i === 0 ? 1 : -1) + this.pan[i]);
  }

  project(r, u, t) {
    const [yaw, pitch] = [this.yaw, this.pitch].map((angle) => angle * Math.PI / 180);
    const right = r * Math.cos(yaw) - t * Math.sin(yaw);
    const depth = r * Math.sin(yaw) + t * Math.cos(yaw);
    return [right, u * Math.cos(pitch) - depth * Math.sin(pitch)];
  }

  line(points) {
    return points.map((point, i) => {
      const [x, y] = this.place(point);
      return `${i === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`;
    }).join('');
  }

  build() {
    this.svg = svgNode('svg', 'gs-sheet gs-3d');
    this.svg.setAttribute('viewBox', `0 0 ${kView3d.width} ${kView3d.height}`);
    this.svg.setAttribute('tabindex', '0');
    this.svg.setAttribute('role', 'img');
    this.svg.setAttribute('aria-label', 'The paths in space. Drag to turn, with Shift to move; the wheel magnifies.');
    this.strokes = {};
    for (const [name, css] of [['border', 'gs-border-line'], ['reach', 'gs-reach'],
      ...['r', 's'].flatMap((owner) => kMotionKinds.map((kind) => [`${owner} ${kind}`, `gs-${owner} gs-${kind}`])), ['rim', 'gs-now'], ['core', 'gs-now-core'], ['disc', 'gs-disc-3d'], ['axes', 'gs-axis']]) {
      this.strokes[name] = svgNode('path', css);
      this.svg.append(this.strokes[name]);
    }
    this.tool = svgNode('circle', 'gs-tool');
    this.tool.setAttribute('r', '5');
    this.ring = svgNode('g', 'gs-witness');
    const circle = svgNode('circle', '');
    circle.setAttribute('r', '9');
    this.ring.append(circle);
    this.letters = ['X', 'Y', 'Z'].map((letter) => {
      const node = svgNode('text', 'gs-name');
      node.textContent = letter;
      node.setAttribute('text-anchor', 'middle');
      return node;
    });
    this.svg.append(this.tool, this.ring, ...this.letters);
    this.listen();
    this.draw();
    return this.svg;
  }

  draw() {
    for (const owner of ['r', 's']) {
      for (const kind of kMotionKinds) {
        this.strokes[`${owner} ${kind}`].setAttribute('d', this.hidden.has(owner) ? ''
          : this.lines[owner][kind].map((line) => this.line(line)).join(''));
      }
    }
    for (const kind of ['border', 'reach']) {
      this.strokes[kind].setAttribute('d', this.limits.filter((limit) => limit.kind === kind).map((limit) => this.line(limit.line)).join(''));
    }
    this.ring.style.display = this.witness ? '' : 'none';
    if (this.witness) this.ring.setAttribute('transform', `translate(${this.place(this.witness).join(' ')})`);
    this.drawNow();
    this.drawAxes();
  }

  // The styles that are drawn, each with its words.
  legend(names = { r: 'reference', s: 'subject' }) {
    return ['r', 's'].flatMap((owner) => kMotionKinds.filter((kind) => this.lines[owner][kind].length > 0)
      .map((kind) => legendEntry(`gs-${owner} gs-${kind}`, names[owner] ? `${names[owner]}, ${kind}` : kind)));
  }

  // The motion that is stepped to, and the tool where it ends.
  show(owner, index) {
    this.now = [owner, index];
    this.drawNow();
  }

  drawNow() {
    const motion = this.now ? this.paths[this.now[0]][this.now[1]] : undefined;
    for (const name of ['rim', 'core']) this.strokes[name].setAttribute('d', motion ? this.line(motion.points) : '');
    this.tool.style.display = motion ? '' : 'none';
    this.strokes.disc.setAttribute('d', '');
    if (!motion) return;
    const [x, y] = this.place(motion.end);
    this.tool.setAttribute('cx', x);
    this.tool.setAttribute('cy', y);
    const pocket = this.limits.find((limit) => limit.tool > 0);
    if (pocket) this.strokes.disc.setAttribute('d', `${this.line(this.disc(motion.end, pocket))}Z`);
  }

  disc(middle, { tool, axes: [p, q] }) {
    return Array.from({ length: 48 }, (_, i) => {
      const point = [...middle];
      point[p] += tool * Math.cos(i * Math.PI / 24);
      point[q] += tool * Math.sin(i * Math.PI / 24);
      return point;
    });
  }

  drawAxes() {
    const [left, bottom, length] = [60, kView3d.height - 60, 34];
    let d = '';
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].forEach((axis, i) => {
      const [x, y] = this.project(...this.axes(axis));
      d += `M${left} ${bottom}l${x * length} ${-y * length}`;
      const seen = Math.hypot(x, y) > 0.1;
      this.letters[i].style.display = seen ? '' : 'none';
      this.letters[i].setAttribute('x', left + x * (length + 13));
      this.letters[i].setAttribute('y', bottom - y * (length + 13) + 4);
    });
    this.strokes.axes.setAttribute('d', d);
  }

  // About a point of the sheet, which stays where it is.
  magnify(by, at = [kView3d.width / 2, kView3d.height / 2]) {
    const scale = Math.min(Math.max(this.scale * by, 1e-4), 1e7);
    const factor = scale / this.scale;
    this.scale = scale;
    [kView3d.width / 2, kView3d.height / 2].forEach((middle, i) => {
      this.pan[i] = at[i] - middle - (at[i] - middle - this.pan[i]) * factor;
    });
    this.draw();
  }

  listen() {
    let last = null;
    this.svg.addEventListener('pointerdown', (event) => {
      last = [event.clientX, event.clientY];
      this.svg.setPointerCapture(event.pointerId);
    });
    this.svg.addEventListener('pointerup', () => { last = null; });
    this.svg.addEventListener('pointermove', (event) => {
      if (!last) return;
      const [dx, dy] = [event.clientX - last[0], event.clientY - last[1]];
      last = [event.clientX, event.clientY];
      this.drag(dx, dy, event.shiftKey || (event.buttons & 2) !== 0);
    });
    this.svg.addEventListener('contextmenu', (event) => event.preventDefault());
    this.svg.addEventListener('wheel', (event) => {
      event.preventDefault();
      const at = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      this.magnify(event.deltaY < 0 ? 1.25 : 0.8, [at.x, at.y]);
    }, { passive: false });
    this.svg.addEventListener('dblclick', () => this.reset());
  }

  drag(dx, dy, moves) {
    if (moves) {
      const wide = kView3d.width / Math.max(1, this.svg.getBoundingClientRect().width);
      this.pan = [this.pan[0] + dx * wide, this.pan[1] + dy * wide];
    } else {
      this.yaw = (this.yaw + dx * 0.5) % 360;
      this.pitch = Math.min(90, Math.max(-90, this.pitch + dy * 0.5));
    }
    this.draw();
  }

  reset(name = 'isometric') {
    this.fit();
    this.turn(name);
    this.draw();
  }
}

// A line of a style beside its words.
function legendEntry(css, words) {
  const line = svgNode('path', css);
  line.setAttribute('d', 'M2 6h44');
  const box = svgNode('svg', 'gs-sheet gs-swatch');
  box.setAttribute('viewBox', '0 0 48 12');
  box.setAttribute('aria-hidden', 'true');
  box.append(line);
  return el('span', {}, box, words);
}

// The view with its buttons.
function spaceBox(data) {
  const view = new View3d(data);
  if (view.empty) return null;
  const button = (label, title, act) => el('button', { type: 'button', title, on: { click: act } }, label);
  const switched = (owner, label) => view.paths[owner].some((motion) => motion.points.length > 0) && el('label', {}, el('input', {
    type: 'checkbox', checked: true, on: { change: (event) => {
      if (event.target.checked) view.hidden.delete(owner);
      else view.hidden.add(owner);
      view.draw();
    } } }), label);
  const bar = el('div', { class: 'stepper space-bar', role: 'group', 'aria-label': 'The view in space' },
    button('Front', 'Seen from the front', () => view.reset('front')), button('Top', 'Seen from above', () => view.reset('top')),
    button('Side', 'Seen from the right', () => view.reset('side')), button('Isometric', 'Seen from the corner', () => view.reset()),
    button('+', 'Magnify', () => view.magnify(1.6)), button('\u2212', 'Make smaller', () => view.magnify(0.625)),
    view.witness && button('Departure', 'Magnify the departure', () => {
      view.magnify(8, view.place(view.witness));
    }),
    switched('r', 'reference'), switched('s', 'subject'),
    el('span', { class: 'note' }, 'Drag turns, with Shift it moves; the wheel magnifies.'));
  const box = el('div', { class: 'sheet space', id: 'space' });
  box.append(view.build());
  return { view, nodes: [el('h3', {}, 'In space'), box, el('p', { class: 'note sheet-legend' }, ...view.legend()), bar] };
}
