// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small programs in the axes p, q, d of a plane, and the ways in which one of them can be written.
// Lengths are counts of the least increment.
#pragma once

#include <rapidcheck.h>

#include <array>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference/profile.hpp"

namespace gonogo::reference::testing {

using Point = std::array<std::int64_t, 3>;  // along p, q, d

enum class StepKind : std::uint8_t {
  rapid,
  feed,
  increment,  // a feed that is written as increments in every writing
  centre_arc,
  radius_arc,
  cut,     // G90, G92, G94
  pocket,  // G110, G111
  helix,   // G112, G113
  thread,  // G114 to G117
  dwell,
};
inline constexpr std::size_t kStepKinds = 10;
constexpr bool is_milling(StepKind kind) {
  return kind == StepKind::pocket || kind == StepKind::helix || kind == StepKind::thread;
}

// A word in thousandths: of a length, or of an angle or a number of turns.
struct Given {
  char address;
  std::int64_t count;
  bool is_length = true;
};

// One block of a cycle: the first of its step has the code, those that follow repeat it.
struct CycleBlock {
  int code = 0;
  bool code_stands = false;  // the code is written though it is in force
  // End point of the cut; centre and bottom of what is milled. Absolute.
  Point end = {0, 0, 0};
  std::array<bool, 3> named = {true, true, true};  // which axis words stand
  std::optional<std::int64_t> r;  // R: of the taper (along the positioning axis), to the R plane
  std::vector<Given> words;       // the others
  std::int64_t dwell = 0;         // milliseconds of a G04 ahead of the block; 0: none
};

struct Step {
  StepKind kind = StepKind::rapid;
  bool per_revolution = false;
  std::optional<std::int64_t> feed;  // F, or the milliseconds of a dwell
  // The end point of a motion, absolute; the way, for `increment`.
  Point end = {0, 0, 0};
  std::array<bool, 3> named = {true, true, true};
  int sense = -1;                               // of arcs
  std::int64_t r = 0;                           // R of the arc
  std::array<std::int64_t, 2> offset = {0, 0};  // of the arc's centre
  std::vector<CycleBlock> blocks;               // of cycles
  bool closes = false;                          // G80 follows the milling
};

struct Model {
  Point start = {0, 0, 0};
  std::vector<Step> steps;
};

// Where the machine stands. Astray: a thread was milled, so that p and q are no counts (the safe
// position and the end of the run-out); no increment can lead from there to a count.
struct Stand {
  Point at = {0, 0, 0};
  bool astray = false;
};
Stand after(const Step& step, Stand stand);
Stand after(const CycleBlock& block, StepKind kind, Stand stand);

// Programs of up to eight steps; a few of them break a rule.
rc::Gen<Model> models();

// The program elsewhere, and its mirror images.
Model translated(Model model, const Point& shift);
Model mirrored_in_q(Model model);
Model mirrored_in_d(Model model);

// What a count of the least increment is written as: 0.001 mm, 0.001 inch, or that in millimetres.
enum class Lengths : std::uint8_t { mm, inch, inch_in_mm };

// How a block that repeats a cycle is written: with the words that the model gives it; with its
// code and all retained words; or as that after a G80, so that the cycle is entered anew.
enum class Repeats : std::uint8_t { as_given, spelled_out, entered_anew };

struct Writing {
  Plane plane = Plane::g18;
  bool diameter = true;
  bool incremental = false;
  Lengths lengths = Lengths::mm;
  Repeats repeats = Repeats::as_given;
  // What belongs to the machine.
  std::string_view run_out = "any";  // the reading gsk.thread.runout
  bool flat = false;                 // the reading gsk.helix.flat
  bool run_out_parameters = false;   // 5920 and 5921 stand in for K and J
};

struct Word {
  char address;
  std::string number;
};
using Words = std::vector<Word>;  // of one block

std::vector<Words> write(const Model& model, const Writing& writing);
// The machine that a written program starts on.
Profile machine(const Model& model, const Writing& writing);
// One block a line, words apart by one space.
std::string text(const std::vector<Words>& blocks);

void operator<<(std::ostream& out, const Model& model);

}  // namespace gonogo::reference::testing
