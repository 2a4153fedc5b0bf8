// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/address_set.hpp"
#include "expanders/common/codes.hpp"

namespace gonogo::expanders::ngc {

/// Modal groups of G codes, and that of the codes for one block: at most one of each in a block.
enum class Group : GroupNumber {
  kMotion,
  kOnce,         // G4, G10, G28, ...
  kPlane,        // G17 to G19
  kUnits,        // G20, G21
  kDistance,     // G90, G91
  kArcDistance,  // G90.1, G91.1
  kFeedMode,     // G93 to G95
  kCutter,       // G40 to G42.1
  kLength,       // G43 to G49
  kFrame,        // G54 to G59.3
  kControl,      // G61 to G64
  kReturn,       // G98, G99
  kSpindle,      // G96, G97
  kScale,        // G50, G51
  kLathe         // G7, G8
};

/// Null: the control has no such code. `tenths` is ten times the value of the G word.
const Code* find_code(Fixed tenths);

/// Modal groups of M functions, in the order in which those of a block run.
enum class FunctionGroup : std::uint8_t {
  kSignal,
  kTool,
  kSpindle,
  kModes,
  kCoolant,
  kOverride,
  kStop,
  kOutside  // not implemented here
};
inline constexpr std::size_t kFunctionGroups = 7;  // that are implemented

/// M functions of one kind, and the addresses of the words for which they have a use: the numbers
/// and values of overrides, outputs, inputs and tools.
struct FunctionKind {
  Fixed first;
  Fixed last;
  FunctionGroup group;
  AddressSet words;
};

/// Null: the control has no function of this number.
const FunctionKind* find_function(Fixed m);

}  // namespace gonogo::expanders::ngc
