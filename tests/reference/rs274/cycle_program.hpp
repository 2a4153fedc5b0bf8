// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small programs of hole cycles and the ways in which one of them can be written. Lengths are
// thousandths.
#pragma once

#include <iosfwd>

#include "ngc_trace.hpp"
#include "tests/reference/axes_change.hpp"

namespace gonogo::reference::testing::ngc {

// A hole, or without a cycle a traverse to it.
struct HoleStep {
  int code = 0;  // 0: G0, and else that of the cycle
  std::array<std::int64_t, 2> place = {0, 0};
  std::int64_t r_plane = 0;  // of a traverse the level to which it leads
  std::int64_t bottom = 0;
  std::int64_t peck = 1;   // Q
  std::int64_t dwell = 0;  // P, thousandths of a second
  bool to_initial_level = false;

  bool is_cycle() const { return code != 0; }
};

struct HoleProgram {
  std::array<std::int64_t, 3> start = {0, 0, 0};
  std::vector<HoleStep> steps;
};

// Up to six steps; steps repeat much of the one before. All words are right.
rc::Gen<HoleProgram> hole_programs();

struct HoleWriting {
  Plane plane = Plane::g17;
  bool incremental = false;
  bool inch = false;
  bool inch_in_mm = false;     // the lengths of an inch program in millimetres
  bool without_known = false;  // words are left out that are in force
  std::uint64_t shuffled = 0;  // the seed of the order of words; 0: none
};

// Each step is a line of its own, behind two others. `ends`: where the tool stands after each step,
// in the lengths of the program, which increments need.
std::string write(const HoleProgram& program, const HoleWriting& writing,
                  const std::vector<std::array<Number, 3>>& ends = {});
Profile machine(const HoleProgram& program, const HoleWriting& writing);

void operator<<(std::ostream& out, const HoleProgram& program);

}  // namespace gonogo::reference::testing::ngc
