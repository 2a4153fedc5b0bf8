// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes of a block of the HNC-21T lathe.
#pragma once

#include "reference/g_codes.hpp"

namespace gonogo::reference::hnc21t {

// The codes of one block, by group; -1: none.
struct BlockCodes {
  int once = -1;       // 4, 92
  int motion = -1;     // 0, 1, 2, 3, 32, 74, 75, 80, 81, 82
  int plane = -1;      // 17, 18, 19
  int units = -1;      // 20, 21
  int diameter = -1;   // 36, 37
  int offset = -1;     // 54 to 59
  int distance = -1;   // 90, 91
  int feed_mode = -1;  // 94, 95
};

struct CodeReading : GCodeReading {
  BlockCodes codes;
};
void read_codes(const grammar::Block& block, CodeReading& reading);

// What a block with these codes runs while the motion of this number is in force. Null: none.
const Code* code_that_runs(const BlockCodes& codes, int motion);

}  // namespace gonogo::reference::hnc21t
