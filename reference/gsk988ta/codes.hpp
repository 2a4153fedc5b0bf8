// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes of a block of the GSK 988TA.
#pragma once

#include "grammar/ast.hpp"
#include "reference/g_codes.hpp"

namespace gonogo::reference::gsk988ta {

// The codes of one block, by group.
struct BlockCodes {
  int once = -1;       // 4, 28, 50
  int motion = -1;     // 0, 1, 2, 3, 90, 92, 94
  int cycle = -1;      // 80, 110 to 117
  int feed_mode = -1;  // 98, 99
  int units = -1;      // 20, 21
  int plane = -1;      // 17, 18, 19
};

// The G words of a block; `last_wins`: the later of two codes of a group holds.
struct CodeReading : GCodeReading {
  BlockCodes codes;
};
void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading);
// Whether two codes of one group stand in the block.
bool repeats_group(const grammar::Block& block);

// The row of the code of this number; null: there is none.
const Code* code_of(int number);

}  // namespace gonogo::reference::gsk988ta
