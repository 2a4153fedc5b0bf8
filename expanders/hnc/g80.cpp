// SPDX-License-Identifier: GPL-3.0-or-later
// G80: inside and outside diameters, straight and tapered.
#include "expanders/hnc/cycle.hpp"

namespace gonogo::expanders::hnc {

void prepare_turn_cycle(Machine& machine, const Block& block, Plan& plan) {
  Retained& taper = machine.state.store.taper;
  if (machine.has(Fault::kTurnTaperLost)) taper = {};
  take_length(machine, block, 'I', taper);
  if (is_idle(machine, block, true, true)) return;
  const CycleEnd end = cycle_end(machine, block, true, true);
  // HNC-G80-02: I is a difference of radii, whatever G36 and G91 say.
  Fixed by = taper.value;
  if (machine.has(Fault::kTurnTaperDiameter)) by /= 2;
  if (machine.has(Fault::kTurnTaperSign)) by = -by;
  TurnCycle cycle{{0, end.x, end.z}, cycle_feed(machine)};
  const bool mistaken = machine.has(Fault::kTurnAsFace);
  cycle.cut.b = moved(machine, mistaken ? end.z : end.x, by);
  if (machine.in_alarm()) return;
  keep_end(machine, end);
  if (mistaken) {
    plan = FaceCycle{cycle.cut, cycle.feed};
  } else {
    plan = cycle;
  }
}

// HNC-G80-01.
bool perform(Machine& machine, const TurnCycle& cycle) {
  Tracer& tracer = machine.tracer;
  const Point start = machine.state.position;
  if (!tracer.rapid_axis(GONOGO_X, cycle.cut.b)) return false;  // A to B
  Point to = start;
  to[GONOGO_X] = cycle.cut.c_x;
  to[GONOGO_Z] = cycle.cut.c_z;
  const Axes both = axis_bit(GONOGO_X) | axis_bit(GONOGO_Z);
  if (!tracer.feed(to, both, cycle.feed)) return false;  // B to C
  // C to D.
  const bool left = machine.has(Fault::kTurnRapidRetract)
                        ? tracer.rapid_axis(GONOGO_X, start[GONOGO_X])
                        : tracer.feed_axis(GONOGO_X, start[GONOGO_X], cycle.feed);
  return left && tracer.rapid_axis(GONOGO_Z, start[GONOGO_Z]);  // D to A
}

}  // namespace gonogo::expanders::hnc
