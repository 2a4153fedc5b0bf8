// SPDX-License-Identifier: GPL-3.0-or-later
// G81 and G82.
#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {

// NGC-G81-01, NGC-G82-01: without P, G81 has no dwell.
bool drill(const Hole& hole) {
  const Cycle& cycle = hole.cycle;
  if (!hole.feed(cycle.bottom)) return false;
  if (hole.machine.adds("dwell-after-retract"_fault, cycle.dwell != 0)) {
    return hole.rapid(cycle.clear) && hole.dwell();
  }
  return hole.dwell() && hole.rapid(cycle.clear);
}

}  // namespace gonogo::expanders::ngc
