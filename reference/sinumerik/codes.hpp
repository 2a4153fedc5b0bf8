// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes and the names of a block of SINUMERIK.
#pragma once

#include <cstdint>
#include <optional>

#include "reference/g_codes.hpp"

namespace gonogo::reference::sinumerik {

// Which control it is. The 802S shares the path commands of the 840D.
enum class Control : std::uint8_t { sinumerik840d, sinumerik802s };

// SIE-MOD-01: one modal group, two of them by name.
enum class Motion : std::uint8_t {
  traverse,          // G0
  line,              // G1
  clockwise,         // G2
  counterclockwise,  // G3
  intermediate,      // CIP
  tangent,           // CT
};

// A name that calls a cycle of the 802S.
enum class Cycle : std::uint8_t { none, lcyc75, lcyc82 };

// The codes of one block, by group; -1: none.
struct BlockCodes {
  int once = -1;  // 4, 110, 111, 112; of the 802S 158, 258, 259
  bool several_once = false;
  Cycle cycle = Cycle::none;
  std::optional<Motion> motion;
  int plane = -1;               // 17, 18, 19
  int units = -1;               // 70, 71
  int dimension = -1;           // 90, 91
  int feed_mode = -1;           // 94, 95, 96, 97, 961, 971
  bool without_offset = false;  // G53
};

struct CodeReading : GCodeReading {
  BlockCodes codes;
  std::vector<Warning> warnings;  // of names that are ignored
};
// What the names and G codes of a block are. Names that the control lacks become alarms as well as
// codes that it lacks.
void read_codes(Control control, const grammar::Block& block, CodeReading& reading);

// The number of a G code that holds once: a dwell, a pole, a frame. Nothing for other words.
std::optional<int> once_code_of(const grammar::Block& block, const grammar::NamedWord& word);
// A name that calls a cycle; `none` for others.
Cycle cycle_of(const grammar::NamedWord& word);

}  // namespace gonogo::reference::sinumerik
