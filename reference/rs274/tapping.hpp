// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/rs274/hole_block.hpp"

namespace gonogo::reference::rs274 {

// What the two taps differ in.
struct Tap {
  int forward;            // the M function of the sense in which it goes in
  int backward;           // and out
  std::string_view hand;  // "right-hand"
};

// Tapping with a floating chuck, G84 and G74.
void run_tap(BlockContext& block, const Tap& tap);

}  // namespace gonogo::reference::rs274
