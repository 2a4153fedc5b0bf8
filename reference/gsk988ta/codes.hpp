// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes of the GSK 988TA: their groups, and what the gauge makes of them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/outcome.hpp"

namespace gonogo::reference::gsk988ta {

// Modal groups by what they govern; `once` is the maker's group 00.
enum class Group : std::uint8_t {
  once,
  motion,
  speed,
  feed_mode,
  units,
  compensation,
  cycle,
  offset,
  plane,
  path_mode,
  stroke,
  macro,
};

enum class Treatment : std::uint8_t { read, without_effect, outside };

struct Code {
  int tenths;  // 10 times the code: G7.1 is 71, G94 is 940
  Group group;
  Treatment treatment;
  std::string_view title;
};

// The code, or nothing when the control lacks it.
const Code* find_code(const grammar::Decimal& value);
std::string code_name(int tenths);

// The codes of one block, by group.
struct BlockCodes {
  int once = -1;       // 4, 28, 50
  int motion = -1;     // 0, 1, 2, 3, 90, 92, 94
  int cycle = -1;      // 80, 110 to 117
  int feed_mode = -1;  // 98, 99
  int units = -1;      // 20, 21
  int plane = -1;      // 17, 18, 19
};

// Reads the G words of a block. Undefined codes and two codes of one group become alarms
// (`last_wins`: the later of two holds); a code that is not read ends the program for the gauge.
struct CodeReading {
  BlockCodes codes;
  std::vector<Alarm> alarms;
  std::optional<NotCovered> not_covered;
};
void read_codes(const grammar::Block& block, bool last_wins, CodeReading& reading);
// Whether two codes of one group stand in the block.
bool repeats_group(const grammar::Block& block);

}  // namespace gonogo::reference::gsk988ta
