// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes and M functions of a block of RS274/NGC.
#pragma once

#include <cstdint>

#include "reference/g_codes.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference::rs274 {

inline constexpr int kG33Point1 = 331;

// The codes of one block, by group; -1: none.
struct BlockCodes {
  int once = -1;           // tenths: 40, 100, 280, 281, 300, 301, 520, 530, 920 to 923
  int tool_length = -1;    // tenths: 430, 431, 432, 490
  int offset = -1;         // tenths: 540 to 590, 591 to 593
  int motion = -1;         // 0 to 3, 33, kG33Point1, 73, 74, 76, 80 to 86, 89
  int plane = -1;          // 17, 18, 19
  int units = -1;          // 20, 21
  int diameter = -1;       // 7, 8
  int feed_mode = -1;      // 93, 94, 95
  int speed = -1;          // 96, 97
  int path_mode = -1;      // 61, 64
  int distance = -1;       // 90, 91
  int arc_distance = -1;   // 90, 91: G90.1, G91.1
  int retract = -1;        // 98, 99
  Letters of_motions = 0;  // of the words of the codes of motion, where there are several
};

struct CodeReading : GCodeReading {
  BlockCodes codes;
};
void read_codes(const grammar::Block& block, const ReadingsInUse& readings, CodeReading& reading);

constexpr bool is_arc(int motion) {
  return motion == 2 || motion == 3;
}
// NGC-CYC-01: whether the motion is a cycle of holes.
bool is_hole_cycle(int motion);
// The words that the motion of this number takes or ignores; none of kNoMotion.
Letters words_of_motion(int motion);
// An M function that the language has; null: it has none of that number.
const Code* m_function(std::int64_t number);

}  // namespace gonogo::reference::rs274
