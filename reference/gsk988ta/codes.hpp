// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes of the GSK 988TA: their groups, and what the gauge makes of them.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "grammar/ast.hpp"
#include "reference/g_codes.hpp"

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
// The codes that the gauge does not read, and those that it passes over.
std::span<const OutsideCode> outside_codes();
std::span<const std::string_view> codes_without_effect();
// Whether two codes of one group stand in the block.
bool repeats_group(const grammar::Block& block);

}  // namespace gonogo::reference::gsk988ta
