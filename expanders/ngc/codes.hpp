// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::ngc {

/// Modal groups of G codes, and that of the codes for one block: at most one of each in a block.
enum class Group : std::uint8_t {
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
inline constexpr std::size_t kGroups = 15;

enum class Support : std::uint8_t {
  kFull,
  kNoEffect,  // accepted, changes no path
  kOutside    // known, not implemented here
};

/// A code that the control has.
struct Code {
  std::uint16_t tenths;  ///< number of the G code in tenths: 911 is G91.1
  Group group;
  Support support;
};

/// Null: the control has no such code. `tenths` is ten times the value of the G word.
const Code* find_code(Fixed tenths);

enum class Function : std::uint8_t { kKnown, kOutside, kUnknown };

/// What the number of an M word stands for; `m` is whole.
Function find_function(Fixed m);

/// Modal groups of M functions, in the order in which those of a block run.
enum class FunctionGroup : std::uint8_t {
  kSignal,    // M62 to M68
  kTool,      // M6 M61
  kSpindle,   // M3 M4 M5
  kModes,     // M70 to M73
  kCoolant,   // M7 M8 M9
  kOverride,  // M48 to M53
  kStop       // M0 M1 M2 M30 M60
};
inline constexpr std::size_t kFunctionGroups = 7;

/// For a function that the control has.
FunctionGroup group_of(Fixed m);

/// Whether the function has a use for a word of this address: the numbers and values of overrides,
/// outputs, inputs and tools.
bool uses_word(Fixed m, char address);

}  // namespace gonogo::expanders::ngc
