// SPDX-License-Identifier: GPL-3.0-or-later
// CIP: the circle in space through start, intermediate point and end.
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

// Turning the circle about the end inside out makes it a line in the direction of the tangent.
Direction heading_at_end(const Direction& to_start, const Direction& to_via) {
  const Real start_square = dot(to_start, to_start);
  const Real via_square = dot(to_via, to_via);
  Direction heading{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // In parts of the squares, for they are large.
    heading[axis] = to_start[axis] * (via_square / start_square) - to_via[axis];
  }
  return heading;
}

// The fault that goes round the other way: the far end of the line from the intermediate point
// through the middle of the chord.
void take_other_side(const Place& from, const Place& to, Place& via) {
  const Direction chord = way_between(from, to);
  Direction out = way_between(from, via);
  for (std::size_t axis = 0; axis < 3; ++axis) out[axis] -= chord[axis] / 2;
  if (is_nothing(out)) return;
  const Real ratio = dot(chord, chord) / (4 * dot(out, out));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    via[axis] = from[axis] + chord[axis] / 2 - out[axis] * ratio;
  }
}

// SIE-CIP-02: what has no word is that of the start.
Place intermediate_point(Machine& machine, const Block& block) {
  const State& state = machine.state;
  Place via = state.position;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Address address = intermediate_address(axis);
    if (!block.has(address)) continue;
    const Value::Mode mode = block.value(address).mode;
    const bool fixed =
        machine.has("cip-intermediate-absolute"_fault) && mode == Value::Mode::kPlain;
    Real place = length_of(machine, block, address);
    if (is_incremental(state, mode) && !fixed) {
      place += state.position[axis] + untravelled(machine, axis);
    }
    if (!in_reach(place)) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
      continue;
    }
    via[axis] = place;
  }
  return via;
}

Address first_intermediate_word(const Block& block) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (block.has(intermediate_address(axis))) return intermediate_address(axis);
  }
  return Address::kK1;
}

}  // namespace

void prepare_through_point(Machine& machine, const Block& block, Plan& plan) {
  refuse(machine, block, kArcWords | kPolarWords);
  refuse_rounds(machine, block);
  if (!block.has_any(kIntermediateWords)) machine.complain(AlarmKind::kMissingWord);
  const Place from = machine.state.position;
  Target target = cartesian_target(machine, block);
  Place via = intermediate_point(machine, block);
  const Feed feed = cutting_feed(machine, target.to, true);
  if (machine.in_alarm()) return;
  const Direction to_via = way_between(from, via);
  const Direction to_end = way_between(from, target.to);
  const Direction via_to_end = way_between(via, target.to);
  target.axes |= kLinearAxes;
  bool broken = is_nothing(to_via) || is_nothing(to_end) || is_nothing(via_to_end);
  // SIE-CIP-01: an intermediate point on the line through start and end.
  const bool in_line =
      !broken && length(cross(to_via, to_end)) <= kRounding * (length(to_via) + length(to_end));
  if (in_line) {
    const bool between = dot(to_via, to_end) > 0 && dot(via_to_end, to_end) > 0;
    const bool refused = machine.follows("sie.cip.collinear=alarm"_reading) !=
                         machine.has("cip-straight-refused"_fault);
    broken = !between || refused;
  }
  if (broken) {
    return machine.complain(AlarmKind::kArcIntermediatePoint, first_intermediate_word(block),
                            block);
  }
  if (in_line) return plan_line(machine, target, feed, plan);
  const Direction heading =
      heading_at_end(way_between(target.to, from), way_between(target.to, via));
  if (machine.has("cip-sense-flipped"_fault)) take_other_side(from, target.to, via);
  plan = [&machine, target, feed, via, heading] {
    const Point middle = machine.output(via);
    const Point to = machine.output(target.to);
    const Axes axes = machine.frame.to_machine(target.axes);
    arrive(machine, target, heading);
    return machine.tracer.space_arc(middle, to, axes, feed);
  };
}

}  // namespace gonogo::expanders::sinumerik
