// SPDX-License-Identifier: GPL-3.0-or-later
// Arcs whose centre is given: by I J K or by the pole.
#include <cmath>

#include "expanders/sinumerik/arc_sketch.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// Where a complaint about the circle belongs.
Address first_centre_word(const Block& block) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (block.has(centre_address(axis))) return centre_address(axis);
  }
  return Address::kPolarRadius;
}

/// A centre as it is given, counted from the start.
struct GivenCentre {
  Chord whole;
  Vector place;  ///< with what rounding took from start and pole
};

/// At start and end, and their squares where places are whole.
struct Radii {
  Wide start_square = 0;
  Wide end_square = 0;
  Real start = 0;
  Real end = 0;
  bool exact = false;  // the squares are
};

bool is_absolute(const Machine& machine, Value::Mode mode) {
  if (mode == Value::Mode::kPlain) {
    return machine.has(Fault::kCentreAbsolute) && !machine.state.incremental;
  }
  return mode == Value::Mode::kAbsolute && !machine.has(Fault::kCentreAbsoluteIgnored);
}

// SIE-ARC-02: from the start, whatever G90 and G91 say; AC( ) from the workpiece zero. `rest` is
// what rounding took from the result.
Fixed centre_along(Machine& machine, const Block& block, std::size_t axis, Real& rest) {
  const Address address = centre_address(axis);
  if (!block.has(address)) return 0;
  const Value& value = block.value(address);
  const Fixed length = machine.has(Fault::kInchCentreUnscaled) ? value.number.value
                                                               : length_of(machine, block, address);
  if (!is_absolute(machine, value.mode)) return length;
  rest = -machine.state.remainder[axis];
  return length - machine.state.position[axis];
}

// No length but what the processor rounds.
bool is_none(const Vector& way) {
  return way.square() < Real{1e-12L};
}

// False: there is no centre to go on with.
bool read_centre(Machine& machine, const Block& block, ArcSketch& sketch, GivenCentre& centre) {
  const Plane& plane = sketch.plane;
  if (block.has(centre_address(plane.d))) {
    machine.complain(AlarmKind::kAxisNotInPlane, centre_address(plane.d), block);
  }
  if (!block.has(centre_address(plane.p)) && !block.has(centre_address(plane.q))) return false;
  bool finer = false;
  for (const std::size_t axis : {plane.p, plane.q}) {
    const Address address = centre_address(axis);
    finer = finer || (block.has(address) && block.value(address).number.finer);
  }
  sketch.rounded = sketch.rounded || finer;
  sketch.known = sketch.known && !finer;
  Vector rest;
  centre.whole = {centre_along(machine, block, plane.p, rest.p),
                  centre_along(machine, block, plane.q, rest.q)};
  centre.place = vector_of(centre.whole);
  centre.place.p += rest.p;
  centre.place.q += rest.q;
  // What is less than a count from the start is not the start.
  if (finer || !is_none(centre.place)) return true;
  machine.complain(AlarmKind::kArcRadius, first_centre_word(block), block);
  return false;
}

void put_exact_centre(Machine& machine, const GivenCentre& centre, ArcSketch& sketch) {
  put_centre(machine, centre.place, sketch);
  const Chord& whole = centre.whole;
  sketch.exact_centre = magnitude(whole.p) < kLargestWhole && magnitude(whole.q) < kLargestWhole;
}

// The fault that lets the machine follow the radius of the start.
void move_end_onto_circle(const Machine& machine, const GivenCentre& centre, ArcSketch& sketch) {
  const Vector end = sketch.way - centre.place;
  const Real ratio = std::sqrt(centre.place.square() / end.square());
  Point& to = sketch.arc.target.to;
  const Point& from = machine.state.position;
  to[sketch.plane.p] = from[sketch.plane.p] + centre.whole.p + std::llround(end.p * ratio);
  to[sketch.plane.q] = from[sketch.plane.q] + centre.whole.q + std::llround(end.q * ratio);
  take_end(machine.state, sketch);
}

// SIE-ARC-08: at most half a turn about a centre on the chord itself.
bool lies_left(const ArcSketch& sketch, const GivenCentre& centre) {
  const Wide whole = cross(sketch.chord, centre.whole);
  const Real across = cross(sketch.way, centre.place);
  const bool on_chord =
      sketch.rounded ? std::fabs(across) <= kRounding * std::sqrt(sketch.way.square()) : whole == 0;
  if (on_chord) return sketch.counterclockwise;
  return sketch.rounded ? across > 0 : whole > 0;
}

// SIE-ARC-08
void correct_centre(Machine& machine, const Block& block, const GivenCentre& centre,
                    const Radii& radii, ArcSketch& sketch) {
  Real side = 0;
  if (machine.configuration.correction == Correction::kProject) {
    side = side_of_projection(sketch.way, centre.place);
  } else {
    const bool of_end = machine.has(Fault::kCorrectionEndRadius);
    const Wide whole = of_end ? radii.end_square : radii.start_square;
    const Real radius = of_end ? radii.end : radii.start;
    side = sketch.rounded ? side_of_radius(sketch.way, radius * radius)
                          : side_of_radius(sketch.chord, whole);
    if (!lies_left(sketch, centre)) side = -side;
  }
  const Vector corrected = on_bisector(sketch.way, side);
  sketch.centre_doubt =
      doubt_on_bisector(sketch, side, sketch.doubt(), std::sqrt(corrected.square()));
  const bool no_direction = centre.place.square() == 0;
  if (no_direction || too_far_turned(centre.place, corrected)) {
    return machine.complain(AlarmKind::kArcEndPoint, first_centre_word(block), block);
  }
  put_centre(machine, corrected, sketch);
}

// SIE-ARC-07
Agreement compare(const Machine& machine, const Radii& radii, const ArcSketch& sketch) {
  const Configuration& configuration = machine.configuration;
  const bool constant_only = machine.has(Fault::kConstantToleranceOnly);
  const RadiusTolerance tolerance{configuration.circle_error_constant,
                                  constant_only ? 0 : configuration.circle_error_factor,
                                  machine.has(Fault::kEqualityRefused)};
  const bool of_end = machine.has(Fault::kEndRadiusTolerance);
  if (sketch.rounded && !radii.exact) {
    const Real fine = fine_rounding(std::fmax(radii.start, radii.end));
    return compare_radii(radii.start, radii.end, of_end ? radii.end : radii.start, tolerance,
                         sketch.known ? fine : Real{kRounding});
  }
  return compare_radii(radii.start_square, radii.end_square,
                       of_end ? radii.end_square : radii.start_square, tolerance);
}

// SIE-ARC-08: whether radii that are one but for rounding may be two all the same, and so far above
// the chord that it would be seen.
bool hides_correction(const Machine& machine, const Radii& radii, const ArcSketch& sketch) {
  if (machine.configuration.correction == Correction::kProgrammed) return false;
  if (!sketch.rounded || radii.exact) return false;
  const Real radius = std::fmax(radii.start, radii.end);
  return fine_rounding(radius) * radius > kSharp * std::sqrt(sketch.way.square());
}

// The circle about `centre`.
void take_circle(Machine& machine, const Block& block, const GivenCentre& centre,
                 const Radii& radii, ArcSketch& sketch) {
  if (sketch.chord.square() == 0) return put_exact_centre(machine, centre, sketch);
  const Agreement agreement = compare(machine, radii, sketch);
  if (agreement == Agreement::kApart && !machine.has(Fault::kEndPointUnchecked)) {
    return machine.complain(AlarmKind::kArcEndPoint, first_centre_word(block), block);
  }
  if (machine.has(Fault::kEndOntoCircle)) {
    move_end_onto_circle(machine, centre, sketch);
    return put_exact_centre(machine, centre, sketch);
  }
  sketch.unclear = agreement == Agreement::kUnclear ||
                   (agreement == Agreement::kEqual && hides_correction(machine, radii, sketch));
  const bool kept = agreement != Agreement::kWithin ||
                    machine.configuration.correction == Correction::kProgrammed;
  if (kept) return put_exact_centre(machine, centre, sketch);
  correct_centre(machine, block, centre, radii, sketch);
}

// `step` from the start; false: out of reach.
bool put_end(const State& state, std::size_t axis, Real step, Target& target) {
  step += state.remainder[axis];
  const Wide whole = to_whole(step);
  const Wide to = state.position[axis] + whole;
  if (!in_reach(to)) return false;
  target.to[axis] = static_cast<Fixed>(to);
  target.remainder[axis] = step - static_cast<Real>(whole);
  return true;
}

}  // namespace

void take_centre(Machine& machine, const Block& block, ArcSketch& sketch) {
  GivenCentre centre;
  if (!read_centre(machine, block, sketch, centre) || machine.in_alarm()) return;
  const Chord end{sketch.chord.p - centre.whole.p, sketch.chord.q - centre.whole.q};
  const Radii radii{centre.whole.square(), end.square(), std::sqrt(centre.place.square()),
                    std::sqrt((sketch.way - centre.place).square())};
  take_circle(machine, block, centre, radii, sketch);
}

void take_centre_and_angle(Machine& machine, const Block& block, Fixed angle, ArcSketch& sketch) {
  GivenCentre centre;
  if (!read_centre(machine, block, sketch, centre) || machine.in_alarm()) return;
  if (machine.has(Fault::kOpeningAngleComplement)) angle = 360 * kOne - angle;
  const Direction2 turn =
      direction_of(static_cast<Real>(sketch.counterclockwise ? angle : -angle) / kOne);
  const Vector c = centre.place;
  // The start seen from the centre is -c.
  const Vector end{c.p - c.p * turn.cosine + c.q * turn.sine,
                   c.q - c.p * turn.sine - c.q * turn.cosine};
  const Plane& plane = sketch.plane;
  Target& target = sketch.arc.target;
  if (!put_end(machine.state, plane.p, end.p, target) ||
      !put_end(machine.state, plane.q, end.q, target)) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  if (turn.cosine != 0 && turn.sine != 0) target.rounded |= plane_axes(plane);
  const bool finer = block.value(Address::kOpeningAngle).number.finer;
  if (!sketch.known || finer) target.coarse |= plane_axes(plane);
  if (finer) machine.check_turn(kAngleDoubt, std::sqrt(c.square()));
  take_end(machine.state, sketch);
  put_exact_centre(machine, centre, sketch);
}

// SIE-ARC-06: RP is the radius at the end.
void take_pole_circle(Machine& machine, const Block& block, ArcSketch& sketch) {
  const State& state = machine.state;
  const Pole& pole = state.pole;
  const Plane& plane = sketch.plane;
  GivenCentre centre;
  centre.whole = {pole.p - state.position[plane.p], pole.q - state.position[plane.q]};
  centre.place = vector_of(centre.whole);
  centre.place.p += pole.rest_p - state.remainder[plane.p];
  centre.place.q += pole.rest_q - state.remainder[plane.q];
  if (!pole.coarse && is_none(centre.place)) {
    return machine.complain(AlarmKind::kArcRadius, first_centre_word(block), block);
  }
  sketch.rounded = sketch.rounded || pole.rounded;
  sketch.known = sketch.known && !pole.coarse && !state.polar.radius_rounded;
  const Fixed radius = state.polar.radius;
  const bool exact = ((state.rounded | state.coarse) & plane_axes(plane)) == 0 && !pole.rounded &&
                     !pole.coarse && !state.polar.radius_rounded;
  const Radii radii{centre.whole.square(), squared(radius), std::sqrt(centre.place.square()),
                    static_cast<Real>(radius), exact};
  take_circle(machine, block, centre, radii, sketch);
}

}  // namespace gonogo::expanders::sinumerik
