#!/usr/bin/env node
// SPDX-License-Identifier: MIT-0
//
// gonogo_replay.mjs VECTORS... --traces DIR [--tolerance MM]
//
// Judges recorded outcomes against conformance vectors without the gauge (Node 18 or later, no packages).
// VECTORS: vector files, or folders of them. DIR: what `gonogo certify --traces DIR` keeps, <id>.jsonl a case
// and subject.json. A line a case: GO, NO-GO, OPEN (this reader does not decide it) or SKIP, the id, and why.
// Exit code 1 when one is NO-GO, 2 for wrong use.
//
// It follows closed paths, alarms and ends. It says OPEN of a departure where a manual leaves the path open,
// of arcs in pieces or as chords, and of what no text states. M functions are not compared. docs/replay.md has
// the rules and the traps; gonogo_replay.py says the same of every vector.
import { existsSync, readFileSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const AXES = [..."xyzac"];
const PLANES = { G17: "xy", G18: "zx", G19: "yz" };
const RESOLUTION = {
  gsk988ta: "0.001", hnc21t: "0.001", sinumerik802s: "0.001", sinumerik840d: "0.001", rs274: "0.0001",
};
const RENAMES = /G0*(50|92)(?![0-9.])/i;

class Departs extends Error {} // the subject does something else
class Open extends Error {} // this reader cannot tell

const gcd = (a, b) => {
  while (b) [a, b] = [b, a % b];
  return a < 0n ? -a : a;
};

// A fraction n/d of whole numbers, d above 0.
class Fraction {
  constructor(n, d = 1n) {
    const common = d === 1n ? 1n : gcd(n, d);
    [this.n, this.d] = common > 1n ? [n / common, d / common] : [n, d];
  }
  plus(other) {
    return new Fraction(this.n * other.d + other.n * this.d, this.d * other.d);
  }
  minus(other) {
    return new Fraction(this.n * other.d - other.n * this.d, this.d * other.d);
  }
  times(other) {
    return new Fraction(this.n * other.n, this.d * other.d);
  }
  over(other) {
    return other.n < 0n
      ? new Fraction(-this.n * other.d, this.d * -other.n)
      : new Fraction(this.n * other.d, this.d * other.n);
  }
  abs() {
    return this.n < 0n ? new Fraction(-this.n, this.d) : this;
  }
  compare(other) {
    const left = this.n * other.d;
    const right = other.n * this.d;
    return left < right ? -1 : left > right ? 1 : 0;
  }
  sign() {
    return this.n < 0n ? -1 : this.n > 0n ? 1 : 0;
  }
  equals(other) {
    return this.compare(other) === 0;
  }
  toString() {
    return String(Number(this.n) / Number(this.d));
  }
}
const ZERO = new Fraction(0n);
const ONE = new Fraction(1n);
const max = (a, b) => (a.compare(b) < 0 ? b : a);
const min = (a, b) => (a.compare(b) > 0 ? b : a);
// Roots and enclosures are taken to 40 digits; nothing is decided closer to a limit than this.
const NEAR = new Fraction(1n, 10n ** 12n);

function isqrt(value) {
  if (value < 2n) return value;
  let root = BigInt(Math.floor(Math.sqrt(Number(value))));
  for (;;) {
    const next = (root + value / root) / 2n;
    if (next === root || next === root + 1n) break;
    root = next;
  }
  while (root * root > value) root -= 1n;
  while ((root + 1n) * (root + 1n) <= value) root += 1n;
  return root;
}

function fromText(text) {
  const ratio = /^([+-]?\d+)\/(\d+)$/.exec(text);
  if (ratio) return new Fraction(BigInt(ratio[1]), BigInt(ratio[2]));
  const hex = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)p([+-]?\d+)$/i.exec(text);
  if (hex) return scaled(hex[1], BigInt(`0x${hex[2]}${hex[3]}`), 2n, Number(hex[4]) - 4 * hex[3].length);
  const decimal = /^([+-]?)(\d*)\.?(\d*)(?:e([+-]?\d+))?$/i.exec(text);
  if (!decimal) throw new Error(`"${text}" is no number of a record.`);
  const digits = decimal[2] + decimal[3];
  return scaled(decimal[1], BigInt(digits), 10n, Number(decimal[4] ?? 0) - decimal[3].length);
}
function scaled(sign, digits, base, power) {
  const n = sign === "-" ? -digits : digits;
  return power >= 0 ? new Fraction(n * base ** BigInt(power)) : new Fraction(n, base ** BigInt(-power));
}

// The value of a number of a record, as a fraction.
function number(value) {
  if (value.root) {
    const [a, b, c] = value.root.map(fromText);
    const scale = 10n ** 40n;
    const root = new Fraction(isqrt(c.n * c.d * scale * scale), scale * c.d);
    return a.plus(b.times(root));
  }
  if (value.enclosure) {
    const [low, high] = value.enclosure.map(fromText);
    return low.plus(high).over(new Fraction(2n));
  }
  return fromText(value);
}
const position = (told) => Object.fromEntries(Object.entries(told ?? {}).map(([axis, at]) => [axis, number(at)]));

// Whether a distance is no more than the limit.
function within(difference, limit) {
  const excess = difference.abs().minus(limit);
  if (excess.sign() > 0 && excess.compare(NEAR) <= 0) {
    throw new Open("a distance is too close to the tolerance for this reader");
  }
  return excess.sign() <= 0;
}
const agree = (p, q, tau) => AXES.every((axis) => within(p[axis].minus(q[axis]), tau));

// A motion or a dwell, with both ends.
class Motion {
  constructor(record, start, isOpen) {
    this.record = record;
    this.kind = record.k;
    this.start = start;
    this.end = { ...start, ...position(record.to) };
    this.moved = new Set(Object.keys(record.to ?? {}));
    this.isOpen = isOpen; // one of many: the manual leaves it open
    if (this.kind === "arc") {
      [this.first, this.second] = PLANES[record.plane];
      this.centre = position(record.c);
    }
  }
  way(axis) {
    return this.end[axis].minus(this.start[axis]);
  }
  // Positive when the end lies up to half a turn from the start in the sense of the arc.
  turn() {
    const [p, q] = [this.first, this.second];
    const off = (at, axis) => at[axis].minus(this.centre[axis]);
    const cross = off(this.start, p).times(off(this.end, q)).minus(off(this.start, q).times(off(this.end, p)));
    return cross.sign() * Math.sign(this.record.rot);
  }
  isClosed() {
    return this.way(this.first).sign() === 0 && this.way(this.second).sign() === 0;
  }
  isNegligible(tau) {
    if (this.kind === "dwell") return number(this.record.s).sign() === 0;
    if (!agree(this.start, this.end, tau)) return false;
    if (this.kind !== "arc") return true;
    return Math.abs(this.record.rot) === 1 && !this.isClosed() && this.turn() > 0;
  }
  // About as short as the tolerance: one side may drop it and the other not.
  isShort(tau) {
    return this.kind !== "dwell" && AXES.some((axis) => this.way(axis).sign() !== 0) &&
      agree(this.start, this.end, tau.plus(tau));
  }
  // Whether the motion before it and this one are one straight motion.
  continues(before) {
    const text = (value) => JSON.stringify(value);
    const same = ["k", "b", "f", "fm", "lead", "start"];
    if (same.some((key) => text(this.record[key]) !== text(before.record[key]))) return false;
    if (this.isOpen !== before.isOpen) return false;
    const mine = AXES.filter((axis) => this.way(axis).sign() !== 0);
    if (this.kind === "rapid") {
      const theirs = AXES.filter((axis) => before.way(axis).sign() !== 0);
      return mine.length === 1 && theirs.join() === mine.join() &&
        this.way(mine[0]).sign() === before.way(mine[0]).sign();
    }
    if (this.kind !== "feed" && this.kind !== "thread") return false;
    const parallel = AXES.every((i) =>
      AXES.every((j) => this.way(i).times(before.way(j)).equals(this.way(j).times(before.way(i)))));
    return parallel &&
      AXES.reduce((sum, axis) => sum.plus(this.way(axis).times(before.way(axis))), ZERO).sign() > 0;
  }
}

// Motions and dwells in order: negligible ones dropped, those that continue joined; where it ends; whether one is
// about as short as the tolerance.
function pathOf(records, start, tau, openParts = []) {
  const motions = [];
  let [here, isShort] = [start, false];
  records.forEach((record, i) => {
    if (record.k === "m" || record.k === "end") return;
    const motion = new Motion(record, here, openParts.some((part) => part.from <= i && i < part.to));
    here = motion.end;
    isShort ||= motion.isShort(tau);
    if (motion.isNegligible(tau)) return;
    const last = motions.at(-1);
    if (last && motion.continues(last)) {
      last.end = motion.end;
      for (const axis of motion.moved) last.moved.add(axis);
    } else {
      motions.push(motion);
    }
  });
  return { motions, end: here, isShort };
}

function resolutionOf(test) {
  const fine = test.profile.increment === "ISC" ? "0.0001" : RESOLUTION[test.dialect];
  return fromText(test.profile.resolution ?? fine);
}

// A subject's outcome against one expectation.
class Judge {
  constructor(test, subject, tolerance) {
    this.test = test;
    this.blocks = subject.features.includes("blocks");
    const told = (key) => (subject.numeric?.[key] === undefined ? null : fromText(subject.numeric[key]));
    this.resolution = told("resolution");
    this.feedResolution = told("feed_resolution");
    const machine = resolutionOf(test);
    this.tau = tolerance ?? (this.resolution ? min(this.resolution, machine) : machine);
    const initial = AXES.filter((axis) => test.profile.initial?.[axis] !== undefined);
    this.start = Object.fromEntries(AXES.map((axis) => [axis, ZERO]));
    for (const axis of initial) this.start[axis] = fromText(test.profile.initial[axis]);
  }

  // Throws Departs or Open.
  judge(expectation, trace) {
    if (expectation.not_covered) throw new Open("the corpus does not cover it");
    try {
      this.follow(expectation, trace);
    } catch (departs) {
      if (departs instanceof Departs && expectation.others) {
        throw new Open(`an open reading gives other outcomes, too: ${departs.message}`);
      }
      if (departs instanceof Departs && expectation.basis === "silent") {
        throw new Open(`no text states it: ${departs.message}`);
      }
      throw departs;
    }
  }

  follow(expectation, trace) {
    const records = trace.filter((record) => record.k !== "alarm");
    const last = trace.at(-1);
    const alarm = last?.k === "alarm" ? last : null;
    const admitted = expectation.alarm?.any_of ?? [];
    const got = pathOf(records, this.start, this.tau);
    if (alarm && admitted.length > 0 && this.admits(admitted, alarm) && got.motions.length === 0 &&
        this.test.profile.alarm_timing === "program") {
      return;
    }
    const want = pathOf(expectation.records, this.start, this.tau, expectation.open);
    try {
      this.followPath(want, got.motions, position(last?.k === "end" ? last.to : {}));
    } catch (departs) {
      if (!(departs instanceof Departs) || !(want.isShort || got.isShort)) throw departs;
      throw new Open(`a motion is about as short as the tolerance: ${departs.message}`);
    }
    if (admitted.length === 0) {
      if (alarm) throw new Departs(`it alarms (${alarm.class}); no alarm is due`);
    } else if (!alarm) {
      throw new Departs(`no alarm came; ${admitted[0].class} is due`);
    } else if (!this.admits(admitted, alarm)) {
      throw new Departs(`the alarm is ${alarm.class} in line ${alarm.b}; ` +
        `${admitted[0].class} in line ${admitted[0].b} is due`);
    }
  }

  admits(admitted, alarm) {
    return admitted.some((one) => alarm.class.split(" ").includes(one.class) && (!this.blocks || one.b === alarm.b));
  }

  followPath({ motions: want, end }, got, told) {
    let at = 0;
    let progress = ZERO;
    try {
      for (const motion of got) {
        if (at === want.length) throw new Departs(`a ${motion.kind} too many, in line ${motion.record.b}`);
        progress = this.followMotion(want[at], motion, progress);
        if (progress === null) [at, progress] = [at + 1, ZERO];
      }
      if (at < want.length) throw new Departs(`a ${want[at].kind} of line ${want[at].record.b} is missing`);
      if (!agree({ ...end, ...told }, end, this.tau)) throw new Departs("it ends elsewhere");
    } catch (departs) {
      if (!(departs instanceof Departs)) throw departs;
      // The end of an open part may be elsewhere, too.
      if (want.slice(0, at + 1).some((motion) => motion.isOpen)) {
        throw new Open(`the manual leaves the path open: ${departs.message}`);
      }
      if (RENAMES.test(this.test.text)) throw new Open(`the program renames the position: ${departs.message}`);
      throw departs;
    }
  }

  // How far along `due` the subject is behind `motion`; null: at its end.
  followMotion(due, motion, progress) {
    const where = `line ${due.record.b}`;
    if (due.kind !== motion.kind) {
      const cuts = ["arc", "arc3", "feed"];
      if (cuts.includes(due.kind) && cuts.includes(motion.kind)) throw this.otherKind(due, motion, where);
      throw new Departs(`${where}: a ${due.kind} is due, a ${motion.kind} came`);
    }
    this.compareLabels(due, motion, where);
    if (due.kind === "dwell") return null;
    if (due.kind === "rapid") return this.followRapid(due, motion, where);
    if (due.kind === "arc" || due.kind === "arc3") return this.followArc(due, motion, where);
    return this.followLine(due, motion, progress, where);
  }

  otherKind(due, motion, where) {
    if (agree(due.end, motion.end, this.tau)) {
      return new Open(`${where}: a ${motion.kind} for a ${due.kind}; this reader knows no chords`);
    }
    if (due.kind === "feed") return new Departs(`${where}: a feed is due, an ${motion.kind} came`);
    return new Open(`${where}: a ${motion.kind} for a ${due.kind}`);
  }

  compareLabels(due, motion, where) {
    if (this.blocks && due.record.b !== motion.record.b) {
      throw new Departs(`${where} is due, line ${motion.record.b} came`);
    }
    if ((due.record.fm ?? "min") !== (motion.record.fm ?? "min")) {
      throw new Departs(`${where}: the feed is of another mode`);
    }
    const rounding = { f: this.feedResolution, lead: this.resolution, start: this.resolution, s: this.resolution };
    for (const [key, resolution] of Object.entries(rounding)) {
      if (due.record[key] === undefined) continue;
      const [wanted, given] = [number(due.record[key]), number(motion.record[key])];
      let difference = wanted.minus(given).abs();
      if (key === "start") {
        const turn = 360n * difference.d;
        const rest = new Fraction(difference.n % turn, difference.d);
        difference = min(rest, new Fraction(360n).minus(rest));
      }
      const allowed = max(wanted.abs().over(new Fraction(2n ** 51n)),
        (resolution ?? ZERO).over(new Fraction(2n)));
      if (difference.compare(allowed) <= 0) continue;
      if (key !== "f" && difference.compare(this.tau) <= 0) {
        throw new Open(`${where}: ${key} differs by no more than the tolerance`);
      }
      throw new Departs(`${where}: ${key} is ${wanted}, ${given} came`);
    }
  }

  followRapid(due, motion, where) {
    for (const axis of AXES) {
      const before = due.end[axis].minus(motion.start[axis]);
      const after = due.end[axis].minus(motion.end[axis]);
      if (motion.way(axis).abs().compare(this.tau) > 0 && !due.moved.has(axis)) {
        throw new Departs(`${where}: ${axis.toUpperCase()} moves in a traverse that leaves it`);
      }
      // Beyond the end, or back.
      const back = after.abs().minus(before.abs()).compare(this.tau) > 0;
      if (!within(after, this.tau) && (after.sign() * before.sign() < 0 || back)) {
        throw new Departs(`${where}: the traverse passes its end in ${axis.toUpperCase()}`);
      }
    }
    return agree(due.end, motion.end, this.tau) ? null : ZERO;
  }

  followLine(due, motion, progress, where) {
    // The stretch of the line, from 0 to 1, of which every point is within the tolerance of the end.
    let [low, high] = [ZERO, ONE];
    for (const axis of AXES) {
      const off = motion.end[axis].minus(due.start[axis]);
      const way = due.way(axis);
      if (way.sign() === 0) {
        if (within(off, this.tau)) continue;
        throw new Departs(`${where}: the ${due.kind} leaves its line in ${axis.toUpperCase()}`);
      }
      const bounds = [off.minus(this.tau).over(way), off.plus(this.tau).over(way)];
      low = max(low, min(...bounds));
      high = min(high, max(...bounds));
    }
    if (low.compare(high) > 0) {
      const longest = AXES.map((axis) => due.way(axis).abs()).reduce(max);
      if (low.minus(high).times(longest).compare(NEAR) <= 0) {
        throw new Open("a distance is too close to the tolerance for this reader");
      }
      throw new Departs(`${where}: the ${due.kind} ends elsewhere`);
    }
    if (high.compare(progress) < 0) throw new Departs(`${where}: the ${due.kind} goes back`);
    return agree(due.end, motion.end, this.tau) ? null : max(progress, low);
  }

  followArc(due, motion, where) {
    if (due.kind === "arc3") {
      const via = [due, motion].map((side) => ({ ...due.start, ...position(side.record.via) }));
      if (agree(via[0], via[1], this.tau) && agree(due.end, motion.end, this.tau)) return null;
      throw new Open(`${where}: circles in space are compared by their points alone`);
    }
    if (due.record.plane !== motion.record.plane || due.record.rot * motion.record.rot < 0) {
      throw new Departs(`${where}: the arc lies in another plane or turns the other way`);
    }
    if (Object.keys(due.centre).some((axis) => !within(due.centre[axis].minus(motion.centre[axis]), this.tau))) {
      throw new Departs(`${where}: the centre is elsewhere`);
    }
    if (!agree(due.end, motion.end, this.tau) || due.record.rot !== motion.record.rot) {
      throw new Open(`${where}: the arc comes in other pieces, or ends elsewhere`);
    }
    return null;
  }
}

// GO, NO-GO or OPEN, and why. An expectation that fits is enough: the subject may follow its readings.
export function verdict(test, subject, trace, tolerance = null) {
  const judge = new Judge(test, subject, tolerance);
  const reasons = [];
  for (const expectation of test.expect) {
    try {
      judge.judge(expectation, trace);
      return ["GO", ""];
    } catch (other) {
      if (!(other instanceof Departs || other instanceof Open)) throw other;
      reasons.push(other);
    }
  }
  const undecided = reasons.find((reason) => reason instanceof Open);
  return undecided ? ["OPEN", undecided.message] : ["NO-GO", reasons[0].message];
}

function filesBelow(name) {
  if (!statSync(name).isDirectory()) return [name];
  const found = readdirSync(name).map((entry) => join(name, entry));
  return found.flatMap((entry) => (statSync(entry).isDirectory() ? filesBelow(entry) : [entry]))
    .filter((entry) => entry.endsWith(".json"));
}

// The cases of vector files and folders, each with its dialect, features, profile and text.
export function* cases(names) {
  for (const file of names.flatMap(filesBelow).sort()) {
    const vectors = JSON.parse(readFileSync(file, "utf8"));
    if (vectors.format !== 2) throw new Error(`${file}: not a vector file of format 2.`);
    for (const { profile, features, cases: tests } of vectors.groups) {
      for (const test of tests) {
        const text = typeof test.program === "string"
          ? test.program
          : Buffer.from(test.program.base64, "base64").toString("latin1");
        yield { ...test, dialect: vectors.dialect, profile, features, text };
      }
    }
  }
}

function main(words) {
  const names = [];
  const options = {};
  while (words.length > 0) {
    const word = words.shift();
    if (word === "--traces" || word === "--tolerance") options[word.slice(2)] = words.shift();
    else names.push(word);
  }
  if (names.length === 0 || !options.traces) {
    console.error("gonogo_replay.mjs VECTORS... --traces DIR [--tolerance MM]");
    return 2;
  }
  const declaration = join(options.traces, "subject.json");
  if (!existsSync(declaration)) {
    console.error(`${declaration} is missing: name the folder that \`gonogo certify --traces\` wrote.`);
    return 2;
  }
  const subject = JSON.parse(readFileSync(declaration, "utf8"));
  const tolerance = options.tolerance ? fromText(options.tolerance) : null;
  const count = { GO: 0, "NO-GO": 0, OPEN: 0, SKIP: 0 };
  const lines = [];
  for (const test of cases(names)) {
    const declared = subject.dialects[test.dialect];
    const trace = join(options.traces, `${test.id}.jsonl`);
    let [word, why] = ["SKIP", "there is no trace of it"];
    if (!declared || !test.features.every((one) => declared.includes(one) || subject.features.includes(one))) {
      why = "the subject does not declare what it needs";
    } else if (existsSync(trace)) {
      const records = readFileSync(trace, "utf8").split("\n").filter((line) => line.trim() !== "");
      [word, why] = verdict(test, subject, records.map((line) => JSON.parse(line)), tolerance);
    }
    count[word] += 1;
    lines.push(`${word.padEnd(5)} ${test.id}${why ? `  ${why}` : ""}`);
  }
  lines.push(Object.entries(count).map(([word, times]) => `${times} ${word}`).join(", "));
  process.stdout.write(`${lines.join("\n")}\n`);
  return count["NO-GO"] > 0 ? 1 : 0;
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? "").href) process.exitCode = main(process.argv.slice(2));
