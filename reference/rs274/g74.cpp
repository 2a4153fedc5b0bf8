// SPDX-License-Identifier: GPL-3.0-or-later
//
// G74, left-hand tapping with a floating chuck: G84 in the other sense. NGC-G74-01: whether it
// takes L stands with the words of codes.
#include "reference/rs274/tapping.hpp"

namespace gonogo::reference::rs274 {

void run_g74(BlockContext& block) {
  run_tap(block, {.forward = 4, .backward = 3, .hand = "left-hand"});
}

}  // namespace gonogo::reference::rs274
