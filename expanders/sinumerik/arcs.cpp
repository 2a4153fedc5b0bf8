// SPDX-License-Identifier: GPL-3.0-or-later
// G2 and G3 by centre, radius, opening angle or polar words.
#include <bit>
#include <cmath>
#include <numbers>

#include "expanders/sinumerik/arc_sketch.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// SIE-ARC-12: two end-point axes, of which one is the third of the plane in force, choose theirs.
const Plane& arc_plane(const Machine& machine, const Block& block) {
  const Plane& active = plane_of(machine.state.plane);
  const Axes given = axes_of(block) & kLinearAxes;
  const bool chooses = std::popcount(given) == 2 && (given & axis_bit(active.d)) != 0;
  if (!chooses || block.has(Address::kTurn) || block.has(Address::kOpeningAngle) ||
      is_polar(block) || machine.has(Fault::kEndPointPlaneIgnored)) {
    return active;
  }
  const std::size_t other = (given & axis_bit(active.p)) != 0 ? active.q : active.p;
  if (block.has(centre_address(other))) return active;
  // The third axis of the chosen plane is the one without a word.
  return other == GONOGO_X ? plane_of(19) : other == GONOGO_Y ? plane_of(18) : plane_of(17);
}

// SIE-ARC-13
int turns_of(Machine& machine, const Block& block) {
  if (!block.has(Address::kTurn)) return 1;
  const Decimal& number = block.value(Address::kTurn).number;
  if (!number.overflow && has_fraction(block, Address::kTurn)) {
    machine.complain(AlarmKind::kNotAnInteger, Address::kTurn, block);
  } else if (number.overflow || number.value < 0 || number.value > 999 * kOne) {
    machine.complain(AlarmKind::kValueOutOfRange, Address::kTurn, block);
  } else if (!machine.has(Fault::kTurnIgnored)) {
    const int more = machine.has(Fault::kTurnExtra) ? 2 : 1;
    return static_cast<int>(number.value / kOne) + more;
  }
  return 1;
}

// SIE-ARC-11
bool check_forms(Machine& machine, const Block& block, const ArcSketch& sketch) {
  const bool centre = block.has_any(kCentreWords);
  const bool radius = block.has(Address::kRadius);
  const bool angle = block.has(Address::kOpeningAngle);
  if (is_polar(block)) {
    refuse(machine, block, kArcWords);
    return !block.has_any(kArcWords);
  }
  const bool ends = (axes_of(block) & plane_axes(sketch.plane)) != 0;
  if (!centre && !radius && !(angle && ends)) {
    machine.complain(AlarmKind::kMissingWord);
    return false;
  }
  if (radius && (centre || angle)) {
    machine.complain(AlarmKind::kConflictingWords, Address::kRadius, block);
    return false;
  }
  if (angle && centre && sketch.to_plane_axis) {
    machine.complain(AlarmKind::kConflictingWords, Address::kOpeningAngle, block);
    return false;
  }
  return true;
}

// SIE-ARC-04
void take_radius(Machine& machine, const Block& block, ArcSketch& sketch) {
  const bool unscaled = machine.has(Fault::kInchCentreUnscaled);
  const Fixed radius = unscaled ? block.value(Address::kRadius).number.value
                                : length_of(machine, block, Address::kRadius);
  if (radius == 0) return machine.complain(AlarmKind::kArcRadius, Address::kRadius, block);
  if (sketch.chord.square() == 0) {
    return machine.complain(AlarmKind::kArcEndPoint, Address::kRadius, block);
  }
  // Reading sie.cr.tolerance
  const Configuration& configuration = machine.configuration;
  const Fixed tolerance = configuration.radius_tolerance ? configuration.circle_error_constant : 0;
  const bool finer = block.value(Address::kRadius).number.finer;
  const ChordFit fit =
      sketch.rounded && sketch.known && !finer
          ? fit_chord(sketch.way, magnitude(radius), tolerance)
          : fit_chord(sketch.chord, magnitude(radius), tolerance, sketch.rounded || finer);
  const bool refused = fit == ChordFit::kDiameter && machine.has(Fault::kSemicircleRefused);
  if (fit == ChordFit::kLonger || refused) {
    return machine.complain(AlarmKind::kArcRadius, Address::kRadius, block);
  }
  sketch.unclear = fit == ChordFit::kUnclear;
  const bool long_way = (radius < 0) != machine.has(Fault::kRadiusSignSwapped);
  Real side = 0;
  if (fit == ChordFit::kShorter) {
    const Wide square = squared(radius);
    side = sketch.rounded ? side_of_radius(sketch.way, static_cast<Real>(square))
                          : side_of_radius(sketch.chord, square);
  }
  if (sketch.counterclockwise == long_way) side = -side;
  if (!sketch.known || finer) {
    const Real beside = std::fmax(sketch.doubt(), 2);
    sketch.centre_doubt = doubt_on_bisector(sketch, side, beside, static_cast<Real>(radius));
  }
  put_centre(machine, on_bisector(sketch.way, side), sketch);
}

// SIE-ARC-05: above 0 and below 360 degrees.
bool check_angle(Machine& machine, const Block& block) {
  const Decimal& angle = block.value(Address::kOpeningAngle).number;
  const bool full = angle.value == kFullTurn && !angle.finer;
  if (full && machine.has(Fault::kFullAngleAccepted)) return true;
  if (angle.value > 0 && angle.value < kFullTurn) return true;
  machine.complain(AlarmKind::kValueOutOfRange, Address::kOpeningAngle, block);
  return false;
}

Fixed opening_angle(const Block& block) {
  return block.value(Address::kOpeningAngle).number.value;
}

void take_angle_and_end(Machine& machine, const Block& block, ArcSketch& sketch) {
  const bool in_range = check_angle(machine, block);
  if (sketch.chord.square() == 0) {
    machine.complain(AlarmKind::kArcEndPoint, Address::kOpeningAngle, block);
  }
  if (!in_range || machine.in_alarm()) return;
  const Real side = side_of_angle(opening_angle(block));
  const bool left = sketch.counterclockwise != machine.has(Fault::kOpeningAngleOtherSide);
  const bool finer = block.value(Address::kOpeningAngle).number.finer;
  const Real chord = std::sqrt(sketch.way.square());
  const Real beside = sketch.doubt() + (finer ? chord * std::fabs(side) * kAngleDoubt : 0);
  sketch.centre_doubt = beside * std::fabs(side);
  put_centre(machine, on_bisector(sketch.way, left ? side : -side), sketch);
}

// Faults of the axes that move along with the circle.
void spoil_helix(const Machine& machine, const Plane& plane, Target& target, const Point& from) {
  if (machine.has(Fault::kHelixFlat)) target.to[plane.d] = from[plane.d];
  if (machine.has(Fault::kHelixThirdAxisZ) && plane.number == 18 &&
      (target.axes & axis_bit(GONOGO_Y)) != 0) {
    target.to[GONOGO_Z] = target.to[GONOGO_Y];
    target.to[GONOGO_Y] = from[GONOGO_Y];
  }
}

// SIE-ARC-01
int sense_of(const Machine& machine, const ArcSketch& sketch) {
  const bool flipped = machine.has(Fault::kG18SenseFlipped) && sketch.plane.number == 18;
  return sketch.counterclockwise != flipped ? 1 : -1;
}

}  // namespace

void put_centre(Machine& machine, const Vector& from_start, ArcSketch& sketch) {
  if (std::fabs(from_start.p) > kFarthest || std::fabs(from_start.q) > kFarthest) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  const State& state = machine.state;
  const std::size_t p = sketch.plane.p;
  const std::size_t q = sketch.plane.q;
  sketch.centre = from_start;
  machine.check_distance(from_start.p, from_start.q);
  sketch.arc.centre_p = state.position[p] + to_whole(state.remainder[p] + from_start.p);
  sketch.arc.centre_q = state.position[q] + to_whole(state.remainder[q] + from_start.q);
}

// The radius at the end, turned by a quarter in the sense of the arc; the third axis moves in
// proportion to the angle.
Heading heading_of(const Machine& machine, const ArcSketch& sketch, int turns) {
  const Plane& plane = sketch.plane;
  const Vector start = Vector{} - sketch.centre;
  const Vector end = sketch.way - sketch.centre;
  const Vector radius = machine.has(Fault::kTangentOfStart) ? start : end;
  const Real sense = sketch.counterclockwise ? 1 : -1;
  Heading heading;
  heading.along[plane.p] = -sense * radius.q;
  heading.along[plane.q] = sense * radius.p;
  const auto largest = static_cast<Real>(kLargestWhole);
  heading.doubt = (sketch.doubt() + sketch.centre_doubt) / std::hypot(radius.p, radius.q);
  heading.exact = sketch.exact_centre && !sketch.rounded && std::fabs(radius.p) <= largest &&
                  std::fabs(radius.q) <= largest;
  const Real rise = straight_heading(machine.state, sketch.arc.target).along[plane.d];
  if (rise == 0) return heading;
  constexpr Real kFullTurn = 2 * std::numbers::pi_v<Real>;
  const bool full = sketch.chord.square() == 0;
  Real sweep = full ? kFullTurn : std::atan2(sense * cross(start, end), dot(start, end));
  if (sweep < 0) sweep += kFullTurn;
  heading.along[plane.d] = rise / (sweep + kFullTurn * (turns - 1));
  heading.exact = false;
  return heading;
}

void prepare_arc(Machine& machine, const Block& block, bool counterclockwise, Plan& plan) {
  const State& state = machine.state;
  refuse(machine, block, kIntermediateWords);
  const Plane& plane = arc_plane(machine, block);
  // SIE-FRM-04
  if (!machine.frame.allows(plane.number)) machine.complain(AlarmKind::kPlaneNotAllowed);
  const bool to_plane_axis = (axes_of(block) & plane_axes(plane)) != 0;
  ArcSketch sketch(plane, counterclockwise, to_plane_axis);
  const bool sound = check_forms(machine, block, sketch);
  Target& target = sketch.arc.target;
  target = is_polar(block) ? polar_target(machine, block) : cartesian_target(machine, block);
  sketch.arc.feed = cutting_feed(machine, target.to, true);
  const int turns = turns_of(machine, block);
  if (!sound || machine.in_alarm()) return;
  take_end(state, sketch);
  if (is_polar(block)) {
    take_pole_circle(machine, block, sketch);
  } else if (block.has(Address::kRadius)) {
    take_radius(machine, block, sketch);
  } else if (!block.has_any(kCentreWords)) {
    take_angle_and_end(machine, block, sketch);
  } else if (!block.has(Address::kOpeningAngle)) {
    take_centre(machine, block, sketch);
  } else if (check_angle(machine, block)) {
    take_centre_and_angle(machine, block, opening_angle(block), sketch);
  }
  if (machine.in_alarm()) return;
  const bool full = sketch.chord.square() == 0;
  if (full && machine.has(Fault::kFullCircleDropped)) return;
  target.axes |= plane_axes(plane);
  sketch.arc.plane = plane.number;
  // An opening angle so small that its end comes out as its start is no circle.
  const bool no_part =
      full && block.has(Address::kOpeningAngle) && opening_angle(block) < kFullTurn / 2;
  const int rounds = no_part ? turns - 1 : turns;
  plan.heading = heading_of(machine, sketch, turns);
  spoil_helix(machine, plane, target, state.position);
  if (rounds == 0) {
    plan.motion = Line{target, false, sketch.arc.feed};
    return;
  }
  if (sketch.centre_doubt > kSharp) machine.lacking = kFlatArc;
  if (sketch.unclear) machine.lacking = kUnclearArc;
  sketch.arc.rot = sense_of(machine, sketch) * rounds;
  plan.motion = sketch.arc;
}

Real doubt_on_bisector(const ArcSketch& sketch, Real side, Real beside, Real radius) {
  const Real chord = std::sqrt(sketch.way.square());
  // No less than what rounding makes of it near half a circle.
  const Real from_chord = std::fmax(std::fabs(side) * chord / 2, std::sqrt(chord));
  return beside * (std::fabs(side) + std::fabs(radius) / from_chord);
}

void take_end(const State& state, ArcSketch& sketch) {
  const Plane& plane = sketch.plane;
  const Target& target = sketch.arc.target;
  sketch.chord = {target.to[plane.p] - state.position[plane.p],
                  target.to[plane.q] - state.position[plane.q]};
  sketch.way = vector_of(sketch.chord);
  sketch.way.p += target.remainder[plane.p] - state.remainder[plane.p];
  sketch.way.q += target.remainder[plane.q] - state.remainder[plane.q];
  sketch.rounded = ((state.rounded | target.rounded) & plane_axes(plane)) != 0;
  sketch.known = ((state.coarse | target.coarse) & plane_axes(plane)) == 0;
  for (const std::size_t axis : {plane.p, plane.q}) {
    const Fixed reach = std::max(magnitude(target.to[axis]), magnitude(state.position[axis]));
    sketch.farthest = std::fmax(sketch.farthest, static_cast<Real>(reach));
  }
  // A place that was reckoned twice is the same place.
  const Real same = sketch.known ? fine_rounding(sketch.farthest) : Real{kRounding};
  if (sketch.rounded && sketch.way.square() <= same * same) {
    sketch.chord = {};
    sketch.way = {};
  }
}

bool perform(Machine& machine, const Arc& arc) {
  const Plane& plane = plane_of(arc.plane);
  const auto [p, q] = machine.frame.to_machine(plane, arc.centre_p, arc.centre_q);
  return machine.tracer.arc(plane, p, q, arc.rot, machine.frame.to_machine(arc.target.to),
                            machine.frame.to_machine(arc.target.axes), arc.feed);
}

}  // namespace gonogo::expanders::sinumerik
