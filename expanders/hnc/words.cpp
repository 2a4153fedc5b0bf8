// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {
namespace {

// Words whose size matters to the path; of the others any number of digits will do.
constexpr AddressSet kMeasured{"XZUWIKREQCPFJ"};

// In mm, divided by `share`, which is 1 or 2; halves away from zero.
Wide to_millimetres(const Machine& machine, const Decimal& number, Fixed share) {
  if (machine.state.inch) return scaled(number.value, 254, 10 * share);
  return scaled(number.value, 1, share);
}

}  // namespace

AxisWord axis_word(const Machine& machine, const Block& block, std::size_t axis) {
  const bool is_x = axis == GONOGO_X;
  const bool in_cycle = is_cycle(machine.state.motion);
  const char absolute = is_x ? 'X' : 'Z';
  const char increment = is_x ? 'U' : 'W';
  AxisWord word;
  const bool by_increment = !block.has(absolute);
  word.address = by_increment ? increment : absolute;
  word.present = block.has(word.address);
  if (!word.present) return word;
  word.incremental = by_increment || machine.state.incremental;
  if (machine.has("incremental-z-ignored"_fault) && in_cycle && !is_x) {
    word.incremental = by_increment;
  }
  bool halved = is_x && machine.state.diameter;
  if (machine.has("increment-as-radius"_fault) && by_increment) halved = false;
  if (machine.has("increment-as-diameter"_fault) && is_x && by_increment) halved = true;
  word.value =
      static_cast<Fixed>(to_millimetres(machine, block.number(word.address), halved ? 2 : 1));
  return word;
}

Fixed target(Machine& machine, const Block& block, std::size_t axis) {
  const AxisWord word = axis_word(machine, block, axis);
  const State& state = machine.state;
  if (!word.present) return state.position[axis];
  Wide place = word.value;
  const bool frame_lost = machine.has("offset-ignored-in-cycle"_fault) && is_cycle(state.motion);
  if (word.incremental) {
    place += state.position[axis];
  } else if (state.frame != nullptr && !frame_lost) {
    place += (*state.frame)[axis];
  }
  if (!fits(place)) {
    machine.complain(AlarmKind::kValueOutOfRange, word.address, block);
    return state.position[axis];
  }
  return static_cast<Fixed>(place);
}

Fixed length_of(const Machine& machine, const Block& block, char address) {
  return static_cast<Fixed>(to_millimetres(machine, block.number(address), 1));
}

void take_length(const Machine& machine, const Block& block, char address, Retained& store) {
  if (block.has(address)) store = {true, length_of(machine, block, address)};
}

void take_number(const Block& block, char address, Retained& store) {
  if (block.has(address)) store = {true, block.number(address).value};
}

void check_words(Machine& machine, const Block& block) {
  (block.words() & kMeasured).each([&](char address) {
    const Decimal& number = block.number(address);
    // P is an angle. J is always in inches: no length grows by more than that.
    const Wide most = address == 'P' ? Wide{number.value} : scaled(number.value, 254, 10);
    if (number.overflow || !fits(most)) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  });
  for (const auto& [absolute, increment] : {std::pair{'X', 'U'}, std::pair{'Z', 'W'}}) {
    if (block.has(absolute) && block.has(increment)) {
      machine.complain(AlarmKind::kConflictingWords, increment, block);
    }
  }
}

Point commanded_point(Machine& machine, const Block& block, Axes& axes) {
  Point to = machine.state.position;
  axes = 0;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Z}) {
    if (!axis_word(machine, block, axis).present) continue;
    to[axis] = target(machine, block, axis);
    axes |= axis_bit(axis);
  }
  return to;
}

Feed feed_in_force(const Machine& machine) {
  const State& state = machine.state;
  return {state.feed, state.per_revolution && !machine.has("revolution-ignored"_fault)};
}

}  // namespace gonogo::expanders::hnc
