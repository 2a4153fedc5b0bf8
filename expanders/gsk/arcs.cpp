// SPDX-License-Identifier: GPL-3.0-or-later
// G02 and G03 (GSK-COM-05).
#include <cmath>
#include <utility>

#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr char kCentreAddress[] = {'I', 'J', 'K'};  // of X, Y, Z

Wide squared(Fixed value) {
  return static_cast<Wide>(value) * value;
}

struct Chord {
  Fixed p;
  Fixed q;
  Wide square() const { return squared(p) + squared(q); }
};

// Centre on the left of the chord for a counterclockwise arc below 180 degrees; the other side
// for one of: clockwise, above 180 degrees (negative R).
Flow centre_from_radius(Machine& machine, const Block& block, const Chord& chord, Arc& arc) {
  const Fixed radius = length_of(machine, block, 'R');
  const Wide chord_square = chord.square();
  if (chord_square == 0) return machine.raise(AlarmKind::kArcEndPoint, 'R');
  const Wide rest = 4 * squared(radius) - chord_square;
  if (rest < 0) return machine.raise(AlarmKind::kArcRadius, 'R');
  // Distance of the centre from the middle of the chord, in half chords.
  const double ratio = std::sqrt(static_cast<double>(rest) / static_cast<double>(chord_square));
  const bool long_way = radius < 0 && !machine.has(Fault::kLongArcShort);
  const double side = (arc.rot > 0) == long_way ? -ratio : ratio;
  const auto p = static_cast<double>(chord.p);
  const auto q = static_cast<double>(chord.q);
  const Point& from = machine.state.position;
  arc.centre_p = from[machine.state.plane->p] + std::llround((p - side * q) / 2);
  arc.centre_q = from[machine.state.plane->q] + std::llround((q + side * p) / 2);
  return Flow::kContinue;
}

// The radii at start and end may differ by parameter 3410; 0: by anything, or by nothing (reading
// gsk.arc.tolerance-zero).
bool radii_agree(const Configuration& configuration, Wide start_square, Wide end_square) {
  const Fixed tolerance = configuration.radius_tolerance;
  if (tolerance == 0) return !configuration.zero_tolerance_checks || start_square == end_square;
  const Wide difference = floor_root(start_square) - floor_root(end_square);
  return (difference < 0 ? -difference : difference) <= tolerance;
}

Flow centre_from_words(Machine& machine, const Block& block, const Chord& chord, Arc& arc) {
  const Plane& plane = *machine.state.plane;
  char address_p = kCentreAddress[plane.p];
  char address_q = kCentreAddress[plane.q];
  if (machine.has(Fault::kCentreSwappedInG18) && plane.number == 18) {
    std::swap(address_p, address_q);
  }
  if (!block.has(address_p) && !block.has(address_q)) {
    return machine.raise(AlarmKind::kMissingWord, 'R');
  }
  const Fixed p = block.has(address_p) ? length_of(machine, block, address_p) : 0;
  const Fixed q = block.has(address_q) ? length_of(machine, block, address_q) : 0;
  const char first = block.has(address_p) ? address_p : address_q;
  const Point& from = machine.state.position;
  arc.centre_p = from[plane.p] + p;
  arc.centre_q = from[plane.q] + q;
  if (!fits(arc.centre_p) || !fits(arc.centre_q)) {
    return machine.raise(AlarmKind::kValueOutOfRange, first);
  }
  const Wide start_square = squared(p) + squared(q);
  const Wide end_square = squared(chord.p - p) + squared(chord.q - q);
  // Reading gsk.arc.zero-radius.
  if (start_square == 0) return machine.raise(AlarmKind::kArcRadius, first);
  if (!radii_agree(machine.configuration, start_square, end_square)) {
    return machine.raise(AlarmKind::kArcEndPoint, first);
  }
  return Flow::kContinue;
}

}  // namespace

Flow prepare_arc(Machine& machine, const Block& block, Plan& plan) {
  const Plane& plane = *machine.state.plane;
  Arc arc;
  arc.rot = machine.state.motion == Motion::kArcClockwise ? -1 : 1;
  const Flow flow = commanded_point(machine, block, arc.to, arc.axes);
  if (flow != Flow::kContinue) return flow;
  const bool shaped =
      block.has('R') || block.has(kCentreAddress[plane.p]) || block.has(kCentreAddress[plane.q]);
  if (arc.axes == 0 && !shaped) return Flow::kContinue;
  const Point& from = machine.state.position;
  const Chord chord{arc.to[plane.p] - from[plane.p], arc.to[plane.q] - from[plane.q]};
  const Flow centre = block.has('R') ? centre_from_radius(machine, block, chord, arc)
                                     : centre_from_words(machine, block, chord, arc);
  if (centre != Flow::kContinue) return centre;
  if (machine.state.feed == 0) return machine.raise(AlarmKind::kFeedMissing, 0);  // GSK-COM-04
  plan = arc;
  return Flow::kContinue;
}

bool perform(Machine& machine, const Arc& arc) {
  return machine.trace.arc(arc.centre_p, arc.centre_q, arc.rot, arc.to, arc.axes);
}

}  // namespace gonogo::expanders::gsk
