// SPDX-License-Identifier: GPL-3.0-or-later
// G2 and G3 by centre, radius, opening angle or polar words.
#include "expanders/sinumerik/arcs.hpp"

#include <bit>

namespace gonogo::expanders::sinumerik {
namespace {

// SIE-ARC-12: two end-point axes, of which one is the third of the plane in force, choose theirs.
const Plane& arc_plane(const Machine& machine, const Block& block) {
  const Plane& active = machine.plane();
  const Axes given = axes_of(block) & kLinearAxes;
  const bool chooses = std::popcount(given) == 2 && (given & axis_bit(active.d)) != 0;
  if (!chooses || block.has(Address::kTurn) || block.has(Address::kOpeningAngle) ||
      is_polar(block) || machine.has("end-point-plane-ignored"_fault)) {
    return active;
  }
  const std::size_t other = (given & axis_bit(active.p)) != 0 ? active.q : active.p;
  if (block.has(centre_address(other))) return active;
  const std::size_t common = other == active.p ? active.q : active.p;
  const bool one_word = block.has(centre_address(common)) && !block.has(centre_address(active.d));
  const bool radius_alone = block.has(Address::kRadius) && !block.has_any(kCentreWords);
  const bool winds = one_word || radius_alone;
  if (winds && machine.follows("sie.arc.plane=helix"_reading)) return active;
  // The third axis of the chosen plane is the one without a word.
  return other == GONOGO_X ? plane_of(19) : other == GONOGO_Y ? plane_of(18) : plane_of(17);
}

// SIE-ARC-13
int rounds_of(Machine& machine, const Block& block) {
  if (!block.has(Address::kTurn)) return 1;
  const Decimal& number = block.number(Address::kTurn);
  if (!number.overflow && (number.finer || number.value % kOne != 0)) {
    machine.complain(AlarmKind::kNotAnInteger, Address::kTurn, block);
  } else if (number.overflow || number.value < 0 || number.value > 999 * kOne) {
    machine.complain(AlarmKind::kValueOutOfRange, Address::kTurn, block);
  } else if (!machine.has("turn-ignored"_fault)) {
    return static_cast<int>(number.value / kOne) + (machine.has("turn-extra"_fault) ? 2 : 1);
  }
  return 1;
}

// SIE-ARC-16: what CR beside a centre is; neither is an error.
bool centre_counts(const Machine& machine, const Block& block) {
  return block.has_any(kCentreWords) && machine.follows("sie.cr.centre=centre"_reading);
}
bool one_counts(const Machine& machine, const Block& block) {
  return centre_counts(machine, block) || machine.follows("sie.cr.centre=radius"_reading);
}

// SIE-ARC-11
bool check_forms(Machine& machine, const Block& block, const Plane& plane) {
  const bool centre = block.has_any(kCentreWords);
  const bool radius = block.has(Address::kRadius);
  const bool angle = block.has(Address::kOpeningAngle);
  const bool ends = (axes_of(block) & plane_axes(plane)) != 0;
  if (is_polar(block)) {
    refuse(machine, block, kArcWords);
  } else if (!centre && !radius && !(angle && ends)) {
    machine.complain(AlarmKind::kMissingWord);
  } else if (radius && (angle || (centre && !one_counts(machine, block)))) {
    machine.complain(AlarmKind::kConflictingWords, Address::kRadius, block);
  } else if (angle && centre && ends) {
    machine.complain(AlarmKind::kConflictingWords, Address::kOpeningAngle, block);
  } else {
    return true;
  }
  return is_polar(block) && !block.has_any(kArcWords);
}

// SIE-ARC-04
void take_radius(Machine& machine, const Block& block, Arc& arc) {
  const Address third = centre_address(arc.plane.d);
  if (block.has(third)) machine.complain(AlarmKind::kAxisNotInPlane, third, block);
  const Real given = machine.has("inch-centre-unscaled"_fault)
                         ? block.value(Address::kRadius).counts
                         : length_of(machine, block, Address::kRadius);
  if (given == 0) return machine.complain(AlarmKind::kArcRadius, Address::kRadius, block);
  if (arc.chord.is_nothing()) {
    return machine.complain(AlarmKind::kArcEndPoint, Address::kRadius, block);
  }
  const bool forgives = machine.follows("sie.cr.tolerance=const"_reading);
  const Fixed tolerance = forgives ? machine.profile.parameters[kCircleErrorConstant] : 0;
  const Real radius = std::fabs(given);
  const Real above = arc.chord.length() - 2 * radius;
  const bool half = above >= -kRounding;
  const bool refused = half && machine.has("cr-semicircle-refused"_fault);
  if (above > static_cast<Real>(tolerance) + kRounding || refused) {
    return machine.complain(AlarmKind::kArcRadius, Address::kRadius, block);
  }
  const bool long_way = (given < 0) != machine.has("cr-sign-swapped"_fault);
  const Real side = half ? 0 : side_of_radius(arc.chord, radius);
  arc.centre = on_bisector(arc.chord, arc.counterclockwise == long_way ? -side : side);
}

// SIE-ARC-05: above 0 and below 360 degrees.
bool check_angle(Machine& machine, const Block& block) {
  const Real angle = block.value(Address::kOpeningAngle).counts;
  if (angle == kFullTurn && machine.has("ar-360-accepted"_fault)) return true;
  if (angle > 0 && angle < kFullTurn) return true;
  machine.complain(AlarmKind::kValueOutOfRange, Address::kOpeningAngle, block);
  return false;
}

// SIE-ARC-05: an arc of no angle that would move nothing, where a reading has it do just that.
bool moves_nothing(const Machine& machine, const Block& block, const Arc& arc) {
  return block.has(Address::kOpeningAngle) && block.value(Address::kOpeningAngle).counts == 0 &&
         !block.has(Address::kTurn) && arc.target.to == machine.state.position &&
         machine.follows("sie.ar.zero=none"_reading);
}

void take_angle_and_end(Machine& machine, const Block& block, Arc& arc) {
  const bool in_range = check_angle(machine, block);
  if (arc.chord.is_nothing()) {
    machine.complain(AlarmKind::kArcEndPoint, Address::kOpeningAngle, block);
  }
  if (!in_range || machine.in_alarm()) return;
  // The centre sees half the chord under half the angle.
  const Vector half = direction_of(block.value(Address::kOpeningAngle).counts / (2 * kOne));
  const bool left = arc.counterclockwise != machine.has("ar-centre-other-side"_fault);
  arc.centre = on_bisector(arc.chord, (left ? half.p : -half.p) / half.q);
}

// Faults of the axes that move along with the circle.
void spoil_helix(const Machine& machine, const Plane& plane, Target& target) {
  const Place& from = machine.state.position;
  if (machine.has("helix-flat"_fault)) target.to[plane.d] = from[plane.d];
  if (machine.has("helix-third-axis-z"_fault) && plane.number == 18 &&
      (target.axes & axis_bit(GONOGO_Y)) != 0) {
    target.to[GONOGO_Z] = target.to[GONOGO_Y];
    target.to[GONOGO_Y] = from[GONOGO_Y];
  }
}

}  // namespace

Vector on_bisector(const Vector& chord, Real side) {
  return {(chord.p - side * chord.q) / 2, (chord.q + side * chord.p) / 2};
}

Real side_of_radius(const Vector& chord, Real radius) {
  const Real length = chord.length();
  const Real rest = (2 * radius - length) * (2 * radius + length);
  return rest <= 0 ? 0 : std::sqrt(rest) / length;
}

void take_end(const Machine& machine, const Target& target, Arc& arc) {
  const Place& from = machine.state.position;
  arc.target = target;
  arc.chord = {target.to[arc.plane.p] - from[arc.plane.p],
               target.to[arc.plane.q] - from[arc.plane.q]};
  // A place that was computed twice is the same place.
  if (arc.chord.is_nothing()) arc.chord = {};
}

Direction heading_of(const Machine& machine, const Arc& arc) {
  const Plane& plane = arc.plane;
  const Vector start = Vector{} - arc.centre;
  const Vector end = arc.chord - arc.centre;
  const Vector radius = machine.has("ct-tangent-of-start"_fault) ? start : end;
  const Real sense = arc.counterclockwise ? 1 : -1;
  Direction heading{};
  heading[plane.p] = -sense * radius.q;
  heading[plane.q] = sense * radius.p;
  const Real rise = way_between(machine.state.position, arc.target.to)[plane.d];
  if (rise == 0) return heading;
  constexpr Real kTurn = 2 * std::numbers::pi_v<Real>;
  Real sweep =
      arc.chord.is_nothing() ? kTurn : std::atan2(sense * cross(start, end), dot(start, end));
  if (sweep < 0) sweep += kTurn;
  heading[plane.d] = rise / (sweep + kTurn * static_cast<Real>(arc.rounds - 1));
  return heading;
}

void plan_arc(Machine& machine, const Arc& arc, int rot, const Direction& heading, Plan& plan) {
  const Plane& plane = arc.plane;
  constexpr auto kMost = static_cast<Real>(kReach);
  if (std::fabs(arc.centre.p) > kMost || std::fabs(arc.centre.q) > kMost) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  Place centre = machine.state.position;
  centre[plane.p] += arc.centre.p;
  centre[plane.q] += arc.centre.q;
  plan = [&machine, &plane, centre, rot, target = arc.target, feed = arc.feed, heading] {
    const Point middle = machine.output(centre);
    const Point to = machine.output(target.to);
    const Axes axes = machine.frame.to_machine(target.axes);
    arrive(machine, target, heading);
    clear_untravelled(machine, plane_axes(plane));
    return machine.tracer.arc(plane, middle[plane.p], middle[plane.q], rot, to, axes, feed);
  };
}

void prepare_arc(Machine& machine, const Block& block, bool counterclockwise, Plan& plan) {
  refuse(machine, block, kIntermediateWords);
  Arc arc{arc_plane(machine, block), counterclockwise};
  // SIE-FRM-04
  if (!machine.frame.allows(arc.plane.number)) machine.complain(AlarmKind::kPlaneNotAllowed);
  const bool sound = check_forms(machine, block, arc.plane);
  take_end(machine, target_of(machine, block), arc);
  arc.feed = cutting_feed(machine, arc.target.to, true);
  arc.rounds = rounds_of(machine, block);
  if (!sound || machine.in_alarm() || moves_nothing(machine, block, arc)) return;
  if (is_polar(block)) {
    take_pole_circle(machine, block, arc);
  } else if (block.has(Address::kRadius) && !centre_counts(machine, block)) {
    take_radius(machine, block, arc);
  } else if (!block.has_any(kCentreWords)) {
    take_angle_and_end(machine, block, arc);
  } else if (block.has(Address::kOpeningAngle)) {
    if (check_angle(machine, block)) {
      take_centre_and_angle(machine, block, block.value(Address::kOpeningAngle).counts, arc);
    }
  } else {
    take_centre(machine, block, arc);
  }
  if (machine.in_alarm()) return;
  const bool full = arc.chord.is_nothing();
  if (full && machine.has("full-circle-dropped"_fault)) return;
  spoil_helix(machine, arc.plane, arc.target);
  // SIE-ARC-01
  const bool flipped = machine.has("g18-sense-flipped"_fault) && arc.plane.number == 18;
  const int rot = arc.counterclockwise != flipped ? arc.rounds : -arc.rounds;
  plan_arc(machine, arc, rot, heading_of(machine, arc), plan);
}

}  // namespace gonogo::expanders::sinumerik
