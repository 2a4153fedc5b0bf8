// SPDX-License-Identifier: GPL-3.0-or-later
//
// docs/protocol.md and docs/formats.md against the schemas: each table behind <!-- schema: ... --> has
// the keys of that part of a schema and no other, every part has a table, and each block behind
// <!-- valid: ... --> is valid. The protocol's schema against what gauge and subject say to each other, and
// the certificate's against certificates.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import Ajv2020 from "ajv/dist/2020.js";

const root = new URL("../../", import.meta.url).pathname;
const program = process.env.GONOGO_PROGRAM;
const schemas = new Map();
const ajv = new Ajv2020({ strict: true, strictRequired: false, strictTypes: false });
for (const file of readdirSync(join(root, "corpus/schema"))) {
  const schema = JSON.parse(readFileSync(join(root, "corpus/schema", file), "utf8"));
  schemas.set(file.replace(".schema.json", ""), schema);
  ajv.addSchema(schema);
}
const documents = ["protocol.md", "formats.md"].map((name) => readFileSync(join(root, "docs", name), "utf8"));

// "results-2 header" or "vectors-2 #": a definition, or the whole.
function part(name) {
  const [file, definition] = name.split(" ");
  const schema = schemas.get(file);
  return definition === "#" ? schema : schema.$defs[definition];
}
function validator(name) {
  const [file, definition] = name.split(" ");
  return ajv.getSchema(schemas.get(file).$id + (definition === "#" ? "" : `#/$defs/${definition}`));
}

// The keys of a part, those of objects within as outer.inner, of lists as outer[].inner.
function keysWithin(schema, at) {
  if (schema.$ref) return [];
  const keys = [];
  for (const [name, inner] of Object.entries(schema.properties ?? {})) {
    const key = at ? `${at}.${name}` : name;
    keys.push(key, ...keysWithin(inner, key));
  }
  if (schema.items) keys.push(...keysWithin(schema.items, `${at}[]`));
  if (typeof schema.additionalProperties === "object") {
    keys.push(...keysWithin(schema.additionalProperties, `${at}.*`));
  }
  if (!schema.properties) for (const branch of schema.oneOf ?? []) keys.push(...keysWithin(branch, at));
  return keys;
}

function parts() {
  const all = [];
  for (const [file, schema] of schemas) {
    if (schema.properties) all.push(`${file} #`);
    for (const [name, definition] of Object.entries(schema.$defs ?? {})) {
      if (name !== "hasEnd" && keysWithin(definition, "").length > 0) all.push(`${file} ${name}`);
    }
  }
  return all;
}

// The tables of a document: for which parts, and their first column.
function tables(text) {
  const found = [];
  for (const match of text.matchAll(/<!-- schema: (.+) -->\n((?:\|.*\n)+)/g)) {
    const keys = match[2].split("\n").slice(2).filter(Boolean).map((row) => row.match(/^\| `([^`]+)` \|/)?.[1]);
    found.push({ parts: match[1].split(", "), keys });
  }
  return found;
}

test("every key of a schema is documented, and none that it does not have", () => {
  const documented = new Set();
  for (const table of documents.flatMap(tables)) {
    for (const name of table.parts) {
      assert.ok(!documented.has(name), `${name} has two tables`);
      documented.add(name);
      assert.deepEqual([...table.keys].sort(), [...new Set(keysWithin(part(name), ""))].sort(), name);
    }
  }
  assert.deepEqual([...documented].sort(), parts().sort());
});

test("a key too many or too few is noticed", () => {
  const [table] = tables("<!-- schema: protocol-1 reset -->\n| key | m |\n|---|---|\n| `cmd` | x |\n| `extra` | y |\n");
  assert.deepEqual(table.keys, ["cmd", "extra"]);
  assert.notDeepEqual(table.keys, keysWithin(part("protocol-1 reset"), ""));
  assert.ok(parts().length > 20);
});

test("every verdict is documented", () => {
  for (const verdict of schemas.get("results-2").$defs.verdict.enum) {
    assert.ok(documents[1].includes(`\`${verdict}\``), verdict);
  }
});

test("every rule and every reason of a gap is documented", () => {
  const { rule, gap } = schemas.get("results-2").$defs.case.properties;
  for (const name of [...rule.enum, ...gap.enum]) assert.ok(documents[1].includes(`\`${name}\``), name);
});

test("the examples of the documents are valid", () => {
  let examples = 0;
  for (const text of documents) {
    for (const [, name, kind, body] of text.matchAll(/<!-- valid: (.+) -->\n```(\w+)\n([^`]+)```/g)) {
      const validate = validator(name);
      for (const line of kind === "jsonl" ? body.trim().split("\n") : [body]) {
        examples += 1;
        assert.ok(validate(JSON.parse(line)), `${line}: ${JSON.stringify(validate.errors)}`);
      }
    }
    // The conversation of protocol.md.
    for (const [, who, line] of text.matchAll(/^ {4}([<>]) (\{.*\})$/gm)) {
      examples += 1;
      assert.ok(validator("protocol-1 #")(JSON.parse(line)), `${who} ${line}`);
    }
  }
  assert.ok(examples > 20);
});

function inFolder(action) {
  const folder = mkdtempSync(join(tmpdir(), "gonogo-documents-"));
  try {
    return action(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

// certify refuses a vector that is not what the gauge makes of it.
test("the example of vectors is a corpus that judges", () => {
  const [, body] = documents[1].match(/<!-- valid: vectors-2 # -->\n```json\n([^`]+)```/);
  const vectors = JSON.parse(body);
  const file = `vectors/${vectors.dialect}/example.json`;
  inFolder((folder) => {
    mkdirSync(join(folder, "vectors", vectors.dialect), { recursive: true });
    writeFileSync(join(folder, file), body);
    writeFileSync(join(folder, "manifest.json"), JSON.stringify({
      format: 1, version: vectors.corpus, license: "CC0-1.0", files: [file], retired: [] }));
    const run = spawnSync(program, ["certify", "--subject", "builtin:ngc", "--corpus", folder, "--fresh", "0",
      "--report", join(folder, "report")], { cwd: root, encoding: "utf8" });
    assert.equal(run.status, 0, run.stdout + run.stderr);
  });
});

// What the gauge and the example in Python say to each other, a line an entry.
function conversation() {
  return inFolder((folder) => {
    const listener = join(folder, "listen.py");
    writeFileSync(listener, `
import os, subprocess, sys, threading
said = open(sys.argv[1], "ab", buffering=0)
subject = subprocess.Popen(sys.argv[2:], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
def answers():
    for line in subject.stdout:
        said.write(b"< " + line)
        sys.stdout.buffer.write(line)
        sys.stdout.buffer.flush()
thread = threading.Thread(target=answers)
thread.start()
for line in sys.stdin.buffer:
    said.write(b"> " + line)
    subject.stdin.write(line)
    subject.stdin.flush()
subject.stdin.close()
thread.join()
`);
    const said = join(folder, "said");
    const subject = `pipe:env PYTHONPATH=${root}helpers python3 ${listener} ${said} python3 ${root}examples/python/acme.py`;
    execFileSync(program, ["certify", "--subject", subject, "--sandbox", "off", "--dialect", "rs274", "--only", "ngc.basic.*",
      "--jobs", "1", "--report", join(folder, "report")], { cwd: root });
    return readFileSync(said, "utf8").trimEnd().split("\n");
  });
}

test("what gauge and subject say to each other is valid", () => {
  const lines = conversation();
  const kinds = new Set();
  for (const line of lines) {
    const message = JSON.parse(line.slice(2));
    const sent = message.cmd;
    const name = line[0] === ">" ? sent : message.seq ? "runReply" : message.protocol ? "startReply" : "okReply";
    kinds.add(name === "runReply" ? message.outcome : name);
    const validate = validator(`protocol-1 ${name}`);
    assert.ok(validate(message), `${line}: ${JSON.stringify(validate.errors)}`);
  }
  for (const kind of ["start", "startReply", "configure", "okReply", "run", "ok", "alarm", "skip"]) {
    assert.ok(kinds.has(kind), kind);
  }
});

test("statements of certificates are valid", () => {
  for (const [subject, code] of [["builtin:ngc", 0], ["builtin:ngc+offsets-absolute", 1]]) {
    inFolder((folder) => {
      const run = spawnSync(program, ["certify", "--subject", subject, "--dialect", "rs274", "--only", "ngc.arc*",
        "--report", join(folder, "report"), "--certificate", join(folder, "certificate")], { cwd: root });
      assert.equal(run.status, code);
      const statement = JSON.parse(readFileSync(join(folder, "certificate/statement.json"), "utf8"));
      const validate = validator("certificate-1 #");
      assert.ok(validate(statement), JSON.stringify(validate.errors));
      assert.equal(validate({ ...statement, extra: 1 }), false);
    });
  }
});

test("the manifest of the corpus is valid", () => {
  const manifest = JSON.parse(readFileSync(join(root, "corpus/manifest.json"), "utf8"));
  const validate = validator("manifest-1 #");
  assert.ok(validate(manifest), JSON.stringify(validate.errors));
  assert.equal(validate({ ...manifest, version: "1.0" }), false);
});

test("the data of sites are valid", () => {
  inFolder((folder) => {
    const runs = [["one", "builtin:ngc"], ["two", "builtin:ngc+offsets-absolute"], ["three", "builtin:ngc+offsets-absolute"]];
    for (const [name, subject] of runs) {
      spawnSync(program, ["certify", "--subject", subject, "--dialect", "rs274", "--only", "ngc.arc*",
        "--report", join(folder, name)], { cwd: root });
    }
    execFileSync(program, ["site", ...runs.map(([name]) => `${name}=${join(folder, name)}`), "--out", join(folder, "site")]);
    const data = JSON.parse(readFileSync(join(folder, "site/site.json"), "utf8"));
    assert.ok(data.departures.length > 0 && data.vote.agreements.length > 0);
    const validate = validator("site-1 #");
    assert.ok(validate(data), JSON.stringify(validate.errors));
    assert.equal(validate({ ...data, extra: 1 }), false);
  });
});

test("manifests of exported programs are valid", () => {
  const limits = ["--x-zero-at", "100", "--envelope", "-20..20,-20..20,-20..20", "--feed-max", "300"];
  for (const words of [["--only", "gsk.arc.*", "--x-zero-at", "100"], ["--only", "*.0000[1-4]?", "--all-profiles", ...limits]]) {
    inFolder((folder) => {
      const out = join(folder, "programs");
      execFileSync(program, ["export", "--out", out, ...words], { cwd: root });
      const manifest = JSON.parse(readFileSync(join(out, "manifest.json"), "utf8"));
      const validate = validator("export-1 #");
      assert.ok(validate(manifest), JSON.stringify(validate.errors));
      assert.ok(manifest.programs.length > 20);
      assert.equal(validate({ ...manifest, extra: 1 }), false);
      assert.equal(validate({ ...manifest, programs: [{ ...manifest.programs[0], start: { q: "1" } }] }), false);
    });
  }
});

// The keys that the program names when it refuses an unknown one.
function keysThatItReads(text, ...words) {
  return inFolder((folder) => {
    const file = join(folder, "file.toml");
    writeFileSync(file, text);
    const run = spawnSync(program, words.map((word) => (word === "FILE" ? file : word)), { cwd: folder });
    assert.equal(run.status, 2);
    const list = run.stderr.toString().match(/Write (?:one of: )?(.+)\.\n/);
    return list[1].split(", ").sort();
  });
}

test("a profile has the keys that the program reads", () => {
  const profile = schemas.get("vectors-2").$defs.profile.properties;
  const read = (text) => keysThatItReads(text, "expand", "/dev/null", "--profile", "FILE");
  assert.deepEqual(read('foo = "1"'), ["dialect", ...Object.keys(profile)].sort());
  assert.deepEqual(read('[initial]\nfoo = "1"'), Object.keys(profile.initial.properties).sort());
  assert.deepEqual(read('[tools.1]\nfoo = "1"'), Object.keys(profile.tools.additionalProperties.properties).sort());
});

test("the parameters of every dialect are documented", () => {
  for (const dialect of ["gsk988ta", "hnc21t", "sinumerik840d", "sinumerik802s"]) {
    const text = `dialect = "${dialect}"\n[parameters]\nfoo = "1"`;
    for (const name of keysThatItReads(text, "expand", "/dev/null", "--profile", "FILE")) {
      assert.ok(documents[1].includes(`\`${name}\``), name);
    }
  }
});

test("known failures have the documented keys", () => {
  const text = readFileSync(join(root, "docs/known-failures.md"), "utf8");
  const documented = [...text.matchAll(/^\| `([a-z]+)` \|/gm)].map((row) => row[1]).sort();
  const read = (file) => keysThatItReads(file, "certify", "--subject", "builtin:ngc", "--corpus", join(root, "corpus"),
    "--case", "ngc.basic.000001", "--known-failures", "FILE");
  assert.deepEqual(read("[[failure]]\nfoo = 1"), documented);
});
