// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::hnc {

/// Groups of G codes: at most one of each in a block, any number of kFree.
enum class Group : std::uint8_t {
  kMotion,
  kOnce,      // for their block
  kDistance,  // G90, G91
  kUnits,     // G20, G21
  kDiameter,  // G36, G37
  kFrame,     // G54 to G59
  kFeedMode,  // G94, G95
  kPlane,     // G17 to G19
  kRadius,    // G40 to G42
  kSpindle,   // G96, G97
  kPathMode,  // G61, G64
  kFree
};
inline constexpr std::size_t kGroups = 12;

enum class Support : std::uint8_t {
  kFull,
  kNoEffect,  // accepted, changes no path
  kOutside    // the control has it, this expander not
};

/// A code that the control has.
struct Code {
  std::uint8_t number;
  Group group;
  Support support;
};

/// Null: the control has no such code. `number` is the value of the G word.
const Code* find_code(const Decimal& number);

}  // namespace gonogo::expanders::hnc
