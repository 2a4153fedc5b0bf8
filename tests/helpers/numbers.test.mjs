// SPDX-License-Identifier: GPL-3.0-or-later
//
// How the JavaScript helper writes values.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { alarm, error, numberText, record } from '../../helpers/gonogo_pipe.mjs';

test('a number reads back as the same double', () => {
  const values = [0, 1, -1.5, 0.1, 1 / 3, 5e-324, Number.MAX_VALUE, 2 ** 53 + 2, 1e21, 1e-7];
  for (const value of values) assert.equal(Number(numberText(value)), value);
});

test('a big integer keeps its digits', () => {
  assert.equal(numberText(9007199254740993n), '9007199254740993');
});

test('what is no number is refused', () => {
  for (const value of [NaN, Infinity, -Infinity, true, undefined, null, {}]) {
    assert.throws(() => numberText(value));
  }
});

test('a record has its numbers as text and its integers bare', () => {
  assert.deepEqual(
    record('arc', { b: 3, plane: 'G17', rot: -1, c: { x: 5, y: 0 }, to: { x: 10 }, f: 200,
      fm: undefined }),
    { k: 'arc', b: 3, plane: 'G17', rot: -1, c: { x: '5', y: '0' }, to: { x: '10' }, f: '200' });
});

test('an enclosure is a number', () => {
  assert.deepEqual(record('rapid', { to: { x: { enclosure: [0.5, 0.75] } } }),
    { k: 'rapid', to: { x: { enclosure: ['0.5', '0.75'] } } });
});

test('a root is a number wherever one stands', () => {
  const root = { root: [0, 1, 2] };
  assert.deepEqual(record('feed', { to: { x: root }, f: root }),
    { k: 'feed', to: { x: { root: ['0', '1', '2'] } }, f: { root: ['0', '1', '2'] } });
});

test('a long text of the subject is cut where the protocol ends', () => {
  assert.equal(alarm('x'.repeat(5000)).alarm.native.length, 1000);
  assert.equal(error('x'.repeat(5000)).message.length, 1000);
});
