// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders {

/// How a step of a program went.
enum class Flow {
  kContinue,
  kAlarm,        // the machine says which
  kUnsupported,  // a note was sent
  kStopped,      // by the sink
  kEnd           // of the program
};

/// M functions that end a program.
inline constexpr bool ends_program(Fixed m) {
  return m == 2 || m == 17 || m == 30;
}

/// Stops and switch-offs run after the motion of their block, all else before.
inline constexpr bool runs_after_motion(Fixed m) {
  return ends_program(m) || m == 0 || m == 1 || m == 5 || m == 9;
}

}  // namespace gonogo::expanders
