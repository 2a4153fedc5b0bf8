// SPDX-License-Identifier: GPL-3.0-or-later
// G84 and G74, with a floating chuck.
#include "expanders/ngc/cycle.hpp"

namespace gonogo::expanders::ngc {
namespace {

constexpr int other_sense(int m) {
  return m == 3 ? 4 : 3;
}

// The feeds of a tap over `place`. In G18 and G19 a planted fault takes the axes of the plane for
// X, Y and Z once more.
bool feed(const Hole& hole, const Point& place, Fixed level) {
  const Plane& plane = *hole.cycle.plane;
  Point to = place;
  to[plane.d] = level;
  Point twice = to;
  twice[plane.p] = to[GONOGO_X];
  twice[plane.q] = to[GONOGO_Y];
  twice[plane.d] = to[GONOGO_Z];
  const Point at = hole.machine.alters("tap-axes-twice"_fault, to, twice);
  const Axes axes = at == to ? axis_bit(plane.d) : kLinearAxes;
  return hole.machine.tracer.feed(at, axes, hole.cycle.feed);
}

}  // namespace

// NGC-G84-01
int sense_of_tap(const Machine& machine, Motion code) {
  return code == Motion::kG84 ? 3 : machine.alters("g74-as-g84"_fault, 4, 3);
}

// NGC-G84-02, 03
bool tap(const Hole& hole) {
  const Machine& machine = hole.machine;
  const Cycle& cycle = hole.cycle;
  const Point place = machine.state.position;
  const int back = other_sense(sense_of_tap(machine, cycle.code));
  const bool early = machine.adds("tap-dwell-first"_fault, cycle.dwell != 0);
  const bool reverses = machine.spares("tap-without-reversal"_fault);
  if (!feed(hole, place, cycle.bottom)) return false;
  if (early && !hole.dwell()) return false;
  if (reverses && !(hole.turn(5) && hole.turn(back))) return false;
  if (!early && !hole.dwell()) return false;
  if (!feed(hole, place, cycle.clear)) return false;
  if (!reverses || machine.adds("tap-without-restart"_fault)) return true;
  return hole.turn(5) && hole.turn(other_sense(back));
}

}  // namespace gonogo::expanders::ngc
