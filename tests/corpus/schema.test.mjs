// SPDX-License-Identifier: GPL-3.0-or-later
//
// The vector files and a results file against their JSON Schemas, by ajv; and broken ones, which
// the schemas must refuse.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import Ajv2020 from "ajv/dist/2020.js";

const corpus = new URL("../../corpus/", import.meta.url).pathname;
const read = (file) => JSON.parse(readFileSync(file, "utf8"));
const ajv = new Ajv2020({ strict: true, strictRequired: false, strictTypes: false });
const vectors = ajv.compile(read(join(corpus, "schema/vectors-2.schema.json")));
const results = ajv.compile(read(join(corpus, "schema/results-2.schema.json")));

function vectorFiles() {
  const root = join(corpus, "vectors");
  return readdirSync(root, { recursive: true })
    .filter((name) => name.endsWith(".json"))
    .map((name) => join(root, name));
}

function resultsLines() {
  const program = process.env.GONOGO_RESULTS_LINES;
  const folder = mkdtempSync(join(tmpdir(), "gonogo-results-"));
  try {
    execFileSync(program, [join(folder, "results.jsonl")]);
    const text = readFileSync(join(folder, "results.jsonl"), "utf8");
    return text.trimEnd().split("\n").map((line) => JSON.parse(line));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test("there are vector files", () => assert.ok(vectorFiles().length >= 5));

for (const file of vectorFiles()) {
  test(`${file.slice(corpus.length)} is valid`, () => {
    assert.ok(vectors(read(file)), JSON.stringify(vectors.errors));
  });
}

// One change each, on a file that is valid without it.
const breaks = {
  "another format": (f) => { f.format = 3; },
  "an unknown key": (f) => { f.extra = 1; },
  "a group without clauses": (f) => { f.groups[0].clauses = []; },
  "a clause in small letters": (f) => { f.groups[0].clauses = ["gsk-g94-01"]; },
  "a case without an id": (f) => { delete f.groups[0].cases[0].id; },
  "an id without a number": (f) => { f.groups[0].cases[0].id = "gsk.g94"; },
  "a case without an expectation": (f) => { f.groups[0].cases[0].expect = []; },
  "a bare number": (f) => { f.groups[0].cases[0].expect[0].records[1].to.x = 65; },
  "a number with an exponent": (f) => { f.groups[0].cases[0].expect[0].records[1].to.x = "1e2"; },
  "a feed record without f": (f) => { delete f.groups[0].cases[0].expect[0].records[3].f; },
  "a record without its line": (f) => { delete f.groups[0].cases[0].expect[0].records[1].b; },
  "an unknown kind": (f) => { f.groups[0].cases[0].expect[0].records[1].k = "move"; },
  "no ending": (f) => { f.groups[0].cases[0].expect[0].records.pop(); },
  "two endings": (f) => { f.groups[0].cases[0].expect[0].not_covered = true; },
  "an unknown alarm": (f) => {
    f.groups[0].cases[0].expect[0] = { records: [], alarm: { any_of: [{ class: "oops", b: 1 }] } };
  },
  "a program of bytes that are no base64": (f) => {
    f.groups[0].cases[0].program = { base64: "abc" };
  },
  "an unknown key of the profile": (f) => { f.groups[0].profile = { speed: "1" }; },
  "a profile with a bare number": (f) => { f.groups[0].profile = { initial: { x: 1 } }; },
};
for (const [what, change] of Object.entries(breaks)) {
  test(`the schema refuses ${what}`, () => {
    const file = read(join(corpus, "vectors/gsk988ta/g94.json"));
    assert.ok(vectors(file), JSON.stringify(vectors.errors));
    change(file);
    assert.equal(vectors(file), false);
  });
}

test("every line of a results file is valid", () => {
  const lines = resultsLines();
  assert.equal(lines.length, 7);
  for (const line of lines) assert.ok(results(line), JSON.stringify([line, results.errors]));
});

test("the results schema refuses what is no line", () => {
  const lines = resultsLines();
  const [header, , failure] = lines;
  const footer = lines.at(-1);
  assert.equal(results({}), false);
  assert.equal(results({ ...header, format: 3 }), false);
  assert.equal(results({ ...failure, verdict: "fail" }), false);
  assert.equal(results({ ...failure, program: undefined, trace: "none" }), false);
  assert.equal(results({ ...footer, sha256: "0" }), false);
});
