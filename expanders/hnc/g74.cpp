// SPDX-License-Identifier: GPL-3.0-or-later
// G74: deep-hole drilling on the face.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

void prepare_drill(Machine& machine, const Block& block, Plan& plan) {
  take_pecks(machine, block, false);
  if (is_idle(machine, block, false, true)) return;
  // HNC-G74-04: X and U stand there without effect, or as reading hnc.g74.x says.
  const CycleEnd end = cycle_end(machine, block, false, true);
  Pecks pecks{.axis = GONOGO_Z, .bottom = end.z, .feed = {}};
  prepare_pecks(machine, block, pecks);
  const bool takes_x = machine.follows("hnc.g74.x=first"_reading);
  const Fixed x = takes_x ? target(machine, block, GONOGO_X) : end.x;
  if (machine.in_alarm()) return;
  prepare_approach(machine, machine.follows("hnc.g74.mode3=on"_reading), pecks);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = [&machine, pecks, x] {
    if (!machine.tracer.rapid_axis(GONOGO_X, x)) return false;
    const Fixed start = machine.state.position[GONOGO_Z];
    return perform_pecks(machine, pecks) && machine.tracer.rapid_axis(GONOGO_Z, start);
  };
}

}  // namespace gonogo::expanders::hnc
