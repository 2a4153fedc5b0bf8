// SPDX-License-Identifier: GPL-3.0-or-later
// CT: the arc that goes on in the direction of the motion before.
#include "expanders/sinumerik/arcs.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// The direction at the end: that of the start mirrored at the chord. The angle of the arc is twice
// that between tangent and chord.
Direction mirrored(const Machine& machine, const Arc& arc, const Vector& tangent) {
  const Plane& plane = arc.plane;
  const Vector& d = arc.chord;
  const Real along = dot(tangent, d);
  const Real share = 2 * along / dot(d, d);
  const Vector at_end{share * d.p - tangent.p, share * d.q - tangent.q};
  Direction heading{};
  heading[plane.p] = at_end.p;
  heading[plane.q] = at_end.q;
  const Real rise = way_between(machine.state.position, arc.target.to)[plane.d];
  const Real sweep = 2 * std::atan2(std::fabs(cross(tangent, d)), along);
  heading[plane.d] = rise / sweep * (at_end.length() / arc.centre.length());
  return heading;
}

}  // namespace

// SIE-CT-01, SIE-CT-02
void prepare_tangent(Machine& machine, const Block& block, Plan& plan) {
  refuse(machine, block, kArcWords | kIntermediateWords);
  refuse_rounds(machine, block);
  Arc arc{machine.plane()};
  take_end(machine, target_of(machine, block), arc);
  arc.feed = cutting_feed(machine, arc.target.to, true);
  if (machine.in_alarm()) return;
  // The direction, seen in the plane.
  constexpr Real kLeastSlope = 1e-12L;
  const Direction& before = machine.state.heading;
  const Vector tangent{before[arc.plane.p], before[arc.plane.q]};
  const bool seen = tangent.length() > kLeastSlope * std::fabs(before[arc.plane.d]);
  if (!seen || arc.chord.is_nothing()) return machine.complain(AlarmKind::kArcTangent);
  const Real across = cross(tangent, arc.chord);
  const Real along = dot(tangent, arc.chord);
  if (std::fabs(across) <= kRounding * tangent.length()) {
    const bool behind = along < 0 && !machine.has("ct-behind-accepted"_fault);
    if (behind) return machine.complain(AlarmKind::kArcTangent);
    return plan_line(machine, arc.target, arc.feed, plan);
  }
  const bool other = machine.has("ct-other-side"_fault);
  arc.centre = on_bisector(arc.chord, (other ? -along : along) / across);
  arc.counterclockwise = (across > 0) != other;
  const bool of_start = machine.has("ct-tangent-of-start"_fault);
  const Direction heading = of_start ? before : mirrored(machine, arc, tangent);
  plan_arc(machine, arc, arc.counterclockwise ? 1 : -1, heading, plan);
}

}  // namespace gonogo::expanders::sinumerik
