// SPDX-License-Identifier: GPL-3.0-or-later
// G81: faces, straight and tapered.
#include "expanders/hnc/cycle.hpp"

namespace gonogo::expanders::hnc {

void prepare_face_cycle(Machine& machine, const Block& block, Plan& plan) {
  Retained& taper = machine.state.store.taper;
  const bool ignored = machine.has(Fault::kFaceTaperIgnored) && !machine.state.incremental;
  if (!ignored) take_length(machine, block, 'K', taper);
  if (is_idle(machine, block, true, true)) return;
  const CycleEnd end = cycle_end(machine, block, true, true);
  // HNC-G81-02
  const Fixed by = machine.has(Fault::kFaceTaperSign) ? -taper.value : taper.value;
  const FaceCycle cycle{{moved(machine, end.z, by), end.x, end.z}, cycle_feed(machine)};
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  plan = cycle;
}

// HNC-G81-01.
bool perform(Machine& machine, const FaceCycle& cycle) {
  Tracer& tracer = machine.tracer;
  const Point start = machine.state.position;
  if (!tracer.rapid_axis(GONOGO_Z, cycle.cut.b)) return false;  // A to B
  Point to = start;
  to[GONOGO_X] = cycle.cut.c_x;
  to[GONOGO_Z] = cycle.cut.c_z;
  const Axes both = axis_bit(GONOGO_X) | axis_bit(GONOGO_Z);
  if (!tracer.feed(to, both, cycle.feed)) return false;                        // B to C
  if (!tracer.feed_axis(GONOGO_Z, start[GONOGO_Z], cycle.feed)) return false;  // C to D
  return tracer.rapid_axis(GONOGO_X, start[GONOGO_X]);                         // D to A
}

}  // namespace gonogo::expanders::hnc
