// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run writes, against schemas: results.jsonl by ours, SARIF by the official schema of 2.1.0,
// JUnit by ours for what we write (xmllint), the badge by the rules of its endpoint: from a
// real run with failures, and from a results file as hostile as can be.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { inflateRawSync } from 'node:zlib';
import Ajv from 'ajv';
import Ajv2020 from 'ajv/dist/2020.js';

const here = new URL('.', import.meta.url).pathname;
const root = new URL('../../../', import.meta.url).pathname;
const gonogo = process.env.GONOGO;
const xmllint = process.env.GONOGO_XMLLINT ?? 'xmllint';
const work = mkdtempSync(join(tmpdir(), 'gonogo-evidence-'));
after(() => rmSync(work, { recursive: true, force: true }));
const read = (path) => readFileSync(path, 'utf8');

const results = new Ajv2020({ strict: true, strictRequired: false, strictTypes: false })
  .compile(JSON.parse(read(join(root, 'corpus/schema/results-2.schema.json'))));

// The official schema is of draft 4, which differs from draft 7 in names that it uses once.
function sarifSchema() {
  const require = createRequire(import.meta.url);
  const folder = require.resolve('@microsoft/jest-sarif/package.json').replace(/package\.json$/, '');
  const { id, $schema, ...schema } = JSON.parse(read(join(folder, 'lib/schemas/sarif-2.1.0-rtm.5.json')));
  assert.match(id, /sarif-2\.1\.0/);
  assert.match($schema, /draft-04/);
  assert.doesNotMatch(JSON.stringify(schema), /"exclusiveM(in|ax)imum":(true|false)/);
  return schema;
}
const sarif = new Ajv({ strict: false, validateFormats: false, unicodeRegExp: false }).compile(sarifSchema());
const badge = new Ajv().compile({
  type: 'object',
  properties: {
    schemaVersion: { const: 1 }, label: { type: 'string' },
    message: { type: 'string', minLength: 1 }, color: { enum: ['brightgreen', 'yellowgreen', 'red', 'yellow'] },
  },
  required: ['schemaVersion', 'label', 'message'], additionalProperties: false,
});

const valid = (validator, value) => assert.ok(validator(value), JSON.stringify(validator.errors?.slice(0, 3)));
function validXml(path) {
  const run = spawnSync(xmllint, ['--noout', '--nonet', '--schema', join(here, 'junit.xsd'), path], { encoding: 'utf8' });
  assert.equal(run.status, 0, run.stderr.slice(0, 800));
}

function validFolder(folder) {
  const log = JSON.parse(read(join(folder, 'results.sarif')));
  valid(sarif, log);
  validXml(join(folder, 'junit.xml'));
  valid(badge, JSON.parse(read(join(folder, 'badge.json'))));
  for (const result of log.runs[0].results) {
    const uri = result.locations[0].physicalLocation?.artifactLocation.uri;
    if (uri) assert.ok(existsSync(join(folder, uri)), `${uri} is missing`);
  }
  return log;
}

// A real run with failures; made once.
let real;
function realRun() {
  if (!real) {
    const certified = join(work, 'certified');
    const run = spawnSync(gonogo, ['certify', '--subject', 'builtin:gsk+taper-sign', '--dialect', 'gsk988ta',
      '--only', 'gsk.g94.*', '--report', certified], { encoding: 'utf8' });
    assert.equal(run.status, 1, run.stderr);
    real = join(work, 'real');
    execFileSync(gonogo, ['report', join(certified, 'results.jsonl'), '--out', real]);
  }
  return real;
}

test('every line of a real run is valid', () => {
  const lines = read(join(realRun(), 'results.jsonl')).trimEnd().split('\n').map((line) => JSON.parse(line));
  assert.ok(lines.length > 50);
  for (const line of lines) valid(results, line);
  assert.ok(lines.some((line) => line.verdict?.startsWith('fail.')));
});

test('the report folder of a real run is valid', () => {
  const log = validFolder(realRun());
  assert.ok(log.runs[0].results.length > 0);
});

// ---- a hostile file ----

const kNasty = ['</testcase>]]><!-- & "quoted" \'single\'', '\u0000\u0001\u000b\u001f\ufffe\uffff\u0085',
  'line\nend\r\n\ttab', '```\n# Heading\n<script>alert(1)</script> | cell | `code`', '../../../etc/passwd',
  '\ud83d\ude00\u6f22\u5b57', 'x'.repeat(3000)];

function hostileFile() {
  const header = { format: 1, gonogo: kNasty[0], corpus: { version: kNasty[1], sha256: '0'.repeat(64) },
    subject: { spec: kNasty.join(' '), name: kNasty[3], version: kNasty[0], numeric: { kind: 'exact' }, features: [] },
    profile: {}, tolerance: null, chord: null, seed: 0, shard: '1/1', argv: kNasty };
  const verdicts = ['pass-exact', 'skip', 'xfail', 'fail.geometry', 'crash', 'timeout', 'xpass', 'oracle-gap', 'oracle-error'];
  const cases = kNasty.flatMap((text, i) => verdicts.map((verdict, k) => ({
    id: `${text}#${i}${k}`, dialect: i % 2 ? 'gsk988ta' : text, cycle: text, clauses: [text], verdict,
    clause: text, reading: text, b: 1, want: text, got: text, deviation: { exact: text, mm: text }, message: text,
    us: 12, attempts: 1, ...(k > 2 ? { program: k === 3 ? { base64: '/wD+' } : text, trace: [] } : {}) })));
  // By bytes, as the program sorts.
  cases.sort((a, b) => Buffer.compare(Buffer.from(a.id), Buffer.from(b.id)));
  const hash = createHash('sha256');
  const totals = {};
  for (const { us, attempts, ...rest } of cases) {
    hash.update(`${JSON.stringify(rest)}\n`);
    totals[rest.verdict] = (totals[rest.verdict] ?? 0) + 1;
  }
  const footer = { decision: 'NO-GO', totals, cases: cases.length, judged: 1, assignments: kNasty, stale: kNasty, sha256: hash.digest('hex') };
  mkdirSync(join(work, 'hostile'), { recursive: true });
  const path = join(work, 'hostile', 'results.jsonl');
  // The program writes the characters above 126 as they are, as JSON.stringify does.
  writeFileSync(path, [header, ...cases, footer].map((line) => `${JSON.stringify(line)}\n`).join(''));
  return path;
}

// Markdown without its code spans and escaped characters: what is left may be markup.
function withoutCode(text) {
  let left = '';
  for (let i = 0; i < text.length; ++i) {
    const ticks = /^`+/.exec(text.slice(i, i + 100))?.[0];
    if (text[i] === '\\' && /[!-/:-@[-`{-~]/.test(text[i + 1] ?? '')) {
      ++i;
    } else if (ticks) {
      const end = new RegExp(`[^\`]${ticks}(?!\`)`).exec(text.slice(i + ticks.length));
      i += ticks.length - 1 + (end ? end.index + 1 + ticks.length : 0);
    } else {
      left += text[i];
    }
  }
  return left;
}

test('the report folder of a hostile run is valid and stays in its folder', () => {
  const out = join(work, 'hostile-out');
  execFileSync(gonogo, ['report', hostileFile(), '--out', out]);
  const log = validFolder(out);
  // All but pass-exact and skip, and each stale entry.
  assert.equal(log.runs[0].results.length, 7 * 7 + 7);
  assert.ok(!existsSync(join(work, 'etc')));
  // Every case of the file is a test case, and so is each stale entry.
  const xml = read(join(out, 'junit.xml'));
  assert.equal(xml.match(/<testcase /g).length, 7 * 9 + 7);
  // Nothing of it is markup in the summary.
  const summary = withoutCode(read(join(out, 'summary.md')).replace(/^(`{3,})\n[^]*?\n\1$/gm, ''));
  assert.doesNotMatch(summary, /<script>/);
});

// ---- the schemas can refuse ----

test('the schema of results refuses what is no line', () => {
  const lines = read(join(realRun(), 'results.jsonl')).trimEnd().split('\n').map((line) => JSON.parse(line));
  const failure = lines.find((line) => line.verdict?.startsWith('fail.'));
  const footer = lines.at(-1);
  for (const wrong of [{ ...failure, verdict: 'fail' }, { ...failure, b: 0 }, { ...failure, extra: 1 },
    { ...footer, decision: 'MAYBE' }, { ...footer, cases: -1 }, { ...footer, sha256: '0' }, { ...lines[0], format: 3 }]) {
    assert.equal(results(wrong), false, JSON.stringify(wrong).slice(0, 200));
  }
});

test('the schemas of SARIF, JUnit and badge refuse what is none', () => {
  const log = JSON.parse(read(join(realRun(), 'results.sarif')));
  log.runs[0].results[0].level = 'fatal';
  assert.equal(sarif(log), false);
  const broken = join(work, 'broken.xml');
  writeFileSync(broken, read(join(realRun(), 'junit.xml')).replace(/ tests="\d+"/, ''));
  assert.throws(() => validXml(broken));
  assert.equal(badge({ schemaVersion: 1, label: 'gonogo' }), false);
});

// Alone, G80 beside G81 is an alarm; forgotten, it leaves G81: two holes of three motions each.
test('a case that passed is drawn under the readings of its run', () => {
  const folder = join(work, 'readings');
  execFileSync(gonogo, ['certify', '--subject', 'builtin:ngc', '--dialect', 'rs274', '--case', 'ngc.cycles.000115',
    '--reading', 'ngc.g80-beside=ignored', '--report', folder], { cwd: work });
  const packs = [...read(join(folder, 'index.html')).matchAll(/class="passes"[^>]*>([^<]*)</g)];
  assert.equal(packs.length, 1);
  const [shown] = Object.values(JSON.parse(inflateRawSync(Buffer.from(packs[0][1], 'base64'))));
  assert.deepEqual(shown.profile, { readings: { 'ngc.g80-beside': 'ignored' } });
  assert.deepEqual(shown.motions.map(([kind, block]) => `${kind} ${block}`),
    ['rapid 1', 'rapid 2', 'rapid 2', 'feed 2', 'rapid 2', 'rapid 3', 'feed 3', 'rapid 3', 'm 4', 'end 0']);
});
