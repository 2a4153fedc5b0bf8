// SPDX-License-Identifier: GPL-3.0-or-later
//
// A subject for the helper's tests: each word of a program makes it do one thing.
import { alarm, serve, skip } from '../../helpers/gonogo_pipe.mjs';

let kept = 0;

const kWords = {
  length: (rest, emit) => emit('dwell', { s: rest.length }),
  sum: (rest, emit) => emit('dwell', { s: rest.reduce((sum, byte) => sum + byte, 0) }),
  many: (rest, emit) => {
    for (let i = 0; i < Number(rest); ++i) emit('rapid', { b: i + 1, to: { x: i } });
  },
  numbers: (_rest, emit) => emit('feed', { b: 1, f: '11/3', fm: null,
    to: { x: 0.1, y: 1e-7, z: { root: [0, 1, 2] }, a: -0, c: 7n } }),
  print: (_rest, emit) => {
    emit('rapid', { to: { x: 1 } });
    console.log('noise on console');
    process.stdout.write('noise on process.stdout\n');
  },
  keep: (_rest, emit) => emit('dwell', { s: ++kept }),
  alarm: (_rest, emit) => {
    emit('rapid', { b: 1, to: { x: 1 } });
    return alarm('E61', { cls: 'feed-missing', b: 2, word: 'F' });
  },
  skip: () => skip('turns', 'no turns here'),
  nan: (_rest, emit) => emit('rapid', { to: { x: NaN } }),
  kind: (_rest, emit) => emit('alarm', { b: 1 }),
  // Later, as a promise: run may be async.
  exit: async () => { throw new RangeError('no exit'); },
};

await serve(() => {
  console.log('printed while it is made');
  return {
    name: 'sample',
    version: '1.2',
    dialects: { rs274: ['basic'] },
    features: ['blocks', 'bytes'],
    configure(_dialect, profile) {
      if ('break' in profile) throw new Error('configure broke');
      return profile.units === 'inch' ? 'units' : null;
    },
    reset() { kept = 0; },
    run(program, emit) {
      const space = program.indexOf(0x20);
      const [word, rest] = space < 0 ? [program, Buffer.alloc(0)]
        : [program.subarray(0, space), program.subarray(space + 1)];
      const act = kWords[word.toString()];
      if (act) {
        const outcome = act(rest, emit);
        return typeof outcome === 'object' ? outcome : undefined;
      }
      emit('rapid', { b: 1, to: { x: 1 } });
      throw new Error('unheard of');
    },
  };
});
