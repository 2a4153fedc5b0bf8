// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs whose centre is given: by I J K or by the pole.
#include <cmath>

#include "expanders/sinumerik/arc_sketch.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// Where a complaint about the circle belongs.
Address first_word(const Block& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has(centre_address(axis))) return centre_address(axis);
  }
  return Address::kPolarRadius;
}

// SIE-ARC-02: from the start, whatever G90 and G91 say; AC( ) from the workpiece zero.
Fixed centre_along(Machine& machine, const Block& block, std::size_t axis) {
  const Address address = centre_address(axis);
  if (!block.has(address)) return 0;
  const Fixed length = machine.has(Fault::kInchCentreUnscaled) ? block.value(address).number.value
                                                               : length_of(machine, block, address);
  const Value::Mode mode = block.value(address).mode;
  bool absolute = mode == Value::Mode::kAbsolute && !machine.has(Fault::kCentreAbsoluteIgnored);
  if (mode == Value::Mode::kPlain && machine.has(Fault::kCentreAbsolute)) {
    absolute = !machine.state.incremental;
  }
  return absolute ? length - machine.state.position[axis] : length;
}

// False: there is no centre to go on with.
bool read_centre(Machine& machine, const Block& block, ArcSketch& sketch, Chord& centre) {
  const Plane& plane = sketch.plane;
  if (block.has(centre_address(plane.d))) {
    machine.complain(AlarmKind::kAxisNotInPlane, centre_address(plane.d), block);
  }
  if (!block.has(centre_address(plane.p)) && !block.has(centre_address(plane.q))) return false;
  for (const std::size_t axis : {plane.p, plane.q}) {
    const Address address = centre_address(axis);
    if (block.has(address) && block.value(address).number.finer) sketch.rounded = true;
  }
  centre = {centre_along(machine, block, plane.p), centre_along(machine, block, plane.q)};
  if (centre.square() != 0) return true;
  machine.complain(AlarmKind::kArcRadius, first_word(block), block);
  return false;
}

void put_exact_centre(Machine& machine, const Chord& centre, ArcSketch& sketch) {
  constexpr Fixed kLargestWhole = Fixed{1} << 53;  // that a double holds without error
  put_centre(machine, vector_of(centre), sketch);
  sketch.exact_centre = magnitude(centre.p) < kLargestWhole && magnitude(centre.q) < kLargestWhole;
}

// The fault that lets the machine follow the radius of the start.
void move_end_onto_circle(const Machine& machine, const Chord& centre, double ratio,
                          ArcSketch& sketch) {
  const Vector end{static_cast<double>(sketch.chord.p - centre.p) * ratio,
                   static_cast<double>(sketch.chord.q - centre.q) * ratio};
  Point& to = sketch.arc.target.to;
  const Point& from = machine.state.position;
  to[sketch.plane.p] = from[sketch.plane.p] + centre.p + std::llround(end.p);
  to[sketch.plane.q] = from[sketch.plane.q] + centre.q + std::llround(end.q);
  take_end(machine.state, sketch);
}

// SIE-ARC-08
void correct_centre(Machine& machine, const Block& block, const Chord& centre, Wide radius_square,
                    ArcSketch& sketch) {
  const Chord& chord = sketch.chord;
  double side = 0;
  if (machine.configuration.correction == Correction::kProject) {
    side = side_of_projection(chord, centre);
  } else {
    const Wide where = cross(chord, centre);
    // On the chord itself: at most half a turn.
    const bool left = where == 0 ? sketch.counterclockwise : where > 0;
    side = side_of_radius(chord, radius_square);
    if (!left) side = -side;
  }
  const Vector corrected = on_bisector(chord, side);
  if (too_far_turned(vector_of(centre), corrected)) {
    return machine.complain(AlarmKind::kArcEndPoint, first_word(block), block);
  }
  put_centre(machine, corrected, sketch);
}

// SIE-ARC-07: the circle about `centre`, whose radius at the end has this square.
void take_circle(Machine& machine, const Block& block, const Chord& centre, Wide end_square,
                 ArcSketch& sketch) {
  const Wide start_square = centre.square();
  if (sketch.chord.square() == 0) return put_exact_centre(machine, centre, sketch);
  const Configuration& configuration = machine.configuration;
  const bool constant_only = machine.has(Fault::kConstantToleranceOnly);
  const RadiusTolerance tolerance{configuration.circle_error_constant,
                                  constant_only ? 0 : configuration.circle_error_factor,
                                  machine.has(Fault::kEqualityRefused)};
  const Wide reference = machine.has(Fault::kEndRadiusTolerance) ? end_square : start_square;
  const Agreement agreement =
      compare_radii(start_square, end_square, reference, tolerance, sketch.rounded);
  const bool unchecked = machine.has(Fault::kEndPointUnchecked);
  if (agreement == Agreement::kApart && !unchecked) {
    return machine.complain(AlarmKind::kArcEndPoint, first_word(block), block);
  }
  if (machine.has(Fault::kEndOntoCircle)) {
    const double ratio =
        std::sqrt(static_cast<double>(start_square) / static_cast<double>(end_square));
    move_end_onto_circle(machine, centre, ratio, sketch);
    return put_exact_centre(machine, centre, sketch);
  }
  const bool kept =
      agreement != Agreement::kWithin || configuration.correction == Correction::kProgrammed;
  if (kept) return put_exact_centre(machine, centre, sketch);
  const bool of_end = machine.has(Fault::kCorrectionEndRadius);
  correct_centre(machine, block, centre, of_end ? end_square : start_square, sketch);
}

}  // namespace

void take_centre(Machine& machine, const Block& block, ArcSketch& sketch) {
  Chord centre;
  if (!read_centre(machine, block, sketch, centre) || machine.in_alarm()) return;
  const Chord end{sketch.chord.p - centre.p, sketch.chord.q - centre.q};
  take_circle(machine, block, centre, end.square(), sketch);
}

void take_centre_and_angle(Machine& machine, const Block& block, double angle, ArcSketch& sketch) {
  Chord centre;
  if (!read_centre(machine, block, sketch, centre) || machine.in_alarm()) return;
  if (machine.has(Fault::kOpeningAngleComplement)) angle = 360 - angle;
  const Direction2 turn = direction_of(sketch.counterclockwise ? angle : -angle);
  const Vector c = vector_of(centre);
  // The start seen from the centre is -c.
  const double p = c.p - c.p * turn.cosine + c.q * turn.sine;
  const double q = c.q - c.p * turn.sine - c.q * turn.cosine;
  const Plane& plane = sketch.plane;
  Target& target = sketch.arc.target;
  const Wide to_p = static_cast<Wide>(machine.state.position[plane.p]) + std::llround(p);
  const Wide to_q = static_cast<Wide>(machine.state.position[plane.q]) + std::llround(q);
  if (!in_reach(to_p) || !in_reach(to_q)) return machine.complain(AlarmKind::kValueOutOfRange);
  target.to[plane.p] = static_cast<Fixed>(to_p);
  target.to[plane.q] = static_cast<Fixed>(to_q);
  if (turn.cosine != 0 && turn.sine != 0) target.rounded |= plane_axes(plane);
  take_end(machine.state, sketch);
  put_exact_centre(machine, centre, sketch);
}

// SIE-ARC-06: RP is the radius at the end.
void take_pole_circle(Machine& machine, const Block& block, ArcSketch& sketch) {
  const State& state = machine.state;
  const Plane& plane = sketch.plane;
  const Chord centre{state.pole.p - state.position[plane.p],
                     state.pole.q - state.position[plane.q]};
  if (centre.square() == 0) {
    return machine.complain(AlarmKind::kArcRadius, first_word(block), block);
  }
  sketch.rounded = sketch.rounded || state.pole.rounded;
  take_circle(machine, block, centre, squared(state.polar.radius), sketch);
}

}  // namespace gonogo::expanders::sinumerik
