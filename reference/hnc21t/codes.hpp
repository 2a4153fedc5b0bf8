// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G codes of the HNC-21T lathe: their groups, and what the gauge makes of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "reference/g_codes.hpp"

namespace gonogo::reference::hnc21t {

// Modal groups by what they govern; the codes of `once` hold for their block.
enum class Group : std::uint8_t {
  once,
  motion,
  plane,
  units,
  diameter,
  compensation,
  offset,
  path_mode,
  distance,
  feed_mode,
  speed,
  retract,
};

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

// The codes that the gauge does not read, and those that it passes over.
std::span<const OutsideCode> outside_codes();
std::span<const std::string_view> codes_without_effect();

}  // namespace gonogo::reference::hnc21t
