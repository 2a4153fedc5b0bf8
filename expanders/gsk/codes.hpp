// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::gsk {

/// Groups of G codes: at most one of each in a block.
enum class Group : std::uint8_t {
  kNonModal,  // 00
  kMotion,    // 01
  kSpindle,   // 02
  kFeedMode,  // 05
  kUnits,     // 06
  kRadius,    // 07
  kStroke,    // 09
  kCycle,     // 10
  kMacro,     // 12
  kOffset,    // 14
  kExact,     // 15
  kPlane,     // 16
  kPolar,     // 21
  kCylinder   // 22
};
inline constexpr std::size_t kGroups = 14;

enum class Support : std::uint8_t {
  kFull,
  kNoEffect,  // accepted, changes no path
  kLater      // the control has it, this expander not yet
};

/// A code that the control has. `number` is ten times the code: 71 is G7.1.
struct Code {
  std::uint16_t number;
  Group group;
  Support support;
};

/// Null: the control has no such code. `number` is the value of the G word.
const Code* find_code(const Decimal& number);

}  // namespace gonogo::expanders::gsk
