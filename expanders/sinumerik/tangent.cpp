// SPDX-License-Identifier: GPL-3.0-or-later
// CT: the arc that goes on in the direction of the motion before.
#include <cmath>

#include "expanders/sinumerik/arc_sketch.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

/// The way to the end against the direction at the start.
struct Bend {
  double across = 0;  ///< positive: to the left
  double along = 0;
  bool straight = false;
};

Bend bend_of(const Heading& heading, const ArcSketch& sketch) {
  const Vector t{heading.along[sketch.plane.p], heading.along[sketch.plane.q]};
  Bend bend;
  if (heading.exact && !sketch.rounded) {
    const Chord direction{static_cast<Fixed>(t.p), static_cast<Fixed>(t.q)};
    const Wide across = cross(direction, sketch.chord);
    bend.across = static_cast<double>(across);
    bend.along = static_cast<double>(dot(direction, sketch.chord));
    bend.straight = across == 0;
    return bend;
  }
  const Vector d = vector_of(sketch.chord);
  bend.across = t.p * d.q - t.q * d.p;
  bend.along = t.p * d.p + t.q * d.q;
  const double off_line = std::fabs(bend.across) / std::hypot(t.p, t.q);
  bend.straight = off_line <= kRounding / 2. + 1e-12 * std::hypot(d.p, d.q);
  return bend;
}

// SIE-CT-02: the direction, seen in the plane.
bool has_direction(const Heading& heading, const Plane& plane) {
  const double in_plane = std::hypot(heading.along[plane.p], heading.along[plane.q]);
  const double across = std::fabs(heading.along[plane.d]);
  return in_plane > (heading.exact ? 0 : 1e-12 * across);
}

// The direction at the end: that of the start mirrored at the chord.
Heading mirrored(const Heading& heading, const ArcSketch& sketch, const Bend& bend) {
  const Vector d = vector_of(sketch.chord);
  const double square = d.p * d.p + d.q * d.q;
  const double double_part = 2 * bend.along / square;
  Heading result;
  result.along[sketch.plane.p] = double_part * d.p - heading.along[sketch.plane.p];
  result.along[sketch.plane.q] = double_part * d.q - heading.along[sketch.plane.q];
  return result;
}

void make_straight(const Machine& machine, const ArcSketch& sketch, Plan& plan) {
  plan.heading = straight_heading(machine.state, sketch.arc.target);
  plan.motion = Line{sketch.arc.target, false, sketch.arc.feed};
}

}  // namespace

void prepare_tangent(Machine& machine, const Block& block, Plan& plan) {
  refuse(machine, block, kArcWords | kIntermediateWords | bit(Address::kTurn));
  const State& state = machine.state;
  const Plane& plane = plane_of(state.plane);
  ArcSketch sketch(plane, false, true);
  Target& target = sketch.arc.target;
  target = is_polar(block) ? polar_target(machine, block) : cartesian_target(machine, block);
  sketch.arc.feed = cutting_feed(machine, target.to, true);
  if (machine.in_alarm()) return;
  take_end(state, sketch);
  const Heading& heading = state.heading;
  if (!heading.known() || !has_direction(heading, plane) || sketch.chord.square() == 0) {
    return machine.complain(AlarmKind::kArcTangent);
  }
  const Bend bend = bend_of(heading, sketch);
  if (bend.straight) {
    const bool behind = bend.along < 0 && !machine.has(Fault::kTangentBehindAccepted);
    if (behind) return machine.complain(AlarmKind::kArcTangent);
    return make_straight(machine, sketch, plan);
  }
  const double side = bend.along / bend.across;
  const Vector centre =
      on_bisector(sketch.chord, machine.has(Fault::kTangentOtherSide) ? -side : side);
  // An arc too flat for a centre is a line.
  if (std::hypot(centre.p, centre.q) > static_cast<double>(kLargest)) {
    return make_straight(machine, sketch, plan);
  }
  put_centre(machine, centre, sketch);
  target.axes |= plane_axes(plane);
  sketch.arc.plane = plane.number;
  sketch.counterclockwise = (bend.across > 0) != machine.has(Fault::kTangentOtherSide);
  sketch.arc.rot = sketch.counterclockwise ? 1 : -1;
  plan.heading = machine.has(Fault::kTangentOfStart) ? heading : mirrored(heading, sketch, bend);
  plan.motion = sketch.arc;
}

}  // namespace gonogo::expanders::sinumerik
