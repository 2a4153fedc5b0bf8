// SPDX-License-Identifier: GPL-3.0-or-later
//
// Small HNC programs and the ways in which one of them can be written. Lengths are true lengths,
// counts of the least increment: X is a radius.
#pragma once

#include <utility>

#include "tests/reference/gsk988ta/metamorphic_program.hpp"

namespace gonogo::reference::testing::hnc {

using Place = std::array<std::int64_t, 2>;  // along X and Z

// What a word measures, in thousandths.
enum class Measure : std::uint8_t {
  number,   // the same however lengths are written
  length,   // of either axis, without a side
  along_x,  // signed
  along_z,
  lead,  // F of a thread: a length only as a reading says
};

struct Given {
  char address;
  std::int64_t count;
  Measure measure = Measure::length;
};

struct Block {
  // A code of the motion group; or 4 (dwell), 54 to 59, 92.
  int code = 0;
  bool code_stands = false;        // the code is written though it is in force
  Place end = {0, 0};              // in the work coordinates of the block
  std::array<bool, 2> named = {};  // which axis words stand
  std::vector<Given> words;        // the others
};
constexpr bool is_motion(int code) {
  return code != 4 && (code < 54 || code > 59) && code != 92;
}

struct Program {
  Place start = {0, 0};  // in the base frame
  std::array<Place, 6> offsets = {};
  std::vector<std::pair<std::string_view, std::string_view>> readings;
  std::vector<Block> blocks;

  bool reads(std::string_view reading, std::string_view value) const;
  bool reads_any(std::string_view reading) const;  // of this name
};

// Where the machine stands, and the work offset in force.
struct Stand {
  Place at = {0, 0};  // in the base frame
  Place offset = {0, 0};

  Place work() const { return {at[0] - offset[0], at[1] - offset[1]}; }
};
// What holds after G54 at the head of the program, and after a block.
Stand stand_at_start(const Program& program);
Stand after(const Program& program, const Block& block, Stand stand);

// Programs of up to eight steps under any readings; a few of them break a rule.
rc::Gen<Program> programs();

// The same program elsewhere: the start and all work offsets move. Its text stays.
Program translated(Program program, const Place& shift);
// In the axis 0 (X) or 1 (Z): every signed length.
Program mirrored(Program program, std::size_t axis);

// How the ends of motions are written.
enum class Ends : std::uint8_t {
  absolute,  // X Z
  letters,   // U W
  g91,       // X Z under G91
  mixed,     // X W
};

struct Writing {
  Ends ends = Ends::absolute;
  bool diameter = true;
  bool by_code = false;    // G36 or G37 stands in the program, not in the profile
  bool names_g54 = false;  // also where the offset of power-on is G54
  Lengths lengths = Lengths::mm;
  bool j_as_f = false;                  // an inch lead is written in millimetres
  Repeats repeats = Repeats::as_given;  // anew: after a G00
};

std::vector<Words> write(const Program& program, const Writing& writing);
Profile machine(const Program& program, const Writing& writing);

void operator<<(std::ostream& out, const Program& program);

}  // namespace gonogo::reference::testing::hnc
