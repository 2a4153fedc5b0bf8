// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

#include "expanders/common/fixed.hpp"
#include "expanders/sinumerik/names.hpp"

namespace gonogo::expanders::sinumerik {

/// Codes of one group exclude each other.
enum class Group : std::uint8_t {
  kMotion,  // G0 to G3, CIP, CT
  kOnce,    // G4, G110 to G112
  kPlane,
  kUnits,
  kDimension,  // G90, G91
  kFeedMode,
  kExactStop,  // G9
  kCutter,
  kSuppress,
  kFrame,
  kControl,
  kWindow,
  kProgrammedFrame,  // G158, G258, G259
  kCycle,            // LCYC75, LCYC82
  kOther
};
inline constexpr std::size_t kGroups = static_cast<std::size_t>(Group::kOther) + 1;

enum class Support : std::uint8_t {
  kFull,
  kNoEffect,  ///< on the path
  kOutside    ///< the control has it, this expander does not
};

struct Code {
  std::uint16_t number;
  Group group;
  Support support;
};

/// Numbers that stand for the two motions that have names.
inline constexpr std::uint16_t kThroughPointCode = 1001;  // CIP
inline constexpr std::uint16_t kTangentCode = 1002;       // CT
/// And for the cycles.
inline constexpr std::uint16_t kPocketCode = 1075;    // LCYC75
inline constexpr std::uint16_t kDrillingCode = 1082;  // LCYC82

/// The G code `number`, a whole number; null when the control lacks it.
const Code* find_code(Fixed number, Control control);
const Code& through_point_code();
const Code& tangent_code();
/// `name`: of a cycle.
const Code& cycle_code(std::string_view name);

}  // namespace gonogo::expanders::sinumerik
