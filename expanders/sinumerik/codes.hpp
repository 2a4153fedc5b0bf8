// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/codes.hpp"
#include "expanders/sinumerik/names.hpp"

namespace gonogo::expanders::sinumerik {

/// Codes of one group exclude each other.
enum class Group : GroupNumber {
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
  kCycle             // LCYC75, LCYC82
};

// Codes that have names; no G code is as high.
inline constexpr Code kThroughPointCode{10'001, static_cast<GroupNumber>(Group::kMotion)};  // CIP
inline constexpr Code kTangentCode{10'002, static_cast<GroupNumber>(Group::kMotion)};       // CT
inline constexpr Code kPocketCode{10'075, static_cast<GroupNumber>(Group::kCycle)};    // LCYC75
inline constexpr Code kDrillingCode{10'082, static_cast<GroupNumber>(Group::kCycle)};  // LCYC82

/// Null: the control lacks it.
const Code* find_code(const Decimal& number, Control control);

}  // namespace gonogo::expanders::sinumerik
