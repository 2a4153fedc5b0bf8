// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs whose centre is given: by I J K or by the pole.
#include "expanders/sinumerik/arcs.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// Where a complaint about the circle belongs.
Address first_centre_word(const Block& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has(centre_address(axis))) return centre_address(axis);
  }
  return Address::kPolarRadius;
}

// SIE-ARC-02: from the start under G90 and G91 alike; AC( ) from the workpiece zero.
Real centre_along(const Machine& machine, const Block& block, std::size_t axis) {
  const Address address = centre_address(axis);
  if (!block.has(address)) return 0;
  const Value& value = block.value(address);
  const Real length =
      machine.has("inch-centre-unscaled"_fault) ? value.counts : length_of(machine, block, address);
  bool absolute = value.mode == Value::Mode::kAbsolute && !machine.has("centre-ac-ignored"_fault);
  if (value.mode == Value::Mode::kPlain) {
    absolute = machine.has("centre-absolute"_fault) && !machine.state.incremental;
  }
  return absolute ? length - machine.state.position[axis] : length;
}

// Less than a count, but not nothing.
bool is_trace(const Block& block, std::size_t axis) {
  if (!block.has(centre_address(axis))) return false;
  const Value& value = block.value(centre_address(axis));
  return value.number.value == 0 && (value.number.finer || value.counts != 0);
}

// False: there is no centre to go on with.
bool read_centre(Machine& machine, const Block& block, Arc& arc) {
  const Plane& plane = arc.plane;
  if (block.has(centre_address(plane.d))) {
    machine.complain(AlarmKind::kAxisNotInPlane, centre_address(plane.d), block);
  }
  if (!block.has(centre_address(plane.p)) && !block.has(centre_address(plane.q))) return false;
  arc.centre = {centre_along(machine, block, plane.p), centre_along(machine, block, plane.q)};
  const bool trace = is_trace(block, plane.p) || is_trace(block, plane.q);
  if (arc.centre.is_nothing() && !trace) {
    machine.complain(AlarmKind::kArcRadius, first_centre_word(block), block);
  }
  return !machine.in_alarm();
}

// The fault that lets the machine follow the radius of the start.
void move_end_onto_circle(const Machine& machine, Arc& arc) {
  const Vector end = arc.chord - arc.centre;
  if (end.is_nothing()) return;
  const Real ratio = arc.centre.length() / end.length();
  const Place& from = machine.state.position;
  arc.target.to[arc.plane.p] = from[arc.plane.p] + arc.centre.p + end.p * ratio;
  arc.target.to[arc.plane.q] = from[arc.plane.q] + arc.centre.q + end.q * ratio;
}

// SIE-ARC-08: by at most sqrt(0.001) rad, seen from the start.
bool turns_too_far(const Vector& given, const Vector& corrected) {
  const Real turn = std::atan2(std::fabs(cross(given, corrected)), dot(given, corrected));
  return turn > std::sqrt(Real{1} / 1000);
}

// SIE-ARC-08
void correct_centre(Machine& machine, const Block& block, Real end_radius, Arc& arc) {
  const Vector given = arc.centre;
  const Real off_chord = cross(arc.chord, given) / arc.chord.length();
  Real side = 2 * off_chord / arc.chord.length();
  if (!machine.follows("sie.arc.correct=project"_reading)) {
    const bool of_end = machine.has("correction-keeps-end-radius"_fault);
    side = side_of_radius(arc.chord, of_end ? end_radius : given.length());
    // At most half a turn about a centre on the chord itself.
    const bool left = std::fabs(off_chord) <= kRounding ? arc.counterclockwise : off_chord > 0;
    if (!left) side = -side;
  }
  arc.centre = on_bisector(arc.chord, side);
  if (turns_too_far(given, arc.centre)) {
    machine.complain(AlarmKind::kArcEndPoint, first_centre_word(block), block);
  }
}

// SIE-ARC-07: the circle about the centre, with this radius at its end.
void take_circle(Machine& machine, const Block& block, Real end_radius, Arc& arc) {
  if (arc.chord.is_nothing()) return;
  const Real start_radius = arc.centre.length();
  const Real difference = std::fabs(start_radius - end_radius);
  const auto& parameters = machine.profile.parameters;
  const Real share = machine.has("tolerance-constant-only"_fault)
                         ? 0
                         : static_cast<Real>(parameters[kCircleErrorFactor]) / kOne;
  const bool of_end = machine.has("tolerance-of-end-radius"_fault);
  const Real limit = std::fmax(static_cast<Real>(parameters[kCircleErrorConstant]),
                               share * (of_end ? end_radius : start_radius));
  const bool strict = machine.has("tolerance-equality-refused"_fault);
  const bool equal = difference <= kRounding;
  const bool apart = difference > limit + (strict ? -kRounding : kRounding);
  if (apart && !equal && !machine.has("end-point-unchecked"_fault)) {
    return machine.complain(AlarmKind::kArcEndPoint, first_centre_word(block), block);
  }
  if (machine.has("end-onto-circle"_fault)) return move_end_onto_circle(machine, arc);
  if (equal || apart || machine.follows("sie.arc.correct=programmed"_reading)) return;
  correct_centre(machine, block, end_radius, arc);
}

}  // namespace

void take_centre(Machine& machine, const Block& block, Arc& arc) {
  if (!read_centre(machine, block, arc)) return;
  take_circle(machine, block, (arc.chord - arc.centre).length(), arc);
}

void take_centre_and_angle(Machine& machine, const Block& block, Real angle, Arc& arc) {
  if (!read_centre(machine, block, arc)) return;
  if (machine.has("ar-complement"_fault)) angle = kFullTurn - angle;
  const Vector turn = direction_of((arc.counterclockwise ? angle : -angle) / kOne);
  const Vector end = turned(Vector{} - arc.centre, turn) - (Vector{} - arc.centre);
  const Place& from = machine.state.position;
  Target target = arc.target;
  target.to[arc.plane.p] = from[arc.plane.p] + end.p;
  target.to[arc.plane.q] = from[arc.plane.q] + end.q;
  if (!in_reach(target.to[arc.plane.p]) || !in_reach(target.to[arc.plane.q])) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  take_end(machine, target, arc);
}

// SIE-ARC-06: RP is the radius at the end.
void take_pole_circle(Machine& machine, const Block& block, Arc& arc) {
  const State& state = machine.state;
  const Place& from = state.position;
  arc.centre = {state.pole.p - from[arc.plane.p], state.pole.q - from[arc.plane.q]};
  if (arc.centre.is_nothing()) {
    return machine.complain(AlarmKind::kArcRadius, first_centre_word(block), block);
  }
  take_circle(machine, block, state.polar.radius, arc);
}

}  // namespace gonogo::expanders::sinumerik
