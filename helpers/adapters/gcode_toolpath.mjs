// SPDX-License-Identifier: MIT-0
//
// npm's gcode-toolpath (cncjs). It hands out lines and arcs, no feeds, dwells, line numbers or
// errors. A record needs a feed, so F is read off the parsed words; a dwell is not made up.
import { createRequire } from 'node:module';

import { serve } from '../gonogo_pipe.mjs';
import { isDecimal, kLookedAt, refusal } from './rs274_profile.mjs';

const require = createRequire(import.meta.url);
const Toolpath = require('gcode-toolpath').default ?? require('gcode-toolpath');
const { version } = require('gcode-toolpath/package.json');

// In G18 and G19 the three points of an arc come with their axes turned: the plane's two first.
const kAxes = { G17: ['x', 'y', 'z'], G18: ['z', 'x', 'y'], G19: ['y', 'z', 'x'] };
const turned = (axes, point) =>
  ({ [axes[0]]: point.x, [axes[1]]: point.y, [axes[2]]: point.z });

// The last F of a line, in mm. RS274/NGC sets the feed before the units, wherever they stand.
function feedOf(words, units, feed) {
  for (const [letter, value] of words) {
    if (letter === 'F' && typeof value === 'number') feed = units === 'G20' ? value * 25.4 : value;
  }
  return feed;
}

let start = {};

function configure(dialect, profile) {
  const refused = refusal(dialect, profile, {
    'initial.x': isDecimal, 'initial.y': isDecimal, 'initial.z': isDecimal,
    'initial.f': isDecimal,
    'initial.plane': (plane) => plane in kAxes,
    units: (units) => units === 'mm' || units === 'inch',
  });
  const { x = 0, y = 0, z = 0, f = 0, plane = 'G17' } = profile.initial ?? {};
  start = {
    position: { x: Number(x), y: Number(y), z: Number(z) },
    modal: { plane, units: profile.units === 'inch' ? 'G20' : 'G21' },
    feed: Number(f),
  };
  return refused;
}

function run(program, emit) {
  let { feed } = start;
  let { units } = start.modal;
  let line = [];  // its feed is known when all its words are
  const toolpath = new Toolpath({
    position: start.position,
    modal: start.modal,
    addLine: ({ motion, feedmode }, _from, to) => {
      if (motion === 'G0') line.push(['rapid', { to }]);
      else line.push(['feed', { to, fm: feedmode === 'G95' ? 'rev' : undefined }]);
    },
    addArcCurve: ({ motion, plane, feedmode }, _from, to, centre) => {
      const axes = kAxes[plane];
      const c = { [axes[0]]: centre.x, [axes[1]]: centre.y };
      line.push(['arc', { plane, c, rot: motion === 'G2' ? -1 : 1, to: turned(axes, to),
        fm: feedmode === 'G95' ? 'rev' : undefined }]);
    },
  });
  toolpath.loadFromStringSync(program.toString('utf8'), ({ words }) => {
    feed = feedOf(words, units, feed);
    ({ units } = toolpath.getModal());
    for (const [kind, fields] of line) {
      emit(kind, kind === 'rapid' ? fields : { ...fields, f: feed });
    }
    line = [];
  });
}

await serve(() => ({
  name: 'gcode-toolpath',
  version,
  dialects: { rs274: ['basic', 'arc', 'arc-r', 'helix', 'planes'] },
  features: [],
  readings: kLookedAt,
  numeric: { kind: 'binary64' },
  configure,
  run,
}));
