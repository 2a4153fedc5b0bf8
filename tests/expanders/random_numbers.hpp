// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers at random for the properties.
#pragma once

#include <rapidcheck.h>

namespace gonogo::expanders::testing {

/// Both ends included.
inline long between(long lowest, long highest) {
  return *rc::gen::inRange(lowest, highest + 1);
}

}  // namespace gonogo::expanders::testing
