// SPDX-License-Identifier: GPL-3.0-or-later
// G02 and G03 (GSK-COM-05).
#include <utility>

#include "expanders/common/circle.hpp"
#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr char kCentreAddress[] = {'I', 'J', 'K'};  // of X, Y, Z

Flow centre_from_r(Machine& machine, const Block& block, const Chord& chord, Arc& arc) {
  const Fixed radius = length_of(machine, block, 'R');
  const bool long_way = radius < 0 && !machine.has(Fault::kLongArcShort);
  Chord centre;
  switch (centre_from_radius(chord, radius, arc.rot > 0, long_way, centre)) {
    case CircleDefect::kNoChord:
      return machine.raise(AlarmKind::kArcEndPoint, 'R');
    case CircleDefect::kRadiusTooShort:
      return machine.raise(AlarmKind::kArcRadius, 'R');
    case CircleDefect::kNone:
      break;
  }
  const Point& from = machine.state.position;
  arc.centre_p = from[machine.state.plane->p] + centre.p;
  arc.centre_q = from[machine.state.plane->q] + centre.q;
  return Flow::kContinue;
}

// The radii at start and end may differ by parameter 3410; 0: by anything, or by nothing (reading
// gsk.arc.tolerance-zero).
bool ends_on_circle(const Configuration& configuration, Wide start_square, Wide end_square) {
  const Fixed tolerance = configuration.radius_tolerance;
  if (tolerance == 0 && !configuration.zero_tolerance_checks) return true;
  return radii_agree(start_square, end_square, tolerance);
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
  if (!ends_on_circle(machine.configuration, start_square, end_square)) {
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
  const Flow centre = block.has('R') ? centre_from_r(machine, block, chord, arc)
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
