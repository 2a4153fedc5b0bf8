// SPDX-License-Identifier: GPL-3.0-or-later
// G158, G258, G259: translation and rotation of the workpiece coordinates.
#include "expanders/sinumerik/cycles.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Addresses kShiftWords = addresses(Address::kX, Address::kY, Address::kZ);

// SIE-FRM-04: frames stand alone in their blocks.
void check_words(Machine& machine, const Block& block, Addresses own) {
  refuse(machine, block, ~own);
  const auto known = static_cast<std::size_t>(__builtin_popcount(block.words() & own));
  bool plain = true;
  for (const Address word : {Address::kX, Address::kY, Address::kZ}) {
    if (block.has(word) && block.value(word).mode != Value::Mode::kPlain) plain = false;
  }
  if (block.items() != known + 1 || !plain) machine.complain(AlarmKind::kConflictingWords);
}

// SIE-FRM-01
void take_shift(Machine& machine, const Block& block, Frame& frame) {
  const Configuration& configuration = machine.configuration;
  const bool adds = configuration.shifts_add || machine.has(Fault::kShiftAdds);
  const bool clears = !block.has_any(kShiftWords) || !adds;
  if (clears) frame = machine.plain_frame();
  Point step{};
  Axes rounded = frame.rounded();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Address address = axis_address(axis);
    if (!block.has(address)) continue;
    step[axis] = length_of(machine, block, address);
    if (block.value(address).number.finer) rounded |= frame.to_machine(axis_bit(axis));
  }
  // The words count along the axes as they are turned.
  frame.shift_to(frame.to_machine(step), rounded);
  if (clears && machine.has(Fault::kShiftKeepsRotation)) frame.turn_as(machine.frame);
}

// SIE-FRM-02, SIE-FRM-03
void take_rotation(Machine& machine, const Block& block, bool adds, Frame& frame) {
  const bool replaces = !adds || machine.has(Fault::kRotationReplaces);
  if (replaces && (machine.configuration.rotation_only || adds)) {
    frame.clear_rotation();
  } else if (replaces) {
    frame = machine.plain_frame();
  }
  if (!block.has(Address::kRotation)) return;
  const Decimal& angle = block.value(Address::kRotation).number;
  frame.turn_by(angle.value, machine.state.plane, angle.finer ? kAngleDoubt : 0);
}

// What rounding takes from the place of the tool, which is `position` in `frame`.
Remainder remainder_in(const Machine& machine, const Frame& frame, const Point& position) {
  const State& state = machine.state;
  Frame::Direction place{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    place[axis] = static_cast<Real>(state.position[axis]) + state.remainder[axis];
  }
  place = frame.place_to_workpiece(machine.frame.place_to_machine(place));
  Remainder remainder{};
  for (std::size_t axis = 0; axis < place.size(); ++axis) {
    remainder[axis] = place[axis] - static_cast<Real>(position[axis]);
  }
  return remainder;
}

// SIE-FRM-04: the tool stays where it is; its place is reckoned anew.
void put_frame(Machine& machine, const Frame& frame) {
  State& state = machine.state;
  const Point place = machine.frame.to_machine(state.position);
  const Point position = frame.to_workpiece(place);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!in_reach(position[axis]) || !in_reach(frame.shift()[axis])) {
      return machine.complain(AlarmKind::kValueOutOfRange);
    }
  }
  const Axes machine_rounded = machine.frame.to_machine(state.rounded) | machine.frame.rounded();
  state.rounded = frame.to_machine(machine_rounded) | frame.rounded();
  state.coarse = state.rounded;  // whatever is known of it goes through sums and turns
  state.heading.along =
      frame.direction_to_workpiece(machine.frame.direction_to_machine(state.heading.along));
  const Axes inexact = machine.frame.rounded() | frame.rounded();
  state.heading.exact = state.heading.exact && (inexact & kLinearAxes) == 0;
  state.remainder = remainder_in(machine, frame, position);
  state.position = position;
  machine.frame = frame;
  check_place(machine, position);
}

}  // namespace

void take_frame(Machine& machine, const Block& block, int code) {
  const bool shifts = code == 158;
  check_words(machine, block, shifts ? kShiftWords : bit(Address::kRotation));
  if (machine.in_alarm()) return;
  if (block.has(Address::kRotation) && block.value(Address::kRotation).number.overflow) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  if (code == 259 && !block.has(Address::kRotation)) {
    return machine.complain(AlarmKind::kMissingWord);
  }
  Frame frame = machine.frame;
  if (shifts) {
    take_shift(machine, block, frame);
  } else {
    take_rotation(machine, block, code == 259, frame);
  }
  put_frame(machine, frame);
}

}  // namespace gonogo::expanders::sinumerik
