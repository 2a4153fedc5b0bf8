// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/polar.hpp"

namespace gonogo::expanders::ngc {

Point commanded_point(Machine& machine, const Block& block, Axes& axes) {
  const State& state = machine.state;
  Point to = state.position;
  axes = 0;
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    const char address = kAxisAddress[axis];
    if (!block.has(address)) continue;
    axes |= axis_bit(axis);
    const Fixed length = length_along(machine, block, axis);
    const Fixed degrees = block.number(address).value;
    const bool linear = (kLinearAxes & axis_bit(axis)) != 0;
    Wide place = linear ? length : machine.alters("inch-rotary-scaled"_fault, degrees, length);
    if (state.incremental) place += state.position[axis];
    to[axis] = reached(machine, block, place, address);
  }
  if (is_polar(block)) {
    axes |= axis_bit(GONOGO_X) | axis_bit(GONOGO_Y);
    lead_to(machine, block, polar_way(machine, block), 0, to);
  }
  return to;
}

Fixed length_of(const Machine& machine, Fixed number) {
  return machine.state.inch ? static_cast<Fixed>(scaled(number, 254, 10)) : number;
}

Fixed length_of(const Machine& machine, const Block& block, char address) {
  return length_of(machine, block.number(address).value);
}

// NGC-DIA-01
Fixed length_along(const Machine& machine, const Block& block, std::size_t axis) {
  const Fixed length = length_of(machine, block, kAxisAddress[axis]);
  const bool halves =
      axis == GONOGO_X && machine.spares("x-never-halved"_fault, machine.state.diameter);
  return halves ? length / 2 : length;
}

Fixed reached(Machine& machine, const Block& block, Wide place, char address) {
  if (fits(place)) return static_cast<Fixed>(place);
  machine.complain(AlarmKind::kValueOutOfRange, address, block);
  return 0;
}

void check_sizes(Machine& machine, const Block& block, AddressSet words) {
  (block.words() & words).each([&](char address) {
    const Decimal& number = block.number(address);
    // In inches no number grows by more than that; turns, seconds and counts do not grow.
    const bool fixed = address == 'P' || address == 'L' || address == 'H';
    if (number.overflow || !(fixed || fits(scaled(number.value, 254, 10)))) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  });
}

}  // namespace gonogo::expanders::ngc
