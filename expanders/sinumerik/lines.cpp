// SPDX-License-Identifier: GPL-3.0-or-later
// G0, G1 and the dwell.
#include <cmath>

#include "expanders/sinumerik/circles.hpp"
#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {

namespace {

// What an axis may differ by and yet stay: a place that was reckoned twice is the same place.
Real rounding_of(const State& state, const Target& target, std::size_t axis) {
  const Axes bit = axis_bit(axis);
  if (((state.rounded | target.rounded) & bit) == 0) return 0;
  if (((state.coarse | target.coarse) & bit) != 0) return kRounding;
  return fine_rounding(static_cast<Real>(magnitude(target.to[axis])));
}

}  // namespace

Heading straight_heading(const State& state, const Target& target) {
  Heading heading;
  heading.exact = ((state.rounded | target.rounded) & kLinearAxes) == 0;
  bool moves = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Fixed way = target.to[axis] - state.position[axis];
    heading.along[axis] = static_cast<Real>(way) + (target.remainder[axis] - state.remainder[axis]);
    if (magnitude(way) > kLargestWhole) heading.exact = false;
    moves = moves || std::fabs(heading.along[axis]) > rounding_of(state, target, axis);
  }
  if (!moves) heading.along = {};
  return heading;
}

void prepare_line(Machine& machine, const Block& block, bool rapid, Plan& plan) {
  refuse(machine, block, kArcWords | kIntermediateWords | bit(Address::kTurn));
  Line line;
  line.rapid = rapid;
  line.target = is_polar(block) ? polar_target(machine, block) : cartesian_target(machine, block);
  if (!rapid) line.feed = cutting_feed(machine, line.target.to, false);
  const bool kept = rapid && machine.has(Fault::kTangentSkipsRapids);
  if (!kept) plan.heading = straight_heading(machine.state, line.target);
  plan.motion = line;
}

// SIE-MOD-03
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  State& state = machine.state;
  const bool seconds = block.has(Address::kFeed);
  const bool turns = block.has(Address::kSpindle);
  const std::size_t known = 1u + (seconds ? 1u : 0u) + (turns ? 1u : 0u);
  if (block.items() != known || (seconds && turns)) {
    machine.complain(AlarmKind::kConflictingWords);
  }
  if (!seconds && !turns) return machine.complain(AlarmKind::kMissingWord);
  const Address word = seconds ? Address::kFeed : Address::kSpindle;
  const Decimal& number = block.value(word).number;
  if (number.overflow || !in_reach(number.value)) {
    return machine.complain(AlarmKind::kValueOutOfRange, word, block);
  }
  if (number.value < 0) return machine.complain(AlarmKind::kValueSign, word, block);
  if (seconds || machine.has(Fault::kDwellRevolutionsAsSeconds)) {
    if (machine.has(Fault::kDwellFeedKept) && seconds) state.feed = number.value;
    plan.motion = Dwell{number.value};
    return;
  }
  if (state.speed == 0) return machine.complain(AlarmKind::kSpindleStopped, word, block);
  const Wide time = (static_cast<Wide>(number.value) * 60 * kOne + state.speed / 2) / state.speed;
  if (!in_reach(time)) return machine.complain(AlarmKind::kValueOutOfRange, word, block);
  plan.motion = Dwell{static_cast<Fixed>(time)};
}

bool perform(Machine&, const Idle&) {
  return true;
}

bool perform(Machine& machine, const Dwell& dwell) {
  return machine.tracer.dwell(dwell.seconds);
}

bool perform(Machine& machine, const Line& line) {
  const Point to = machine.frame.to_machine(line.target.to);
  const Axes axes = machine.frame.to_machine(line.target.axes);
  return line.rapid ? machine.tracer.rapid(to, axes) : machine.tracer.feed(to, axes, line.feed);
}

}  // namespace gonogo::expanders::sinumerik
