// SPDX-License-Identifier: GPL-3.0-or-later
//
// The G and M codes of RS274/NGC: their groups, and what the gauge makes of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "reference/g_codes.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference::rs274 {

// Modal groups by what they govern; the codes of `once` hold for their block.
enum class Group : std::uint8_t {
  once,
  motion,
  plane,
  units,
  diameter,
  compensation,
  tool_length,
  offset,
  scaling,
  path_mode,
  distance,
  arc_distance,
  feed_mode,
  speed,
  retract,
};

inline constexpr int kG33Point1 = 331;

// The codes of one block, by group; -1: none.
struct BlockCodes {
  int once = -1;          // 4
  int motion = -1;        // 0 to 3, 33, kG33Point1, 73, 74, 76, 80 to 86, 89
  int plane = -1;         // 17, 18, 19
  int units = -1;         // 20, 21
  int path_mode = -1;     // 61, 64
  int distance = -1;      // 90, 91
  int arc_distance = -1;  // 90, 91: G90.1, G91.1
  int retract = -1;       // 98, 99
  // Two codes of motion stand in the block, and the words of either are its own.
  bool repeats_motion = false;
};

struct CodeReading : GCodeReading {
  BlockCodes codes;
};
void read_codes(const grammar::Block& block, const ReadingsInUse& readings, CodeReading& reading);

// The codes that the gauge does not read, and those that it passes over.
std::span<const OutsideCode> outside_codes();
std::span<const std::string_view> codes_without_effect();

// NGC-CYC-01: whether the motion is a cycle of holes.
bool is_hole_cycle(int motion);
// NGC-CYC-23, NGC-COM-02: the words that the motion takes beside those of the axes and F.
std::string_view words_of_motion(int motion);
// The same of every code of motion in the block.
bool has_motion_with(const grammar::Block& block, const ReadingsInUse& readings, char address);

// What the gauge makes of M functions.
enum class MFunction : std::uint8_t {
  undefined,
  before_motion,
  after_motion,
  ends_program,
  outside,
};
MFunction m_function(std::int64_t number);
// The modal group of a function that the control has; two of one group exclude each other in a
// block (NGC-COM-01).
int m_group(std::int64_t number);
// Whether the function takes the word for its own: overrides, outputs and inputs take P, E, L and
// Q, each some of them.
bool takes(std::int64_t m_number, char address);

}  // namespace gonogo::reference::rs274
