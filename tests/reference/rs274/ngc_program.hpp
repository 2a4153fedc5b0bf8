// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small RS274/NGC programs and the ways in which one of them can be written. Lengths are
// thousandths.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/profile.hpp"
#include "tests/reference/axes_change.hpp"

namespace gonogo::reference::testing::ngc {

enum class Kind : std::uint8_t { rapid, feed, centre, radius };

struct Step {
  Kind kind = Kind::rapid;
  Plane plane = Plane::g17;
  int sense = 1;  // of arcs: 1 is G3
  Vector from = {0, 0, 0};
  Vector to = {0, 0, 0};
  Vector centre = {0, 0, 0};
  std::int64_t radius = 0;  // R; of a centre: that of the arc where it is a decimal, else 0
  std::int64_t turns = 1;   // P
};

struct Program {
  Vector start = {0, 0, 0};
  std::vector<Step> steps;
  std::vector<std::pair<std::string_view, std::string_view>> readings;
};

// Programs of up to eight steps; a few of them break a rule.
rc::Gen<Program> programs();
// Lines and exact arcs, which can be walked backwards.
rc::Gen<Program> two_way_programs();
Program reversed(Program program);

struct Writing {
  AxesChange axes;
  bool incremental = false;
  bool absolute_centres = false;
  bool inch = false;
  bool inch_in_mm = false;    // the lengths of an inch program in millimetres
  bool centres_by_r = false;  // where the radius is a decimal
};

// The words of each block.
using Blocks = std::vector<std::vector<std::string>>;
Blocks write(const Program& program, const Writing& writing);
std::string text(const Blocks& blocks);
Profile machine(const Program& program, const Writing& writing);

void operator<<(std::ostream& out, const Program& program);

}  // namespace gonogo::reference::testing::ngc
