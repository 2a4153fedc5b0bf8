// SPDX-License-Identifier: MIT-0
//
// A subject in JavaScript, in doubles. It expands straight lines of RS274: G0 and G1 with X, Y and
// Z, F, G20 and G21, G90 and G91, M2 and M30; the rest it skips.
import { alarm, serve, skip } from './gonogo_pipe.mjs';

const kWord = /([A-Z])([-+]?(?:\d+\.?\d*|\.\d+))/y;
const kGroups = { 0: 'motion', 1: 'motion', 20: 'unit', 21: 'unit', 90: 'distance', 91: 'distance' };

class Alarm {
  constructor(cls, word) { Object.assign(this, { cls, word }); }
}
class NotSupported {
  constructor(feature) { this.feature = feature; }
}

// The words of one line as [letter, number], blanks dropped and in upper case.
function wordsOf(line) {
  const text = line.replace(/[ \t]/g, '').toUpperCase();
  const words = [];
  for (kWord.lastIndex = 0; kWord.lastIndex < text.length;) {
    const at = kWord.lastIndex;
    const word = kWord.exec(text);
    const isRead = word && 'NGXYZFM'.includes(word[1]) && (word[1] !== 'N' || /^\d+$/.test(word[2]));
    if (!isRead) throw new NotSupported(text[at]);
    words.push([word[1], Number(word[2])]);
  }
  return words;
}

class Machine {
  modes = { motion: null, unit: 21, distance: 90 };
  at = { X: 0, Y: 0, Z: 0 };
  feed = 0;

  // Executes one line; true at the end of the program.
  block(line, b, emit) {
    const values = {};
    const groups = {};
    const feedUnit = this.unit();  // F counts in the unit before the block
    for (const [letter, number] of wordsOf(line)) {
      if (letter === 'G' && !(number in kGroups)) throw new NotSupported(`G${number}`);
      const [seen, key] = letter === 'G' ? [groups, kGroups[number]] : [values, letter];
      const inside = Object.keys({ ...values, ...groups }).length > 0;
      if ((letter === 'M' && ![2, 30].includes(number)) || (letter === 'N' && inside)) {
        throw new NotSupported(letter);
      }
      if (key in seen) throw new Alarm('duplicate-word', letter);
      seen[key] = number;
    }
    Object.assign(this.modes, groups);
    if (values.F !== undefined) this.feed = values.F * feedUnit;
    if (this.feed < 0) throw new Alarm('value-sign', 'F');
    const axes = ['X', 'Y', 'Z'].filter((axis) => axis in values);
    if (axes.length > 0 || 'motion' in groups) this.move(axes, values, b, emit);
    return values.M !== undefined;
  }

  unit() { return this.modes.unit === 20 ? 25.4 : 1; }

  move(axes, values, b, emit) {
    if (this.modes.motion === null) throw new Alarm('missing-word', 'G');
    if (this.modes.motion === 1 && this.feed === 0) throw new Alarm('feed-missing', 'F');
    if (axes.length === 0) return;
    const to = {};
    for (const axis of axes) {
      this.at[axis] = values[axis] * this.unit() + (this.modes.distance === 91 ? this.at[axis] : 0);
      to[axis.toLowerCase()] = this.at[axis];
    }
    if (this.modes.motion === 0) emit('rapid', { b, to });
    else emit('feed', { b, to, f: this.feed });
  }
}

serve(() => ({
  name: 'acme-javascript',
  version: '1.0.0',
  // It does a part of "basic": without `dialects` nothing is declared, and what is skipped is not claimed.
  features: ['blocks', 'bytes'],
  numeric: { kind: 'binary64' },
  run(program, emit) {
    const machine = new Machine();
    const lines = program.toString('latin1').split(/\r\n|\r|\n/);
    for (let b = 1; b <= lines.length; ++b) {
      try {
        if (machine.block(lines[b - 1], b, emit)) return undefined;
      } catch (found) {
        if (found instanceof Alarm) return alarm(found.cls, { cls: found.cls, b, word: found.word });
        if (found instanceof NotSupported) return skip(found.feature, 'Straight lines only.');
        throw found;
      }
    }
    // A line feed ends a line and begins none.
    const last = Math.max(1, lines.length - (lines.at(-1) === '' ? 1 : 0));
    return alarm('program-end', { cls: 'program-end', b: last });
  },
}));
