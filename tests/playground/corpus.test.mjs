// SPDX-License-Identifier: GPL-3.0-or-later
//
// The playground's module under node: on every vector of the corpus its records are those of the vector,
// which the program is held to (`gonogo corpus check`), and on every GONOGO_PLAYGROUND_EVERY-th (4; 1: on all
// of them) records, messages and exit code are those of the program, byte for byte. GONOGO_EXPAND_MANY is the
// program's `expand` for many programs in one process, GONOGO_PLAYGROUND the folder of the module.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { runInThisContext } from 'node:vm';

if (!existsSync(join(process.env.GONOGO_PLAYGROUND, 'gonogo.wasm'))) {
  console.log('SKIPPED: playground.build has made no module');
  process.exit(0);
}
const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..');
const work = mkdtempSync(join(tmpdir(), 'gonogo-playground-'));
const open = runInThisContext(`${readFileSync(join(root, 'playground', 'page', 'engine.js'))}; openEngine`);
let engine;

before(async () => {
  assert.ok(process.env.GONOGO_EXPAND_MANY, 'GONOGO_EXPAND_MANY must name the program');
  engine = await open(readFileSync(join(process.env.GONOGO_PLAYGROUND, 'gonogo.wasm')));
});
after(() => rmSync(work, { recursive: true, force: true }));

function* vectors() {
  const folder = join(root, 'corpus', 'vectors');
  for (const name of readdirSync(folder, { recursive: true }).filter((one) => one.endsWith('.json')).sort()) {
    const { dialect, groups } = JSON.parse(readFileSync(join(folder, name)));
    for (const { profile, cases } of groups) {
      for (const one of cases) {
        const bytes = typeof one.program === 'string' ? Buffer.from(one.program) : Buffer.from(one.program.base64, 'base64');
        yield { id: one.id, dialect, profile, bytes, expect: one.expect };
      }
    }
  }
}

// What `gonogo expand` writes of each of the vectors, in one process.
function expanded(wanted) {
  const profiles = new Map();
  const lines = wanted.map(({ dialect, profile, bytes }, number) => {
    const machine = JSON.stringify({ dialect, ...profile });
    if (!profiles.has(machine)) {
      profiles.set(machine, join(work, `${profiles.size}.json`));
      writeFileSync(profiles.get(machine), machine);
    }
    writeFileSync(join(work, `${number}.nc`), bytes);
    return `${join(work, `${number}.nc`)} ${dialect} ${profiles.get(machine)}\n`;
  });
  const scratch = join(work, 'scratch');
  mkdirSync(scratch);
  const all = execFileSync(process.env.GONOGO_EXPAND_MANY, [scratch], { input: lines.join(''), maxBuffer: 1 << 30 });
  let at = 0;
  return wanted.map((vector, number) => {
    const end = all.indexOf(10, at);
    const [exit, records, messages] = String(all.subarray(at, end)).split(' ').map(Number);
    at = end + 1 + records + messages;
    return { vector, file: join(work, `${number}.nc`), exit,
      records: String(all.subarray(end + 1, end + 1 + records)), messages: String(all.subarray(end + 1 + records, at)) };
  });
}

const ask = (vector, file) => engine.answer({ dialect: vector.dialect, profile: JSON.stringify(vector.profile), file }, new Uint8Array(vector.bytes));

// A vector without a byte is wrong use of program and page.
const kEmpty = 2;

test('the module writes the records of every vector', { timeout: 600_000 }, () => {
  let count = 0;
  for (const vector of vectors()) {
    const found = ask(vector, 'program.nc');
    if (found.exit === kEmpty) {
      assert.equal(vector.bytes.length, 0, `${vector.id}: ${found.messages}`);
      continue;
    }
    const lines = found.records.split('\n').slice(0, -1);
    const last = JSON.parse(lines.at(-1));
    const fits = vector.expect.some(({ records, alarm, not_covered: outside, others }) => {
      // The module may show another alternative, which the vector does not state.
      if (others) return true;
      const ends = records.some(({ k }) => k === 'end') ? last.k === 'end'
        : alarm ? last.k === 'alarm' && alarm.any_of.some((one) => one.class === last.class && one.b === last.b)
          : Boolean(outside) && last.k === 'not-covered';
      const shown = last.k === 'end' ? lines : lines.slice(0, -1);
      return ends && records.length === shown.length && records.every((one, i) => JSON.stringify(one) === shown[i]);
    });
    assert.ok(fits, `${vector.id}: ${found.records}`);
    ++count;
  }
  console.log(`${count} vectors`);
  assert.ok(count > 10_000);
});

test('the module writes what the program writes', { timeout: 3_000_000 }, () => {
  const every = Number(process.env.GONOGO_PLAYGROUND_EVERY ?? 4);
  const all = expanded([...vectors()].filter((_, number) => number % every === 0));
  let alarms = 0;
  for (const { vector, file, ...wanted } of all) {
    const found = ask(vector, file);
    // Wrong use is told in words of each: one of files, one of a page.
    const messages = wanted.exit === kEmpty ? wanted.messages : found.messages;
    assert.deepEqual({ exit: found.exit, records: found.records, messages }, wanted, vector.id);
    if (wanted.exit !== 0) ++alarms;
  }
  console.log(`${all.length} vectors, ${alarms} of them alarms or not covered`);
  assert.ok(all.length > 10_000 / every && alarms > 1_000 / every);
});

test('a wrong dialect, profile or reading is refused with the reason', () => {
  const messages = (head) => {
    const { exit, messages: text, records } = engine.answer(head, 'G00 X1\n');
    assert.deepEqual([exit, records], [2, '']);
    return text;
  };
  assert.match(messages({ dialect: 'fanuc' }), /fanuc/);
  assert.match(messages({ dialect: 'gsk988ta', profile: 'speed = 3' }), /speed/);
  assert.match(messages({ dialect: 'gsk988ta', readings: ['gsk.pocket.end=nowhere'] }), /nowhere/);
  assert.match(messages({ dialect: 'gsk988ta', readings: ['gsk.pocket.end'] }), /key=value/);
});

test('the readings that a program asks for come with it, and change what it does', () => {
  const pocket = 'G17 G00 X30 Y14 Z9\nG110 X20 Y10 W-4 R-3 I10 L4 Q2 P0.5 D3 F200\n';
  const by = (...readings) => engine.answer({ dialect: 'gsk988ta', readings, draw: true }, pocket);
  const first = by();
  assert.ok(first.readings.some(({ name }) => name === 'gsk.pocket.end'));
  assert.equal(first.steps.length, first.moves.length);
  assert.equal(first.steps.length, first.records.trim().split('\n').length);
  assert.notEqual(by('gsk.pocket.end=initial').records, by('gsk.pocket.end=r-plane').records);
});

test('the catalog has every dialect with its clauses and readings', () => {
  const catalog = engine.catalog();
  assert.deepEqual(catalog.map(({ name }) => name).sort(), ['gsk988ta', 'hnc21t', 'rs274', 'sinumerik802s', 'sinumerik840d']);
  for (const { name, clauses, readings } of catalog) assert.ok(clauses.length > 20 && readings.length >= 5, name);
});

test('brackets without end are not read, and not the end of the module', () => {
  const deep = `#1=${'['.repeat(200_000)}1${']'.repeat(200_000)}\n`;
  assert.equal(engine.answer({ dialect: 'rs274' }, deep).exit, 3);
  assert.equal(engine.answer({ dialect: 'rs274' }, 'G0 X1\nM2\n').exit, 0);
});
