// SPDX-License-Identifier: GPL-3.0-or-later
// G81 and G82.
#include <algorithm>

#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {
namespace {

// How often a loop drills that takes the whole depth off its level until that is the bottom: twice,
// where rounding leaves it above. Levels in mm, in single precision.
int count_in_floats(const Cycle& cycle) {
  constexpr int kMost = 9;
  constexpr auto kScale = static_cast<float>(kOne);
  const float end = static_cast<float>(cycle.bottom) / kScale;
  float level = static_cast<float>(cycle.r) / kScale;
  const float depth = level - end;
  int count = 0;
  for (; level > end && count < kMost; level -= depth) ++count;
  return std::max(count, 1);
}

}  // namespace

// NGC-G81-01, NGC-G82-01: without P, G81 has no dwell.
bool drill(const Hole& hole) {
  const Cycle& cycle = hole.cycle;
  int more = hole.machine.alters("levels-in-single-precision"_fault, 1, count_in_floats(cycle));
  while (--more > 0) {
    if (!hole.feed(cycle.bottom) || !hole.rapid(cycle.r)) return false;
  }
  if (!hole.feed(cycle.bottom)) return false;
  if (hole.machine.adds("dwell-after-retract"_fault, cycle.dwell != 0)) {
    return hole.rapid(cycle.clear) && hole.dwell();
  }
  return hole.dwell() && hole.rapid(cycle.clear);
}

}  // namespace gonogo::expanders::ngc
