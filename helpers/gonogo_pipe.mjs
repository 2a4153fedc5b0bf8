// SPDX-License-Identifier: MIT-0
//
// The GoNoGo pipe protocol, version 1, for a subject written in JavaScript (node 18 or later, no
// packages). Copy this file beside your own and call `serve`:
//
//     import { alarm, serve } from './gonogo_pipe.mjs';
//
//     serve(() => ({
//       name: 'acme', version: '3.2.1',
//       dialects: { rs274: ['basic', 'arc'] },  // `gonogo spec --features` prints the vocabulary
//       features: ['blocks'],                   // and 'm', 'bytes'
//       numeric: { kind: 'binary64' },          // or 'fixed', 'exact'; lengths in mm, as text
//       run(program, emit) {
//         emit('rapid', { b: 1, to: { x: 10, y: 0 } });
//         return alarm('E61: feed missing', { cls: 'feed-missing', b: 2 });
//       },
//     }));
//
// `serve` answers start, configure, run, reset and stop. Standard output belongs to the protocol:
// what the subject prints through console or process.stdout goes to standard error, also while it
// is made (import in there what prints). An exception in `run` becomes the outcome `error`; the
// process lives on.

/**
 * @typedef {object} Subject
 * @property {string} name
 * @property {string} version
 * @property {Object<string, string[]>} [dialects]  the features of each dialect; left out, nothing is
 *   declared, and what run() skips is not claimed
 * @property {string[]} [features]
 * @property {string[]} [readings]  names of those that configure() knows; '*' for all. The others are
 *   never sent
 * @property {object} [numeric]  kind, resolution, feed_resolution, chord
 * @property {number} [maxInFlight]  how many runs the runner may send ahead
 * @property {(dialect: string, profile: object) => (string|null|undefined)} [configure]
 *   takes the profile (only what differs from the dialect's defaults); answers nothing, or the
 *   sentence that says which key, value or reading is not implemented
 * @property {(program: Buffer, emit: Function) => (object|undefined)} run
 *   calls emit(kind, fields) for each record, in order; returns nothing when the program ran to its
 *   end, else what alarm(), skip() or error() made. configure, run and reset may be async.
 * @property {() => void} [reset]  forgets all that earlier programs left behind
 */

const kProtocol = 1;
const kRecordsAPart = 1000;
const kLongestMessage = 1000;
const kKinds = new Set(['rapid', 'feed', 'arc', 'arc3', 'dwell', 'thread', 'm', 'end']);
const kIntegers = new Set(['b', 'rot', 'm']);
const kPositions = new Set(['to', 'c', 'via']);
const kWords = new Set(['plane', 'fm', 'clause']);

/** The outcome of a program that the subject rejects. `native` is its own number or text; `b` the line. */
export function alarm(native, { cls, b, word } = {}) {
  return { outcome: 'alarm',
    alarm: { native: String(native).slice(0, kLongestMessage), class: cls, b, word } };
}

/** The outcome of a program that needs a feature which the subject has not declared. */
export function skip(feature, message = '') {
  return { outcome: 'skip', feature, message };
}

/** The outcome of a program at which the subject itself failed. */
export function error(message) {
  return { outcome: 'error', message: String(message).slice(0, kLongestMessage) };
}

/** `value` as the protocol writes numbers: the shortest decimal that names the same double. */
export function numberText(value) {
  if (typeof value === 'string') return value;
  if (typeof value === 'bigint') return String(value);
  if (typeof value !== 'number') throw new TypeError(`${typeof value} is no number`);
  if (!Number.isFinite(value)) throw new RangeError(`${value} is no number`);
  return String(value);
}

// {root: [a, b, c]} and {enclosure: [low, high]} are numbers too.
function exactNumber(value) {
  if (value === null || typeof value !== 'object') return numberText(value);
  return Object.fromEntries(Object.entries(value).map(([form, parts]) =>
    [form, parts.map(numberText)]));
}

/** The record `kind` with its numbers as text. Fields that are undefined or null are left out. */
export function record(kind, fields) {
  if (!kKinds.has(kind)) throw new RangeError(`${kind} is no kind of record`);
  const line = { k: kind };
  for (const [key, value] of Object.entries(fields)) {
    if (value === undefined || value === null) continue;
    if (kIntegers.has(key) || kWords.has(key) || key.startsWith('x-')) line[key] = value;
    else if (kPositions.has(key)) {
      line[key] = Object.fromEntries(Object.entries(value).map(([axis, number]) =>
        [axis, exactNumber(number)]));
    } else line[key] = exactNumber(value);
  }
  return line;
}

function told(fault) {
  console.error(fault);
  return (fault instanceof Error ? `${fault.name}: ${fault.message}` : String(fault))
    .slice(0, kLongestMessage);
}

function bytesOf({ program }) {
  if (typeof program === 'string') return Buffer.from(program, 'utf8');
  const text = program?.base64;
  if (typeof text === 'string' && /^[A-Za-z0-9+/]*={0,2}$/.test(text) && text.length % 4 === 0) {
    return Buffer.from(text, 'base64');
  }
  throw new TypeError('a run needs "program", a text or {"base64": ...}');
}

/** Turns messages into replies. `write` takes one reply, an object. */
export class Server {
  #subject;
  #write;
  #configured = false;

  constructor(subject, write) {
    this.#subject = subject;
    this.#write = write;
  }

  /** Answers one line. Resolves to false when it was the last. */
  async answer(line) {
    let message;
    try {
      message = JSON.parse(line);
    } catch (fault) {
      this.#refuse(`The line is no message: ${fault.message}.`);
      return true;
    }
    switch (message?.cmd) {
      case 'stop': return false;
      case 'start': this.#start(message); break;
      case 'configure': await this.#configure(message); break;
      case 'run': await this.#run(message); break;
      case 'reset': await this.#reset(); break;
      default: this.#refuse(`There is no command ${JSON.stringify(message?.cmd)}.`);
    }
    return true;
  }

  #refuse(message) {
    this.#write({ ok: false, message: message.slice(0, kLongestMessage) });
  }

  #start({ protocol }) {
    if (!Array.isArray(protocol) || !protocol.includes(kProtocol)) {
      this.#refuse(`This subject speaks version ${kProtocol} of the protocol.`);
      return;
    }
    const { name, version, dialects, features = [], readings = [],
      numeric = { kind: 'binary64' }, maxInFlight = 16 } = this.#subject;
    this.#write({ protocol: kProtocol, subject: { name, version }, dialects, features, readings,
      numeric, max_in_flight: maxInFlight });
  }

  async #configure({ dialect, profile }) {
    this.#configured = false;
    const settings = profile ?? {};
    let refusal;
    try {
      if (this.#subject.configure) refusal = await this.#subject.configure(dialect, settings);
      else if (Object.keys(settings).length > 0) {
        refusal = 'This subject takes no profile but the default.';
      }
    } catch (fault) {
      refusal = told(fault);
    }
    if (refusal !== undefined && refusal !== null) {
      this.#refuse(refusal);
      return;
    }
    this.#configured = true;
    this.#write({ ok: true });
  }

  async #run(message) {
    const { seq } = message;
    let records = [];
    // Sent in parts, so that no program is too long.
    const emit = (kind, fields = {}) => {
      if (records.push(record(kind, fields)) < kRecordsAPart) return;
      this.#write({ seq, records, more: true });
      records = [];
    };
    let outcome;
    if (!this.#configured) {
      outcome = error('A program came before a configuration that was accepted.');
    } else {
      try {
        outcome = await this.#subject.run(bytesOf(message), emit) ?? { outcome: 'ok' };
      } catch (fault) {
        outcome = error(told(fault));
      }
    }
    this.#write({ seq, records, ...outcome });
  }

  async #reset() {
    try {
      await this.#subject.reset?.();
      this.#write({ ok: true });
    } catch (fault) {
      this.#refuse(told(fault));
    }
  }
}

// Lines end with LF only: node's readline would end them at U+2028 too, which JSON leaves as it is.
async function* linesOf(input) {
  let parts = [];
  for await (const chunk of input) {
    let begin = 0;
    for (let end; (end = chunk.indexOf(0x0a, begin)) >= 0; begin = end + 1) {
      parts.push(chunk.subarray(begin, end));
      yield Buffer.concat(parts).toString('utf8');
      parts = [];
    }
    if (begin < chunk.length) parts.push(chunk.subarray(begin));
  }
  if (parts.length > 0) yield Buffer.concat(parts).toString('utf8');
}

/**
 * Speaks the protocol on standard input and output until `stop` or the end of the input.
 * @param {() => (Subject|Promise<Subject>)} make  called once
 */
export async function serve(make) {
  const send = process.stdout.write.bind(process.stdout);
  process.stdout.write = process.stderr.write.bind(process.stderr);
  // The runner has gone; nobody is left to be told.
  process.stdout.on('error', () => process.exit(0));
  const server = new Server(await make(), (reply) => send(`${JSON.stringify(reply)}\n`));
  for await (const line of linesOf(process.stdin)) {
    if (line.trim() !== '' && !await server.answer(line)) break;
  }
  process.stdin.destroy();
}
