// SPDX-License-Identifier: GPL-3.0-or-later
//
// The module of WebAssembly and what it needs of a system: no files, no clock, no network. Runs in a
// worker of the page and in the tests.
'use strict';

const kNoSuchCall = 52;  // of WASI: ENOSYS

// Everything that the module may ask a system for; it only ever writes what it has to say as it ends.
function systemCalls(module, memory, say) {
  const calls = {
    fd_write: (file, vectors, count, written) => {
      const view = new DataView(memory().buffer);
      let size = 0;
      for (let i = 0; i < count; ++i) {
        const [at, length] = [view.getUint32(vectors + 8 * i, true), view.getUint32(vectors + 8 * i + 4, true)];
        say(new TextDecoder().decode(new Uint8Array(memory().buffer, at, length)));
        size += length;
      }
      view.setUint32(written, size, true);
      return 0;
    },
    proc_exit: (code) => { throw new Error(`the module ended with ${code}`); },
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    (imports[from] ??= {})[name] = calls[name] ?? (() => kNoSuchCall);
  }
  return imports;
}

// `bytes` of the module -> { answer(head, program), catalog() }. `program` is text or bytes. A module
// that trapped is made anew.
async function openEngine(bytes, say = () => {}) {
  const module = await WebAssembly.compile(bytes);
  let doors = null;
  const start = () => {
    const instance = new WebAssembly.Instance(module, systemCalls(module, () => instance.exports.memory, say));
    instance.exports._initialize();
    doors = instance.exports;
  };
  const reply = () => new Uint8Array(doors.memory.buffer, doors.text(), doors.size());
  const call = (act) => {
    if (!doors) start();
    try {
      return act();
    } catch (error) {
      doors = null;
      throw error;
    }
  };
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  return {
    catalog: () => call(() => {
      doors.catalog();
      return JSON.parse(decoder.decode(reply()));
    }),
    // What session.hpp says of an answer, with the records' text as `records`.
    answer: (head, program) => call(() => {
      const first = encoder.encode(`${JSON.stringify(head)}\n`);
      const rest = typeof program === 'string' ? encoder.encode(program) : program;
      const at = doors.request(first.length + rest.length);
      const memory = new Uint8Array(doors.memory.buffer);
      memory.set(first, at);
      memory.set(rest, at + first.length);
      doors.answer();
      const text = decoder.decode(reply());
      const end = text.indexOf('\n');
      return { ...JSON.parse(text.slice(0, end)), records: text.slice(end + 1) };
    }),
  };
}
