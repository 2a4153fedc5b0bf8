// SPDX-License-Identifier: GPL-3.0-or-later
// G02 and G03 (GSK-COM-05).
#include <utility>

#include "expanders/common/circle.hpp"
#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr char kCentreAddress[] = {'I', 'J', 'K'};  // of X, Y, Z

// Reading gsk.arc.small-radius: half the chord may be longer than R by parameter 3410.
bool makes_semicircle(const Machine& machine, const Chord& chord, Fixed radius) {
  const Fixed tolerance = machine.profile.parameters[kRadiusTolerance];
  const Fixed longest = magnitude(radius) + tolerance;
  return tolerance > 0 && machine.follows("gsk.arc.small-radius=semicircle"_reading) &&
         chord.square() <= 4 * squared(longest);
}

void centre_from_r(Machine& machine, const Block& block, const Chord& chord, bool counterclockwise,
                   Chord& centre) {
  const Fixed radius = length_of(machine, block, 'R');
  const bool long_way = radius < 0 && !machine.has("long-arc-short"_fault);
  switch (centre_from_radius(chord, radius, counterclockwise, long_way, centre)) {
    case CircleDefect::kNoChord:
      if (machine.follows("gsk.arc.closed=none"_reading)) return;
      return machine.raise(AlarmKind::kArcEndPoint, 'R');
    case CircleDefect::kRadiusTooShort:
      if (!makes_semicircle(machine, chord, radius)) {
        return machine.raise(AlarmKind::kArcRadius, 'R');
      }
      centre = {chord.p / 2, chord.q / 2};
      return;
    case CircleDefect::kNone:
      return;
  }
}

// The radii at start and end may differ by parameter 3410; 0: by anything, or by nothing (reading
// gsk.arc.tolerance-zero).
bool ends_on_circle(const Machine& machine, const Chord& chord, const Chord& centre) {
  const Fixed tolerance = machine.profile.parameters[kRadiusTolerance];
  if (tolerance == 0 && !machine.follows("gsk.arc.tolerance-zero=exact"_reading)) return true;
  const Chord end{chord.p - centre.p, chord.q - centre.q};
  return radii_agree(centre.square(), end.square(), tolerance);
}

void centre_from_words(Machine& machine, const Block& block, const Chord& chord, Chord& centre) {
  const Plane& plane = machine.plane();
  char address_p = kCentreAddress[plane.p];
  char address_q = kCentreAddress[plane.q];
  if (machine.has("centre-swapped-in-g18"_fault) && plane.number == 18) {
    std::swap(address_p, address_q);
  }
  if (!block.has(address_p) && !block.has(address_q)) {
    return machine.raise(AlarmKind::kMissingWord, 'R');
  }
  centre.p = block.has(address_p) ? length_of(machine, block, address_p) : 0;
  centre.q = block.has(address_q) ? length_of(machine, block, address_q) : 0;
  const char first = block.has(address_p) ? address_p : address_q;
  // Reading gsk.arc.zero-radius.
  if (centre.square() == 0) return machine.raise(AlarmKind::kArcRadius, first);
  if (!ends_on_circle(machine, chord, centre)) machine.raise(AlarmKind::kArcEndPoint, first);
}

}  // namespace

void prepare_arc(Machine& machine, const Block& block, Plan& plan) {
  const Plane& plane = machine.plane();
  Axes axes = 0;
  const Point to = commanded_point(machine, block, axes);
  const bool shaped =
      block.has('R') || block.has(kCentreAddress[plane.p]) || block.has(kCentreAddress[plane.q]);
  if (machine.in_alarm() || (axes == 0 && !shaped)) return;
  if (!shaped && machine.follows("gsk.arc.no-centre=line"_reading)) {
    machine.check_feed();
    plan = [&machine, to, axes] { return machine.cut(to, axes); };
    return;
  }
  const Point& from = machine.state.position;
  const Chord chord{to[plane.p] - from[plane.p], to[plane.q] - from[plane.q]};
  const int rot = machine.state.motion == Motion::kArcClockwise ? -1 : 1;
  Chord centre;
  if (block.has('R')) {
    centre_from_r(machine, block, chord, rot > 0, centre);
  } else {
    centre_from_words(machine, block, chord, centre);
  }
  machine.check_feed();
  const Fixed p = from[plane.p] + centre.p;
  const Fixed q = from[plane.q] + centre.q;
  if (!fits(p) || !fits(q)) machine.raise(AlarmKind::kValueOutOfRange);
  if (chord.square() == 0 && centre.square() == 0) {  // reading gsk.arc.closed = none
    plan = [&machine, to, axes] { return machine.cut(to, axes); };
    return;
  }
  plan = [&machine, p, q, rot, to, axes] { return machine.arc(p, q, rot, to, axes); };
}

}  // namespace gonogo::expanders::gsk
