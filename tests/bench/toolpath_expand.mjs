// SPDX-License-Identifier: GPL-3.0-or-later
//
// toolpath_expand.mjs PROGRAM: every line and arc that npm's gcode-toolpath makes of a program, one
// JSON object a line on standard output. For tests/bench/table.
import { createReadStream, writeSync } from 'node:fs';
import { createRequire } from 'node:module';

const require = createRequire(new URL('../../helpers/adapters/', import.meta.url));
const Toolpath = require('gcode-toolpath').default ?? require('gcode-toolpath');

let text = '';
function put(record) {
  text += JSON.stringify(record) + '\n';
  if (text.length < 65536) return;
  writeSync(1, text);
  text = '';
}

const toolpath = new Toolpath({
  addLine: ({ motion }, _from, to) => put({ k: motion === 'G0' ? 'rapid' : 'feed', to }),
  addArcCurve: ({ motion, plane }, _from, to, c) =>
    put({ k: 'arc', plane, c, rot: motion === 'G2' ? -1 : 1, to }),
});
toolpath.loadFromStream(createReadStream(process.argv[2]), (error) => {
  writeSync(1, text);
  if (error) process.exitCode = 1;
});
