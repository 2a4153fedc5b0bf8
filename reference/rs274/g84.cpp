// SPDX-License-Identifier: GPL-3.0-or-later
//
// G84, right-hand tapping with a floating chuck: NGC-G84-01 to NGC-G84-05 in tapping.cpp.
#include "reference/rs274/tapping.hpp"

namespace gonogo::reference::rs274 {

void run_g84(BlockContext& block) {
  run_tap(block, {.forward = 3, .backward = 4, .hand = "right-hand"});
}

}  // namespace gonogo::reference::rs274
