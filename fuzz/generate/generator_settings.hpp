// SPDX-License-Identifier: GPL-3.0-or-later
//
// What generated programs are like: one set of settings for every dialect and for everything that
// generates programs (RapidCheck, libFuzzer, soak, hunt). A program is a function of the decisions
// and these; with the defaults, a seed's program is the same as ever.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace gonogo::generate {

enum class ProgramKind : std::uint8_t {
  // Nothing is put wrong on purpose. It may alarm: its lengths are drawn at random.
  valid,
  // The same, with one thing put wrong in some blocks: a word missing, twice, of another sign, ...
  near_invalid,
  // The same as valid, with values moved to where a rule of the dialect may turn over: to another
  // value of the block, its double or its half, and the least increments beside.
  boundary,
  // Words of the dialect's dictionary and numbers in any spelling, without regard to meaning.
  raw,
  // The same as valid, with every other length a few least increments: about as much as a subject
  // may be off, where a motion is hardly one.
  tiny,
};
inline constexpr int kProgramKinds = 5;

// How often each kind is drawn, against the others. REQUIRES: not all 0, each at most
// kMostOfASetting. Where the sum is 1 drawing takes no decision.
struct KindWeights {
  std::uint32_t valid = 0;
  std::uint32_t near_invalid = 1;
  std::uint32_t boundary = 0;
  // Not by default: numbers may be out of domain (D-DOM-01).
  std::uint32_t raw = 0;
  std::uint32_t tiny = 0;
};

// What of the machine may differ from the dialect's defaults; a dialect ignores what it lacks.
struct MachineSettings {
  bool state = true;       // units and state at power-on, increment, diameters, block skip
  bool readings = true;    // alternatives that are not the default
  bool parameters = true;  // machine parameters
  bool offsets = true;     // work offsets (hnc21t)
  bool tools = true;       // radii drawn at random (sinumerik802s); else tools of fixed radii
};

struct GeneratorSettings {
  KindWeights kinds;
  // Blocks after the head, at most; a chain of arcs counts as one. Without it the dialect's own: 8
  // of gsk988ta and hnc21t, 10 of rs274, 12 of the SINUMERIKs. REQUIRES: at least 1.
  std::optional<int> most_blocks;
  // For near_invalid: one block in so many has one thing put wrong. REQUIRES: at least 1.
  std::uint32_t fault_one_in = 12;
  // One program in so many leaves open a part of what the dialect leaves open, and any alternative
  // will do; else they are as shown, but perhaps for one: left open together they may be more ways
  // than a judge follows. REQUIRES: at least 1, with which nothing is chosen.
  std::uint32_t open_one_in = 1;
  MachineSettings machine;
  // What a rule of the dialect refuses is written now and then, by every kind; false: nowhere, as
  // far as a writer knows. No setting of read_settings: `gonogo generate --valid` alone turns it
  // off (valid_programs.hpp).
  bool refused = true;
  bool pockets = true;  // cycles whose levels are judged by region: G110, G111, LCYC75

  // Bounds of cycles, REQUIRES: each at least 1. They keep a program at some hundred motions.
  int turns = 4;   // of an arc
  int rings = 8;   // (I - D) / L of a pocket
  int layers = 4;  // of a pocket
  int pecks = 8;   // of a hole or plunge whose depth is an increment
  int steps = 6;   // axial steps of a groove
  int starts = 4;  // of a thread
};

// For the differential fuzz targets: every kind that the built-in expanders are right for. How long
// a program is the engine's -max_len says, since it ends with the decisions.
GeneratorSettings in_process_settings();

// The range of numbers in read_settings.
inline constexpr std::uint32_t kMostOfASetting = 1'000;
// "raw=1,near-invalid=0,blocks=4,readings=off" changes those settings: numbers are named valid,
// near-invalid, boundary, raw, tiny, blocks, fault-one-in, open-one-in, turns, rings, layers,
// pecks, steps, starts; state, readings, parameters, offsets, tools, pockets are on or off. Nothing
// where a word is none of these, or where no kind is left.
std::optional<GeneratorSettings> read_settings(std::string_view text,
                                               GeneratorSettings settings = {});

}  // namespace gonogo::generate
