// SPDX-License-Identifier: GPL-3.0-or-later
// CIP: the circle in space through start, intermediate point and end.
#include <cmath>

#include "expanders/sinumerik/circles.hpp"
#include "expanders/sinumerik/plan.hpp"

namespace gonogo::expanders::sinumerik {
namespace {

using Way = std::array<Fixed, 3>;

Way way(const Point& from, const Point& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

Wide dot(const Way& a, const Way& b) {
  return static_cast<Wide>(a[0]) * b[0] + static_cast<Wide>(a[1]) * b[1] +
         static_cast<Wide>(a[2]) * b[2];
}

std::array<Wide, 3> cross(const Way& a, const Way& b) {
  auto part = [&](std::size_t i, std::size_t j) {
    return static_cast<Wide>(a[i]) * b[j] - static_cast<Wide>(a[j]) * b[i];
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

bool is_nothing(const Way& a) {
  return a == Way{};
}

// SIE-CIP-01: whether the intermediate point lies on the line through start and end.
bool on_line(const Way& to_via, const Way& to_end, bool rounded) {
  const std::array<Wide, 3> normal = cross(to_via, to_end);
  if (!rounded) return normal == std::array<Wide, 3>{};
  double square = 0;
  for (const Wide part : normal) square += static_cast<double>(part) * static_cast<double>(part);
  return square <= kRounding * kRounding * static_cast<double>(dot(to_end, to_end));
}

using Direction = Frame::Direction;

Real dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction direction(const Target& from, const Target& to) {
  Direction result{};
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    result[axis] = static_cast<Real>(to.to[axis] - from.to[axis]) +
                   (to.remainder[axis] - from.remainder[axis]);
  }
  return result;
}

// Turning the circle about the end inside out makes it a line in the direction of the tangent.
Heading heading_of(const Direction& end_to_start, const Direction& end_to_via) {
  const Real start_square = dot(end_to_start, end_to_start);
  const Real via_square = dot(end_to_via, end_to_via);
  Direction step{};
  Direction sum{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    step[axis] = end_to_start[axis] - end_to_via[axis];
    sum[axis] = end_to_start[axis] + end_to_via[axis];
  }
  const Real difference = -dot(step, sum);
  Heading heading;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // In parts of the squares, for they are large.
    heading.along[axis] =
        step[axis] * (via_square / start_square) + end_to_via[axis] * (difference / start_square);
  }
  return heading;
}

// The fault that goes round the other way: the far end of the line from the intermediate point
// through the middle of the chord.
void take_other_side(const Point& from, SpaceArc& arc) {
  std::array<double, 3> out{};
  double square = 0;
  double chord = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto end = static_cast<double>(arc.target.to[axis] - from[axis]);
    out[axis] = static_cast<double>(arc.via[axis] - from[axis]) - end / 2;
    square += out[axis] * out[axis];
    chord += end * end;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto middle = static_cast<double>(arc.target.to[axis] - from[axis]) / 2;
    arc.via[axis] = from[axis] + std::llround(middle - out[axis] * chord / (4 * square));
  }
}

// SIE-CIP-02: what has no word is that of the start.
Target take_intermediate(Machine& machine, const Block& block) {
  const State& state = machine.state;
  Target via{state.position, kLinearAxes, state.rounded, state.remainder};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Address address = intermediate_address(axis);
    if (!block.has(address)) continue;
    const Value& value = block.value(address);
    const bool fixed =
        machine.has(Fault::kIntermediateAbsolute) && value.mode == Value::Mode::kPlain;
    Wide place = length_of(machine, block, address);
    if (is_incremental(state, value.mode) && !fixed) {
      place += state.position[axis];
    } else {
      via.remainder[axis] = 0;
    }
    if (value.number.finer) via.rounded |= axis_bit(axis);
    if (!in_reach(place)) {
      machine.complain(AlarmKind::kValueOutOfRange, address, block);
      continue;
    }
    via.to[axis] = static_cast<Fixed>(place);
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
  refuse(machine, block, kArcWords | kPolarWords | bit(Address::kTurn));
  if (!block.has_any(kIntermediateWords)) machine.complain(AlarmKind::kMissingWord);
  const State& state = machine.state;
  SpaceArc arc;
  arc.target = cartesian_target(machine, block);
  const Target start{state.position, kLinearAxes, state.rounded, state.remainder};
  const Target via = take_intermediate(machine, block);
  const Axes rounded = state.rounded | arc.target.rounded | via.rounded;
  arc.via = via.to;
  arc.feed = cutting_feed(machine, arc.target.to, true);
  if (machine.in_alarm()) return;
  const Way to_via = way(state.position, arc.via);
  const Way to_end = way(state.position, arc.target.to);
  const Way via_to_end = way(arc.via, arc.target.to);
  const AlarmKind kBroken = AlarmKind::kArcIntermediatePoint;
  if (is_nothing(to_via) || is_nothing(to_end) || is_nothing(via_to_end)) {
    return machine.complain(kBroken, first_intermediate_word(block), block);
  }
  arc.target.axes |= kLinearAxes;
  if (on_line(to_via, to_end, (rounded & kLinearAxes) != 0)) {
    const bool between = dot(to_via, to_end) > 0 && dot(via_to_end, to_end) > 0;
    if (!between || machine.has(Fault::kIntermediateStraightRefused)) {
      return machine.complain(kBroken, first_intermediate_word(block), block);
    }
    plan.heading = straight_heading(state, arc.target);
    plan.motion = Line{arc.target, false, arc.feed};
    return;
  }
  plan.heading = heading_of(direction(arc.target, start), direction(arc.target, via));
  if (machine.has(Fault::kThroughPointSenseFlipped)) take_other_side(state.position, arc);
  plan.motion = arc;
}

bool perform(Machine& machine, const SpaceArc& arc) {
  return machine.tracer.space_arc(machine.frame.to_machine(arc.via),
                                  machine.frame.to_machine(arc.target.to),
                                  machine.frame.to_machine(arc.target.axes), arc.feed);
}

}  // namespace gonogo::expanders::sinumerik
