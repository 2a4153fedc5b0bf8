// SPDX-License-Identifier: MIT-0
//
// npm's gcode-preview, a viewer for 3D printing. Its parser and its path builder run here without
// the drawing; arcs come as chords. It knows no feeds and no dwells: F is read off the parsed
// words, because a record needs one; a dwell is not made up.
import { createRequire } from 'node:module';

import { serve } from '../gonogo_pipe.mjs';
import { isDecimal, kLookedAt, refusal } from './rs274_profile.mjs';

globalThis.self ??= globalThis;  // one of its packages looks for a browser when it is loaded
const require = createRequire(import.meta.url);
const { version } = require('gcode-preview/package.json');

let WebGLPreview;
let Parser;

// The constructor makes the parser, whose class is not exported, and fails later for want of a
// canvas.
function load() {
  ({ WebGLPreview } = require('gcode-preview/dist/gcode-preview.js'));
  class Headless extends WebGLPreview {
    set parser(parser) {
      Parser = parser.constructor;
    }

    get parser() {
      return undefined;
    }
  }
  try {
    new Headless({});
  } catch {
    // as expected
  }
  if (Parser === undefined) throw new Error('gcode-preview does not make its parser first');
}

// The path builder with nothing to draw on. `put` takes the end of each piece, in order.
function headless(at, put) {
  const preview = Object.create(WebGLPreview.prototype);
  const commands = [];
  const still = { extrusion: [], travel: [], z: 0, height: 0 };
  Object.defineProperties(preview, {
    layers: { value: [{ commands, height: 0 }] },
    state: { value: { x: 0, y: 0, z: 0, r: 0, e: 0, i: 0, j: 0, t: 0, ...at }, writable: true },
  });
  Object.assign(preview, {
    renderTravel: true, renderExtrusion: true, nonTravelmoves: [], startLayer: 0, inches: false,
    beyondFirstMove: false, doRenderExtrusion() {},
    addLineSegment(_layer, _from, to) { put(to); },
    addArcSegment(_layer, from, to, _extrusion, clockwise) {
      const chords = [];
      const layer = { ...still, travel: chords };
      WebGLPreview.prototype.addArcSegment.call(preview, layer, from, to, false, clockwise);
      for (let i = 3; i < chords.length; i += 6) {
        put({ x: chords[i], y: chords[i + 1], z: chords[i + 2] });
      }
    },
  });
  return { commands, render: () => preview.renderLayer(0) };
}

let start = {};

function configure(dialect, profile) {
  const refused = refusal(dialect, profile, { 'initial.x': isDecimal, 'initial.y': isDecimal,
    'initial.z': isDecimal, 'initial.f': isDecimal });
  const { x = 0, y = 0, z = 0, f = 0 } = profile.initial ?? {};
  start = { x: Number(x), y: Number(y), z: Number(z), f: Number(f) };
  return refused;
}

function run(program, emit) {
  const { f, ...at } = start;
  let feed = f;
  let rapid = false;
  const { commands, render } = headless(at, ({ x, y, z }) => {
    if (rapid) emit('rapid', { to: { x, y, z } });
    else emit('feed', { to: { x, y, z }, f: feed });
  });
  const parser = new Parser(0);
  for (const command of parser.lines2commands(program.toString('utf8').split('\n'))) {
    // The first word of a line is a command to it, never a parameter.
    const first = /^f(.+)$/.exec(command?.gcode ?? '')?.[1];
    feed = command?.params?.f ?? (isDecimal(first) ? Number(first) : feed);
    rapid = /^g0?0$/.test(command?.gcode ?? '');
    commands.splice(0, commands.length, command);
    render();
  }
}

await serve(() => {
  load();
  return {
    name: 'gcode-preview',
    version,
    dialects: { rs274: ['basic', 'arc', 'arc-r', 'helix'] },
    features: [],
    readings: kLookedAt,
    numeric: { kind: 'binary64', chord: '0.5' },
    configure,
    run,
  };
});
