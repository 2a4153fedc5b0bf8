// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small SINUMERIK programs and the ways in which one of them can be written. Lengths and angles are
// thousandths.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reference/profile.hpp"
#include "tests/reference/axes_change.hpp"

namespace gonogo::reference::testing::sie {

enum class Kind : std::uint8_t {
  rapid,
  feed,
  centre,        // G2 G3 I J K
  radius,        // CR=
  angle_centre,  // AR= I J K
  angle_end,     // AR= X Y Z
  pole,          // G110 G111 G112
  polar_line,    // G1 AP= RP=
  polar_arc,     // G2 G3 AP= RP=
  cip,
  ct,
};
inline constexpr std::size_t kKinds = 11;

struct Step {
  Kind kind = Kind::rapid;
  Plane plane = Plane::g17;
  int sense = 1;  // of arcs: 1 is G3
  Vector from = {0, 0, 0};
  // The tool stands where it was before and no decimal says where: end points are written absolute.
  bool astray = false;
  Vector to = {0, 0, 0};      // the third axis too
  Vector centre = {0, 0, 0};  // of arcs and of a pole; along the third axis nothing
  Vector via = {0, 0, 0};     // of CIP
  std::int64_t radius = 0;    // CR=, RP=
  std::int64_t angle = 0;     // AR=, AP=
  int turns = 0;              // TURN=
  int base = 111;             // of a pole
  Vector base_at = {0, 0, 0};

  bool is_helix() const { return turns != 0 || to[third()] != from[third()]; }
  std::size_t third() const { return index(axes_of(plane).d); }
};

struct Program {
  Vector start = {0, 0, 0};
  std::vector<Step> steps;
  std::vector<std::pair<std::string_view, std::string_view>> readings;
};

// Programs of up to eight steps under any readings; a few of them break a rule.
rc::Gen<Program> programs();
// Lines and exact arcs, which can be walked backwards.
rc::Gen<Program> two_way_programs();
Program reversed(Program program);
// The program larger or smaller, from the zero.
Program scaled(Program program, int times);

enum class Ends : std::uint8_t { absolute, incremental, ac_and_ic, mixed };
// What a thousandth is written as: of a mm, of an inch, of an inch in mm.
enum class Lengths : std::uint8_t { mm, inch, inch_in_mm };
enum class Values : std::uint8_t { constants, parameters, expressions };

struct Writing {
  AxesChange axes;
  Ends ends = Ends::absolute;
  bool absolute_centres = false;  // I=AC( )
  Lengths lengths = Lengths::mm;
  Values values = Values::constants;
  bool poles_from_zero = false;  // G111, against the program
  bool planes_by_axes = false;   // no code of a plane ahead of a flat arc
};

// The words of each block.
using Blocks = std::vector<std::vector<std::string>>;
Blocks write(const Program& program, const Writing& writing);
std::string text(const Blocks& blocks);
Profile machine(const Program& program, const Writing& writing);

// 12.5 of 12500.
std::string decimal(std::int64_t thousandths);

void operator<<(std::ostream& out, const Program& program);

}  // namespace gonogo::reference::testing::sie
