// SPDX-License-Identifier: GPL-3.0-or-later
// G74: deep-hole drilling on the face.
#include "expanders/hnc/cycle.hpp"

namespace gonogo::expanders::hnc {

void prepare_drill(Machine& machine, const Block& block, Plan& plan) {
  take_pecks(machine, block, false);
  if (is_idle(machine, block, false, true)) return;
  // HNC-G74-04: X and U stand there without effect.
  const CycleEnd end = cycle_end(machine, block, false, true);
  Drill drill;
  drill.pecks.axis = GONOGO_Z;
  drill.pecks.bottom = end.z;
  prepare_pecks(machine, block, drill.pecks);
  drill.x = end.x;
  if (machine.has(Fault::kDrillTakesX)) drill.x = target(machine, block, GONOGO_X);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = drill;
}

bool perform(Machine& machine, const Drill& drill) {
  if (!machine.tracer.rapid_axis(GONOGO_X, drill.x)) return false;
  const Fixed start = machine.state.position[GONOGO_Z];
  return perform_pecks(machine, drill.pecks) && machine.tracer.rapid_axis(GONOGO_Z, start);
}

}  // namespace gonogo::expanders::hnc
