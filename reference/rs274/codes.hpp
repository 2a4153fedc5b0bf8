// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes and M functions of a block of RS274/NGC.
#pragma once

#include <cstdint>

#include "reference/g_codes.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference::rs274 {

// The codes of one block, by group; -1: none.
struct BlockCodes {
  int once = -1;          // 4
  int motion = -1;        // 0, 1, 2, 3, 80
  int plane = -1;         // 17, 18, 19
  int units = -1;         // 20, 21
  int path_mode = -1;     // 61, 64
  int distance = -1;      // 90, 91
  int arc_distance = -1;  // 90, 91: G90.1, G91.1
};

struct CodeReading : GCodeReading {
  BlockCodes codes;
};
void read_codes(const grammar::Block& block, const ReadingsInUse& readings, CodeReading& reading);

// The words that the motion of this number takes.
Letters words_of_motion(int motion);
// An M function that the language has; null: it has none of that number.
const Code* m_function(std::int64_t number);

}  // namespace gonogo::reference::rs274
