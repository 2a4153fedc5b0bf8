// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page's worker: the module away from what is seen, so that a program that runs for ever can be
// stopped.
'use strict';

let engine = null;
self.onmessage = async ({ data: { id, bytes, head, program } }) => {
  try {
    if (bytes) {
      engine = await openEngine(bytes);
      self.postMessage({ id, result: engine.catalog() });
    } else {
      self.postMessage({ id, result: engine.answer(head, program) });
    }
  } catch (error) {
    self.postMessage({ id, failure: String(error) });
  }
};
