// SPDX-License-Identifier: GPL-3.0-or-later
// G158, G258, G259: translation and rotation of the workpiece coordinates.
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

constexpr Addresses kShiftWords = addresses(Address::kX, Address::kY, Address::kZ);

// SIE-FRM-04: frames stand alone in their blocks.
void check_words(Machine& machine, const Block& block, Addresses own) {
  refuse(machine, block, ~own);
  bool plain = block.has_only(own);
  for (const Address word : {Address::kX, Address::kY, Address::kZ}) {
    if (block.has(word) && block.value(word).mode != Value::Mode::kPlain) plain = false;
  }
  if (!plain) machine.complain(AlarmKind::kConflictingWords);
}

// SIE-FRM-01
void take_shift(Machine& machine, const Block& block, Frame& frame) {
  const bool any = block.has_any(kShiftWords);
  const bool adds =
      any && (machine.follows("sie.g158=additive"_reading) || machine.has("g158-adds"_fault));
  const bool clears = !adds && !(any && machine.follows("sie.g158=translation-only"_reading));
  if (clears) frame = machine.plain_frame();
  Place step{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Address address = axis_address(axis);
    if (block.has(address)) step[axis] = length_of(machine, block, address);
  }
  // Words that are added count along the axes as they are turned.
  frame.shift_to(adds ? frame.to_machine(step) : step);
  if (clears && machine.has("g158-keeps-rotation"_fault)) frame.turn_as(machine.frame);
}

// SIE-FRM-02, SIE-FRM-03
void take_rotation(Machine& machine, const Block& block, bool adds, Frame& frame) {
  const bool replaces = !adds || machine.has("g259-replaces"_fault);
  if (replaces && (machine.follows("sie.g258=rotation-only"_reading) || adds)) {
    frame.clear_rotation();
  } else if (replaces) {
    frame = machine.plain_frame();
  }
  if (!block.has(Address::kRotation)) return;
  frame.turn_by(block.value(Address::kRotation).counts, machine.state.plane);
}

// SIE-FRM-04: the tool stays where it is; its place is computed anew.
void put_frame(Machine& machine, const Frame& frame) {
  State& state = machine.state;
  const Place position = frame.to_workpiece(machine.frame.to_machine(state.position));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!in_reach(position[axis]) || !in_reach(frame.shift()[axis])) {
      return machine.complain(AlarmKind::kValueOutOfRange);
    }
  }
  for (std::size_t axis = 0; axis < state.untravelled.size(); ++axis) {
    state.untravelled[axis] += frame.shift()[axis] - machine.frame.shift()[axis];
  }
  state.heading = frame.to_workpiece(machine.frame.to_machine(state.heading));
  state.position = position;
  machine.frame = frame;
}

}  // namespace

void take_frame(Machine& machine, const Block& block, unsigned code) {
  const bool shifts = code == 158;
  check_words(machine, block, shifts ? kShiftWords : bit(Address::kRotation));
  if (machine.in_alarm()) return;
  const bool turns = block.has(Address::kRotation);
  if (turns && block.number(Address::kRotation).overflow) {
    return machine.complain(AlarmKind::kValueOutOfRange);
  }
  if (code == 259 && !turns) return machine.complain(AlarmKind::kMissingWord);
  Frame frame = machine.frame;
  if (shifts) {
    take_shift(machine, block, frame);
  } else {
    take_rotation(machine, block, code == 259, frame);
  }
  put_frame(machine, frame);
}

}  // namespace gonogo::expanders::sinumerik
