// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>

#include "expanders/ngc/machine.hpp"

namespace gonogo::expanders::ngc {
namespace {

// Words whose size matters to the path; of the others any number of digits will do.
constexpr AddressSet kMeasured{"XYZACIJKRPF"};

// NGC-UNI-01
Fixed to_millimetres(Fixed value) {
  return static_cast<Fixed>(scaled(value, 254, 10));
}

}  // namespace

Point commanded_point(Machine& machine, const Block& block, Axes& axes) {
  const State& state = machine.state;
  Point to = state.position;
  axes = 0;
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    const char address = kAxisAddress[axis];
    if (!block.has(address)) continue;
    axes |= axis_bit(axis);
    const bool is_length =
        (kLinearAxes & axis_bit(axis)) != 0 || machine.has(Fault::kInchRotaryScaled);
    Wide place = is_length ? length_of(machine, block, address) : block.number(address).value;
    if (state.incremental) place += state.position[axis];
    if (fits(place)) {
      to[axis] = static_cast<Fixed>(place);
    } else {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  }
  return to;
}

Fixed length_of(const Machine& machine, const Block& block, char address) {
  const Fixed written = block.number(address).value;
  return machine.state.inch ? to_millimetres(written) : written;
}

void check_sizes(Machine& machine, const Block& block) {
  for (std::uint32_t bits = block.words().bits(); bits != 0; bits &= bits - 1) {
    const char address = static_cast<char>('A' + std::countr_zero(bits));
    if (!kMeasured.has(address)) continue;
    const Decimal& number = block.number(address);
    // In inches no number grows by more than that; turns and seconds do not grow.
    const bool fixed = address == 'P';
    if (number.overflow || !(fixed || fits(scaled(number.value, 254, 10)))) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  }
}

}  // namespace gonogo::expanders::ngc
