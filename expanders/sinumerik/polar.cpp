// SPDX-License-Identifier: GPL-3.0-or-later
// Poles, and targets by angle and radius.
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

Fixed within_turn(Wide angle) {
  const auto rest = static_cast<Fixed>(angle % kFullTurn);
  return rest < 0 ? rest + kFullTurn : rest;
}

// What polar words are for. Those of a pole count as its code says, IC or not.
enum class PolarUse { kTarget, kPole };

// SIE-POL-02: absolute whatever G90 and G91 say.
void take_angle(Machine& machine, const Block& block, PolarUse use, Polar& polar) {
  const Value& value = block.value(Address::kPolarAngle);
  const Fixed written = value.number.value;
  if (magnitude(written) > kFullTurn || (magnitude(written) == kFullTurn && value.number.finer)) {
    return machine.complain(AlarmKind::kValueOutOfRange, Address::kPolarAngle, block);
  }
  const bool by_g91 = machine.has(Fault::kPolarAngleByG91) && machine.state.incremental &&
                      value.mode == Value::Mode::kPlain && polar.has_angle;
  const bool is_added = value.mode == Value::Mode::kIncremental && use == PolarUse::kTarget;
  const bool adds = is_added || by_g91;
  if (adds && !polar.has_angle) {
    return machine.complain(AlarmKind::kMissingWord, Address::kPolarAngle, block);
  }
  polar.angle = within_turn((adds ? Wide{polar.angle} : Wide{0}) + written);
  polar.angle_rounded = (adds && polar.angle_rounded) || value.number.finer;
  polar.has_angle = true;
}

void take_radius(Machine& machine, const Block& block, Polar& polar) {
  polar.radius = length_of(machine, block, Address::kPolarRadius);
  polar.has_radius = true;
  polar.radius_rounded = block.value(Address::kPolarRadius).number.finer;
  if (polar.radius < 0) {
    machine.complain(AlarmKind::kValueSign, Address::kPolarRadius, block);
  }
}

// AP and RP with those in force.
Polar take_polar(Machine& machine, const Block& block, PolarUse use, Polar polar) {
  const bool angle = block.has(Address::kPolarAngle);
  const bool radius = block.has(Address::kPolarRadius);
  if (angle) take_angle(machine, block, use, polar);
  if (radius) take_radius(machine, block, polar);
  if ((!angle && !polar.has_angle) || (!radius && !polar.has_radius)) {
    machine.complain(AlarmKind::kMissingWord);
  }
  return polar;
}

// The place at `polar` from `base`.
Pole place_of(Machine& machine, const Pole& base, const Polar& polar) {
  Direction2 direction = direction_of(static_cast<Real>(polar.angle) / kOne);
  if (machine.has(Fault::kPolarG18Swapped) && machine.state.plane == 18) {
    direction = {direction.sine, direction.cosine};
  }
  const auto radius = static_cast<Real>(polar.radius);
  const Real from_p = base.rest_p + radius * direction.cosine;
  const Real from_q = base.rest_q + radius * direction.sine;
  const Wide step_p = to_whole(from_p);
  const Wide step_q = to_whole(from_q);
  const Wide p = base.p + step_p;
  const Wide q = base.q + step_q;
  if (!in_reach(p) || !in_reach(q)) {
    machine.complain(AlarmKind::kValueOutOfRange);
    return base;
  }
  if (polar.angle_rounded) machine.check_turn(kAngleDoubt, radius);
  machine.check_distance(static_cast<Real>(p), static_cast<Real>(q));
  const bool on_axis = polar.angle % (90 * kOne) == 0 || polar.radius == 0;
  return {static_cast<Fixed>(p),
          static_cast<Fixed>(q),
          base.rounded || polar.radius_rounded || polar.angle_rounded || !on_axis,
          from_p - static_cast<Real>(step_p),
          from_q - static_cast<Real>(step_q),
          base.coarse || polar.radius_rounded || polar.angle_rounded};
}

Pole position_in(const State& state, const Plane& plane) {
  return {
      state.position[plane.p],  state.position[plane.q],  (state.rounded & plane_axes(plane)) != 0,
      state.remainder[plane.p], state.remainder[plane.q], (state.coarse & plane_axes(plane)) != 0};
}

// SIE-POL-01: position, zero, last pole.
Pole base_of(const Machine& machine, const Plane& plane, int code) {
  if (machine.has(Fault::kPoleG110AsG111) && code == 110) code = 111;
  if (machine.has(Fault::kPoleG112AsG110) && code == 112) code = 110;
  if (code == 110) return position_in(machine.state, plane);
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
  const Plane& plane = plane_of(state.plane);
  refuse(machine, block, bit(axis_address(plane.p)) | bit(axis_address(plane.q)));
  Target target = cartesian_target(machine, block);
  const Polar polar = take_polar(machine, block, PolarUse::kTarget, state.polar);
  if (machine.in_alarm()) return target;
  const Pole place = place_of(machine, state.pole, polar);
  target.to[plane.p] = place.p;
  target.to[plane.q] = place.q;
  target.remainder[plane.p] = place.rest_p;
  target.remainder[plane.q] = place.rest_q;
  target.axes |= plane_axes(plane);
  target.rounded &= ~plane_axes(plane);
  if (place.rounded) target.rounded |= plane_axes(plane);
  target.coarse &= ~plane_axes(plane);
  if (place.coarse) target.coarse |= plane_axes(plane);
  state.polar = polar;
  if (machine.has(Fault::kPolarRadiusForgotten) && state.motion == Motion::kRapid) {
    state.polar.has_radius = false;
  }
  return target;
}

void take_pole(Machine& machine, const Block& block, int code) {
  State& state = machine.state;
  const Plane& plane = plane_of(state.plane);
  const Address first = axis_address(plane.p);
  const Address second = axis_address(plane.q);
  const Addresses cartesian = bit(first) | bit(second);
  const Addresses own = cartesian | kPolarWords;
  const bool polar = is_polar(block);
  const auto known = static_cast<std::size_t>(__builtin_popcount(block.words() & own));
  refuse(machine, block, polar ? ~kPolarWords : ~own);
  // SIE-POL-02: what is no word either, such as an M function.
  if (block.items() != known + 1) machine.complain(AlarmKind::kConflictingWords);
  Pole pole = base_of(machine, plane, code);
  if (polar) {
    const Polar given = take_polar(machine, block, PolarUse::kPole, Polar{});
    if (!machine.in_alarm()) pole = place_of(machine, pole, given);
  } else {
    const Wide p = Wide{pole.p} + (block.has(first) ? length_of(machine, block, first) : 0);
    const Wide q = Wide{pole.q} + (block.has(second) ? length_of(machine, block, second) : 0);
    if (!in_reach(p) || !in_reach(q)) return machine.complain(AlarmKind::kValueOutOfRange);
    for (const Address word : {first, second}) {
      if (!block.has(word) || !block.value(word).number.finer) continue;
      pole.rounded = true;
      pole.coarse = true;
    }
    pole.p = static_cast<Fixed>(p);
    pole.q = static_cast<Fixed>(q);
  }
  if (!machine.in_alarm()) place_pole(state, pole);
}

}  // namespace gonogo::expanders::sinumerik
