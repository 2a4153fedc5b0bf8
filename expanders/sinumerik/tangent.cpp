// SPDX-License-Identifier: GPL-3.0-or-later
// CT: the arc that goes on in the direction of the motion before.
#include <cmath>

#include "expanders/common/product.hpp"
#include "expanders/sinumerik/arc_sketch.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

/// The way to the end against the direction at the start.
struct Bend {
  Real across = 0;  ///< positive: to the left
  Real along = 0;
  Real off_line = 0;  ///< how far the end lies off the line of the direction
  bool straight = false;
  bool unclear = false;  ///< whether it is straight cannot be said
  bool exact = false;    ///< the two that follow are known
  Wide whole_across = 0;
  Wide whole_along = 0;
};

Bend bend_of(const Heading& heading, const ArcSketch& sketch) {
  const Vector t{heading.along[sketch.plane.p], heading.along[sketch.plane.q]};
  const bool known = sketch.known && heading.doubt == 0;
  Bend bend;
  if (heading.exact && !sketch.rounded) {
    const Chord direction{static_cast<Fixed>(t.p), static_cast<Fixed>(t.q)};
    bend.exact = true;
    bend.whole_across = cross(direction, sketch.chord);
    bend.whole_along = dot(direction, sketch.chord);
    bend.across = static_cast<Real>(bend.whole_across);
    bend.along = static_cast<Real>(bend.whole_along);
    bend.straight = bend.whole_across == 0;
    bend.unclear = bend.straight && !known;
    return bend;
  }
  const Vector& d = sketch.way;
  bend.across = cross(t, d);
  bend.along = dot(t, d);
  bend.off_line = std::fabs(bend.across) / std::hypot(t.p, t.q);
  const Real length = std::hypot(d.p, d.q);
  const Real fine = fine_rounding(length);
  bend.straight = bend.off_line <= (known ? fine : kRounding);
  // What the processor rounds of far places may hide a bend, and does not make one of this size.
  constexpr Real kDigits = 2e-19L;
  const bool told_apart = kDigits * sketch.farthest <= fine &&
                          bend.off_line <= 50 * kDigits * (sketch.farthest + length);
  bend.unclear = bend.straight && !(known && told_apart);
  return bend;
}

enum class Seen { kNot, kUnclear, kClearly };

// SIE-CT-02: the direction, seen in the plane.
Seen seen_in_plane(const Heading& heading, const Plane& plane) {
  constexpr Real kLeastSlope = 1e-12L;
  const Real in_plane = std::hypot(heading.along[plane.p], heading.along[plane.q]);
  if (in_plane == 0) return Seen::kNot;
  const Real across = std::fabs(heading.along[plane.d]);
  return heading.exact || in_plane > kLeastSlope * across ? Seen::kClearly : Seen::kUnclear;
}

// The direction at the end: that of the start mirrored at the chord. The angle of the arc is twice
// that between tangent and chord.
Heading mirrored(const State& state, const ArcSketch& sketch, const Bend& bend) {
  const Plane& plane = sketch.plane;
  const Heading& heading = state.heading;
  const Vector& d = sketch.way;
  const Real double_part = 2 * bend.along / d.square();
  Heading result;
  result.along[plane.p] = double_part * d.p - heading.along[plane.p];
  result.along[plane.q] = double_part * d.q - heading.along[plane.q];
  result.doubt = heading.doubt + 2 * sketch.doubt() / std::sqrt(d.square());
  const Real rise = straight_heading(state, sketch.arc.target).along[plane.d];
  if (rise == 0) return result;
  const Real sweep = 2 * std::atan2(std::fabs(bend.across), bend.along);
  const Real radius = std::hypot(sketch.centre.p, sketch.centre.q);
  const Real speed = std::hypot(result.along[plane.p], result.along[plane.q]);
  result.along[plane.d] = rise / sweep * (speed / radius);
  return result;
}

void make_straight(const Machine& machine, const ArcSketch& sketch, Plan& plan) {
  plan.heading = straight_heading(machine.state, sketch.arc.target);
  plan.motion = Line{sketch.arc.target, false, sketch.arc.feed};
}

// chord * along / (2 across); false: too large.
bool part_of(Fixed chord, const Bend& bend, Wide& part) {
  auto size = [](Wide value) { return value < 0 ? -value : value; };
  const Wide parts = 2 * size(bend.whole_across);
  if (!divide_product(size(bend.whole_along), size(chord), parts, part)) return false;
  const bool negative = (chord < 0) != ((bend.whole_along < 0) != (bend.whole_across < 0));
  if (negative) part = -part;
  return true;
}

// The centre to the count, from whole numbers.
void refine_centre(const State& state, const Bend& bend, ArcSketch& sketch) {
  const Chord& d = sketch.chord;
  Wide part_p = 0;
  Wide part_q = 0;
  if (!part_of(d.p, bend, part_p) || !part_of(d.q, bend, part_q)) return;
  sketch.arc.centre_p = state.position[sketch.plane.p] + d.p / 2 - part_q;
  sketch.arc.centre_q = state.position[sketch.plane.q] + d.q / 2 + part_p;
}

// Whether the centre is known well enough. What the end or the direction may be beside, and what
// the processor rounds of them, moves it by as much as the radius is more than the end lies off the
// line.
bool is_sharp(const State& state, const Bend& bend, const ArcSketch& sketch) {
  if (bend.exact) return true;
  constexpr Real kDirection = 1e-18L;
  const Real chord = std::sqrt(sketch.way.square());
  const Real beside = sketch.doubt() + chord * (state.heading.doubt + kDirection);
  const Real radius = std::hypot(sketch.centre.p, sketch.centre.q);
  return bend.off_line > 2 * beside && radius * beside <= kSharp * bend.off_line;
}

// SIE-CT-01. False: too far, and the arc no different from a line.
bool take_tangent_circle(Machine& machine, const Bend& bend, ArcSketch& sketch) {
  const bool other = machine.has(Fault::kTangentOtherSide);
  const Real side = bend.along / bend.across;
  const Vector centre = on_bisector(sketch.way, other ? -side : side);
  const Real distance = std::hypot(centre.p, centre.q);
  if (distance > kFarthest && bend.along > 0) return false;
  put_centre(machine, centre, sketch);
  // So far off a Real no longer has every count.
  const bool far = distance > static_cast<Real>(kLargest);
  if (far && bend.exact && !other && !machine.in_alarm()) {
    refine_centre(machine.state, bend, sketch);
  }
  sketch.counterclockwise = (bend.across > 0) != other;
  return true;
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
  const Seen seen = seen_in_plane(heading, plane);
  if (seen == Seen::kNot || sketch.chord.square() == 0) {
    return machine.complain(AlarmKind::kArcTangent);
  }
  const Bend bend = bend_of(heading, sketch);
  if (seen == Seen::kUnclear || bend.unclear) {
    machine.lacking = kFlatArc;
    return;
  }
  if (bend.straight) {
    const bool behind = bend.along < 0 && !machine.has(Fault::kTangentBehindAccepted);
    if (behind) return machine.complain(AlarmKind::kArcTangent);
    return make_straight(machine, sketch, plan);
  }
  if (!take_tangent_circle(machine, bend, sketch)) return make_straight(machine, sketch, plan);
  if (machine.in_alarm()) return;
  if (!is_sharp(state, bend, sketch)) machine.lacking = kFlatArc;
  target.axes |= plane_axes(plane);
  sketch.arc.plane = plane.number;
  sketch.arc.rot = sketch.counterclockwise ? 1 : -1;
  plan.heading = machine.has(Fault::kTangentOfStart) ? heading : mirrored(state, sketch, bend);
  plan.motion = sketch.arc;
}

}  // namespace gonogo::expanders::sinumerik
