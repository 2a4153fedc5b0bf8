// SPDX-License-Identifier: GPL-3.0-or-later
// G0, G1 and the dwell.
#include <algorithm>
#include <cmath>

#include "expanders/sinumerik/circles.hpp"
#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {

namespace {

// What an axis may differ by and yet stay: a place that was reckoned twice is the same place.
Real rounding_between(const Target& from, const Target& to, std::size_t axis) {
  const Axes bit = axis_bit(axis);
  if (((from.rounded | to.rounded) & bit) == 0) return 0;
  if (((from.coarse | to.coarse) & bit) != 0) return kRounding;
  return fine_rounding(static_cast<Real>(magnitude(to.to[axis])));
}

}  // namespace

Target start_of(const State& state) {
  return {state.position, kLinearAxes, state.rounded, state.remainder, state.coarse};
}

std::array<Real, 3> way_between(const Target& from, const Target& to) {
  std::array<Real, 3> way{};
  bool moves = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    way[axis] = static_cast<Real>(to.to[axis] - from.to[axis]) +
                (to.remainder[axis] - from.remainder[axis]);
    moves = moves || std::fabs(way[axis]) > rounding_between(from, to, axis);
  }
  return moves ? way : std::array<Real, 3>{};
}

Real doubt_between(const Target& from, const Target& to, Axes axes) {
  Real doubt = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (((from.coarse | to.coarse) & axes & axis_bit(axis)) == 0) continue;
    const Fixed farthest = std::max(magnitude(from.to[axis]), magnitude(to.to[axis]));
    doubt = std::fmax(doubt, coarse_rounding(static_cast<Real>(farthest)));
  }
  return doubt;
}

Heading straight_heading(const State& state, const Target& target) {
  const Target start = start_of(state);
  Heading heading;
  heading.along = way_between(start, target);
  heading.exact = ((state.rounded | target.rounded) & kLinearAxes) == 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (magnitude(target.to[axis] - state.position[axis]) > kLargestWhole) heading.exact = false;
  }
  const auto [x, y, z] = heading.along;
  if (heading.known()) {
    heading.doubt = doubt_between(start, target, kLinearAxes) / std::hypot(x, y, z);
  }
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
