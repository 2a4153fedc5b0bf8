// SPDX-License-Identifier: GPL-3.0-or-later
// The head of every hole cycle: to the hole and to R.
#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {
namespace {

// NGC-CYC-11: once a block. Reading ngc.cycle.approach: by the initial level instead of the tool.
bool lift(const Hole& hole) {
  const Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  const bool by_initial = machine.follows("ngc.cycle.approach=initial-level"_reading);
  const bool below = (by_initial ? cycle.initial : hole.level()) < cycle.r;
  return !machine.spares("rapid-through-stock"_fault, below) || hole.rapid(cycle.r);
}

// To the hole; `to` is the level there, for a rapid of all axes the level of the tool.
bool cross(const Hole& hole, Fixed number, Fixed to) {
  const Cycle& cycle = hole.cycle;
  const Plane& plane = *cycle.plane;
  Point place = hole.machine.state.position;
  Axes axes = 0;
  for (const std::size_t axis : {plane.p, plane.q}) {
    place[axis] = cycle.first[axis] + number * cycle.step[axis];
    axes |= axis_bit(axis);
  }
  if (cycle.polar) {
    lead_to(*cycle.polar, hole.machine.alters("polar-row-in-place"_fault, number, 0), place);
  }
  if (place[plane.d] != to) axes |= axis_bit(plane.d);
  place[plane.d] = to;
  return hole.machine.tracer.rapid(place, axes);
}

// NGC-CYC-12
bool approach(const Hole& hole, Fixed number) {
  const Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  Fixed to = hole.level();
  if (number == 0) {
    if (machine.follows("ngc.cycle.approach=initial-level"_reading) && to <= cycle.r)
      to = cycle.clear;
    if (to > cycle.r) {
      if (machine.adds("drop-before-crossing"_fault)) {
        if (!hole.rapid(cycle.r)) return false;
        to = cycle.r;
      }
      to = machine.alters("diagonal-approach"_fault, to, cycle.r);
    }
  }
  return cross(hole, number, to) && hole.rapid(cycle.r);
}

bool run(const Hole& hole) {
  switch (hole.cycle.code) {
    case Motion::kG73:
    case Motion::kG83:
      return peck(hole);
    case Motion::kG74:
    case Motion::kG84:
      return tap(hole);
    case Motion::kG81:
    case Motion::kG82:
      return drill(hole);
    default:
      return bore(hole);
  }
}

// What a planted fault makes of a bore: no motion, the tool is said to be in the hole.
bool jumps_into(Machine& machine, const Cycle& cycle) {
  const bool bores = cycle.code >= Motion::kG85;
  if (!machine.adds("g85-g89-silent"_fault, bores)) return false;
  for (const std::size_t axis : {cycle.plane->p, cycle.plane->q}) {
    machine.state.position[axis] = cycle.first[axis];
  }
  machine.state.position[cycle.plane->d] = cycle.bottom;
  return true;
}

}  // namespace

// NGC-CYC-13, 14
bool run_cycle(Machine& machine, const Cycle& planned) {
  if (planned.count == 0 || jumps_into(machine, planned)) return true;
  Cycle cycle = planned;
  const Hole hole{machine, cycle};
  if (!lift(hole)) return false;
  if (cycle.extent == Cycle::kLift) return true;
  for (Fixed number = 0; number < cycle.count; ++number) {
    if (!approach(hole, number)) return false;
    if (cycle.extent == Cycle::kApproach) return true;
    if (!run(hole)) return false;
    cycle.r += cycle.drift;
    cycle.bottom += cycle.drift;
    cycle.clear += cycle.drift;
  }
  return true;
}

}  // namespace gonogo::expanders::ngc
