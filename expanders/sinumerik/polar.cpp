// SPDX-License-Identifier: GPL-3.0-or-later
// Poles, and targets by angle and radius.
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// SIE-POL-02: absolute under G90 and G91 alike, or by a reading not. IC adds to the angle in force,
// except a pole.
void take_angle(Machine& machine, const Block& block, bool for_pole, Polar& polar) {
  const Value& value = block.value(Address::kPolarAngle);
  if (std::fabs(value.counts) > kFullTurn) {
    return machine.complain(AlarmKind::kValueOutOfRange, Address::kPolarAngle, block);
  }
  const bool follows_g91 =
      machine.follows("sie.ap.g91=incremental"_reading) != machine.has("ap-follows-g91"_fault);
  const bool by_g91 = follows_g91 && machine.state.incremental && !for_pole &&
                      value.mode == Value::Mode::kPlain && polar.has_angle;
  const bool adds = by_g91 || (value.mode == Value::Mode::kIncremental && !for_pole);
  if (adds && !polar.has_angle) {
    return machine.complain(AlarmKind::kMissingWord, Address::kPolarAngle, block);
  }
  polar.angle = (adds ? polar.angle : 0) + value.counts;
  polar.has_angle = true;
}

void take_radius(Machine& machine, const Block& block, Polar& polar) {
  polar.radius = length_of(machine, block, Address::kPolarRadius);
  polar.has_radius = true;
  if (polar.radius < 0) machine.complain(AlarmKind::kValueSign, Address::kPolarRadius, block);
}

// AP and RP with those in force.
Polar take_polar(Machine& machine, const Block& block, bool for_pole, Polar polar) {
  if (block.has(Address::kPolarAngle)) take_angle(machine, block, for_pole, polar);
  if (block.has(Address::kPolarRadius)) take_radius(machine, block, polar);
  const bool angle = polar.has_angle || block.has(Address::kPolarAngle);
  if (!angle || !polar.has_radius) machine.complain(AlarmKind::kMissingWord);
  return polar;
}

// The place at `polar` from `base`.
Pole place_of(Machine& machine, const Pole& base, const Polar& polar) {
  Vector direction = direction_of(polar.angle / kOne);
  if (machine.has("ap-swapped-in-g18"_fault) && machine.state.plane == 18) {
    std::swap(direction.p, direction.q);
  }
  const Pole place{base.p + polar.radius * direction.p, base.q + polar.radius * direction.q};
  if (in_reach(place.p) && in_reach(place.q)) return place;
  machine.complain(AlarmKind::kValueOutOfRange);
  return base;
}

// SIE-POL-01: position, zero, last pole.
Pole base_of(const Machine& machine, unsigned code) {
  if (machine.has("g110-as-g111"_fault) && code == 110) code = 111;
  if (machine.has("g112-as-g110"_fault) && code == 112) code = 110;
  const Plane& plane = machine.plane();
  if (code == 110) return {machine.state.position[plane.p], machine.state.position[plane.q]};
  return code == 112 ? machine.state.pole : Pole{};
}

}  // namespace

bool is_polar(const Block& block) {
  return block.has_any(kPolarWords);
}

void place_pole(State& state, const Pole& pole) {
  state.pole = pole;
  state.polar = Polar{};
}

Target polar_target(Machine& machine, const Block& block) {
  State& state = machine.state;
  const Plane& plane = machine.plane();
  refuse(machine, block, bit(axis_address(plane.p)) | bit(axis_address(plane.q)));
  Target target = cartesian_target(machine, block);
  const Polar polar = take_polar(machine, block, false, state.polar);
  if (machine.in_alarm()) return target;
  const Pole place = place_of(machine, state.pole, polar);
  target.to[plane.p] = place.p;
  target.to[plane.q] = place.q;
  target.axes |= plane_axes(plane);
  state.polar = polar;
  if (machine.has("rp-forgotten-after-g0"_fault) && state.motion == Motion::kRapid) {
    state.polar.has_radius = false;
  }
  return target;
}

void take_pole(Machine& machine, const Block& block, unsigned code) {
  const Plane& plane = machine.plane();
  const Address first = axis_address(plane.p);
  const Address second = axis_address(plane.q);
  const Addresses own = bit(first) | bit(second) | kPolarWords;
  const bool polar = is_polar(block);
  refuse(machine, block, polar ? ~kPolarWords : ~own);
  // SIE-POL-02: what is no word either, such as an M function.
  if (!block.has_only(own)) machine.complain(AlarmKind::kConflictingWords);
  Pole pole = base_of(machine, code);
  if (polar) {
    const Polar given = take_polar(machine, block, true, Polar{});
    if (!machine.in_alarm()) pole = place_of(machine, pole, given);
  } else {
    if (block.has(first)) pole.p += length_of(machine, block, first);
    if (block.has(second)) pole.q += length_of(machine, block, second);
    if (!in_reach(pole.p) || !in_reach(pole.q)) machine.complain(AlarmKind::kValueOutOfRange);
  }
  if (!machine.in_alarm()) place_pole(machine.state, pole);
}

}  // namespace gonogo::expanders::sinumerik
