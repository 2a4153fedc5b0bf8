// SPDX-License-Identifier: MIT-0
//
// A test of node's runner for each case of a cycle. In a file that `node --test` runs:
//
//     import { conformance } from 'gonogo/test';
//
//     conformance('pipe:node acme.mjs', { dialect: 'rs274', 'known-failures': 'known.toml' });
//
// The gauge runs once; each case is told as a test. What the subject does not claim and what the
// manual leaves open is skipped, what fails as it is known to is a todo.
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const GONOGO = fileURLToPath(new URL('../bin/gonogo', import.meta.url));
const JUDGED_EXITS = [0, 1, 3];

// As `gonogo certify` tells it; a case without a program has no file.
function failureText({ id, verdict, message = '' }, report) {
  const told = `${report}/programs/${id}.txt`;
  return existsSync(told) ? readFileSync(told, 'utf8').trimEnd() : `${verdict}: ${message}`;
}

function declare(result, report) {
  const { id, verdict, message = '' } = result;
  if (['skip', 'oracle-gap', 'advice'].includes(verdict)) {
    test(id, { skip: `${verdict}: ${message}` }, () => {});
    return;
  }
  const todo = verdict === 'xfail' ? (result.known ?? message) : false;
  test(id, { todo }, () => {
    if (!verdict.startsWith('pass')) {
      const error = new Error(failureText(result, report));
      error.stack = error.message; // where this file throws says nothing
      throw error;
    }
  });
}

/**
 * @param {string} subject  as of `gonogo certify --subject`
 * @param {Object<string, string | string[]>} options  of `gonogo certify`, without the dashes:
 *   dialect, cycle, only, report (gonogo-report), known-failures, ...; a list gives one of them repeatedly
 */
export function conformance(subject, options = {}) {
  const { report = 'gonogo-report', ...others } = options;
  const words = ['certify', '--subject', subject, '--report', report];
  for (const [name, value] of Object.entries(others)) {
    for (const one of [value].flat()) words.push(`--${name}`, one);
  }
  const done = spawnSync(GONOGO, words, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'pipe'], maxBuffer: 1 << 28 });
  const output = `${done.stdout ?? ''}${done.stderr ?? ''}`;
  if (done.error || !JUDGED_EXITS.includes(done.status)) {
    throw new Error(`gonogo ${words.join(' ')}: ${done.error?.message ?? output}`);
  }
  const lines = readFileSync(`${report}/results.jsonl`, 'utf8').split('\n').filter(Boolean).map((line) => JSON.parse(line));
  const cases = lines.filter((line) => 'id' in line);
  cases.forEach((result) => declare(result, report));
  test('something is judged', () => {
    if (cases.every(({ verdict }) => verdict === 'skip')) throw new Error(output);
  });
}
