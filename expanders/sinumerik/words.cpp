// SPDX-License-Identifier: GPL-3.0-or-later
// What the words of a block command: targets, lengths, feeds.
#include <bit>

#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// The others take any number of digits.
constexpr Addresses kMeasured = ~addresses(Address::kTurn, Address::kTool, Address::kCuttingEdge,
                                           Address::kSpindle, Address::kRotation);

// Exact where it comes out whole.
Real to_millimetres(Real inches) {
  return inches * 254 / 10;
}

}  // namespace

// SIE-ADDR-01
bool is_incremental(const State& state, Value::Mode mode) {
  return mode == Value::Mode::kPlain ? state.incremental : mode == Value::Mode::kIncremental;
}

// SIE-FRM-06
Real untravelled(const Machine& machine, std::size_t axis) {
  const Direction along = machine.frame.to_workpiece(machine.state.untravelled);
  if (axis >= along.size() || std::fabs(along[axis]) <= kRounding) return 0;
  return machine.follows("sie.frame.increment=with-translation"_reading) ? along[axis] : 0;
}

Real length_of(const Machine& machine, const Block& block, Address address) {
  const Real written = block.value(address).counts;
  return machine.state.inch ? to_millimetres(written) : written;
}

Axes axes_of(const Block& block) {
  Axes axes = 0;
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    if (block.has(axis_address(axis))) axes |= axis_bit(axis);
  }
  return axes;
}

Target target_of(Machine& machine, const Block& block) {
  return is_polar(block) ? polar_target(machine, block) : cartesian_target(machine, block);
}

// SIE-G1-01, SIE-G1-03
Target cartesian_target(Machine& machine, const Block& block) {
  const State& state = machine.state;
  Target target{state.position, axes_of(block)};
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    const Address address = axis_address(axis);
    if (!block.has(address)) continue;
    const Value& value = block.value(address);
    // SIE-MOD-04
    const bool rotary = (kLinearAxes & axis_bit(axis)) == 0;
    const bool scaled = !rotary || machine.has("inch-rotary-scaled"_fault);
    Real place = scaled ? length_of(machine, block, address) : value.counts;
    if (axis == GONOGO_X && machine.profile.x_diameter) place /= 2;
    if (is_incremental(state, value.mode)) {
      place += state.position[axis] + untravelled(machine, axis);
    }
    if (in_reach(place)) {
      target.to[axis] = place;
    } else {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  }
  return target;
}

void check_sizes(Machine& machine, const Block& block) {
  const Code* units = block.code(Group::kUnits);
  const bool inch = units != nullptr ? units->tenths == 700 : machine.state.inch;
  for (Addresses bits = block.words() & kMeasured; bits != 0; bits &= bits - 1) {
    const auto address = static_cast<Address>(std::countr_zero(bits));
    const Decimal& number = block.number(address);
    const Real counts = block.value(address).counts;
    if (number.overflow || !in_reach(inch ? to_millimetres(counts) : counts)) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
    }
  }
}

Feed cutting_feed(Machine& machine, const Place& to, bool curved) {
  const State& state = machine.state;
  if (state.feed == 0) machine.complain(AlarmKind::kFeedMissing);
  // SIE-G1-02
  const bool turning = state.spindle_turns && state.speed_given;
  if (machine.follows("sie.spindle=alarm"_reading) && !turning) {
    machine.complain(AlarmKind::kSpindleStopped);
  }
  const bool linear = curved || !is_nothing(way_between(state.position, to));
  const bool inches =
      linear ? machine.follows("sie.g70.f=inch"_reading) || machine.has("inch-feed-scaled"_fault)
             : machine.has("rotary-feed-scaled"_fault);
  const bool scales = inches && state.inch && !state.feed_of_cycle;
  const auto in_mm = static_cast<Fixed>(scaled(state.feed, 254, 10));
  return {scales ? in_mm : state.feed, state.feed_per_revolution};
}

void refuse(Machine& machine, const Block& block, Addresses unwanted) {
  for (Addresses bits = block.words() & unwanted; bits != 0; bits &= bits - 1) {
    machine.complain(AlarmKind::kConflictingWords, static_cast<Address>(std::countr_zero(bits)),
                     block);
  }
}

// SIE-ARC-13
void refuse_rounds(Machine& machine, const Block& block) {
  if (!block.has(Address::kTurn)) return;
  const Decimal& number = block.number(Address::kTurn);
  const bool none = number.value == 0 && !number.finer && !number.overflow;
  if (!none) refuse(machine, block, bit(Address::kTurn));
}

}  // namespace gonogo::expanders::sinumerik
