// SPDX-License-Identifier: GPL-3.0-or-later
// G02 and G03, in the plane of Z and X.
#include "expanders/common/circle.hpp"
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {
namespace {

// Reading hnc.arc.small-radius: half the chord may be longer than R by the parameter.
bool makes_semicircle(const Machine& machine, const Chord& chord, Fixed radius) {
  const Fixed tolerance = machine.profile.parameters[kRadiusTolerance];
  return tolerance > 0 && machine.follows("hnc.arc.small-radius=semicircle"_reading) &&
         chord.square() <= 4 * squared(magnitude(radius) + tolerance);
}

void centre_from_r(Machine& machine, const Block& block, const Chord& chord, bool counterclockwise,
                   Chord& centre) {
  const Fixed radius = length_of(machine, block, 'R');
  switch (centre_from_radius(chord, radius, counterclockwise, radius < 0, centre)) {
    case CircleDefect::kNoChord:
      if (machine.follows("hnc.arc.closed=none"_reading)) return;
      return machine.complain(AlarmKind::kArcEndPoint, 'R', block);
    case CircleDefect::kRadiusTooShort:
      if (!makes_semicircle(machine, chord, radius)) {
        return machine.complain(AlarmKind::kArcRadius, 'R', block);
      }
      centre = {chord.p / 2, chord.q / 2};
      return;
    case CircleDefect::kNone:
      return;
  }
}

// I and K count from the start and are true lengths.
void centre_from_words(Machine& machine, const Block& block, const Chord& chord, Chord& centre) {
  const char first = block.position('K') < block.position('I') ? 'K' : 'I';
  if (!block.has(first)) return machine.complain(AlarmKind::kMissingWord, 'R', kNowhere);
  centre.p = block.has('K') ? length_of(machine, block, 'K') : 0;
  centre.q = block.has('I') ? length_of(machine, block, 'I') : 0;
  if (machine.has("centre-as-diameter"_fault) && machine.state.diameter) centre.q /= 2;
  const Wide start_square = centre.square();
  const Wide end_square = Chord{chord.p - centre.p, chord.q - centre.q}.square();
  if (start_square == 0 && !machine.follows("hnc.arc.zero-radius=none"_reading)) {
    machine.complain(AlarmKind::kArcRadius, first, block);
  }
  const Fixed tolerance = machine.profile.parameters[kRadiusTolerance];
  if (tolerance >= 0 && !radii_agree(start_square, end_square, tolerance)) {
    machine.complain(AlarmKind::kArcEndPoint, first, block);
  }
}

}  // namespace

void prepare_arc(Machine& machine, const Block& block, Plan& plan) {
  static constexpr AddressSet kShape{"RIK"};
  Axes axes = 0;
  const Point to = commanded_point(machine, block, axes);
  if (axes == 0 && !block.has_any(kShape)) return;
  const Plane& plane = plane_of(18);
  const Point& from = machine.state.position;
  const Chord chord{to[plane.p] - from[plane.p], to[plane.q] - from[plane.q]};
  if (machine.state.feed == 0) machine.complain(AlarmKind::kFeedMissing);
  const int rot = machine.state.motion == Motion::kArcClockwise ? -1 : 1;
  Chord centre;
  if (block.has('R')) {
    centre_from_r(machine, block, chord, rot > 0, centre);
  } else {
    centre_from_words(machine, block, chord, centre);
  }
  if (machine.in_alarm()) return;
  const Fixed p = from[plane.p] + centre.p;
  const Fixed q = from[plane.q] + centre.q;
  if (!fits(p) || !fits(q)) return machine.complain(AlarmKind::kValueOutOfRange);
  // Readings hnc.arc.zero-radius = none and hnc.arc.closed = none: a circle of no size.
  if (centre.square() == 0 && chord.square() == 0) return;
  plan = [&machine, p, q, rot, to, axes] {
    return machine.tracer.arc(plane_of(18), p, q, rot, to, axes, feed_in_force(machine));
  };
}

}  // namespace gonogo::expanders::hnc
