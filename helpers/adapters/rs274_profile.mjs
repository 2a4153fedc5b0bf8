// SPDX-License-Identifier: MIT-0
//
// What the adapters for the dialect rs274 say to a profile.

const isZero = (value) => value !== '' && Number(value) === 0;
// Those of which a value in kHarmless may be told.
export const kLookedAt = ['ngc.unused-words', 'ngc.program-end'];

const kHarmless = {
  units: (value) => value === 'mm',
  x_diameter: (value) => value === false,
  alarm_timing: (value) => value === 'block',
  block_skip: (value) => value === false,
  resolution: () => true,
  'initial.plane': (value) => value === 'G17',
  'initial.spindle': (value) => value === 'M5' || value === 'M05',
  // For a program that is only looked at.
  'readings.ngc.unused-words': (value) => value === 'ignored' || value === 'any',
  'readings.ngc.program-end': (value) => value === 'free' || value === 'any',
};
for (const word of ['x', 'y', 'z', 'a', 'c', 'f']) kHarmless[`initial.${word}`] = isZero;

function harmless(key) {
  if (key.startsWith('readings.')) return (value) => value === 'any';  // anything it does is right
  return key.startsWith('offsets.') ? isZero : null;
}

function* flat(profile) {
  for (const [key, value] of Object.entries(profile)) {
    if (value === null || typeof value !== 'object') {
      yield [key, value];
    } else if (key === 'readings') {
      for (const [name, choice] of Object.entries(value)) yield [`readings.${name}`, choice];
    } else {
      for (const [name, inner] of flat(value)) yield [`${key}.${name}`, inner];
    }
  }
}

/**
 * null when the dialect is rs274 and `accepted` holds for every key of `profile`, else a sentence.
 * `accepted` maps a key ('initial.x', 'units') to a test of its value. A key that it does not have
 * is refused, save a value that says what holds anyway.
 */
export function refusal(dialect, profile, accepted = {}) {
  if (dialect !== 'rs274') return `The dialect ${dialect} is not interpreted here.`;
  for (const [key, value] of flat(profile)) {
    const test = accepted[key] ?? kHarmless[key] ?? harmless(key);
    if (test === null || !test(value)) {
      return `The profile's ${key} = ${value} cannot be set in this interpreter.`;
    }
  }
  return null;
}

/** Whether a text is an ordinary decimal number. */
export const isDecimal = (value) => /^-?\d*\.?\d+$/.test(String(value));
