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

std::array<Wide, 3> cross(const Way& a, const Way& b) {
  auto part = [&](std::size_t i, std::size_t j) {
    return static_cast<Wide>(a[i]) * b[j] - static_cast<Wide>(a[j]) * b[i];
  };
  return {part(1, 2), part(2, 0), part(0, 1)};
}

using Direction = Frame::Direction;

Real dot(const Direction& a, const Direction& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Real length(const Direction& a) {
  return std::hypot(a[0], a[1], a[2]);
}

bool is_nothing(const Direction& a) {
  return a == Direction{};
}

enum class OnLine { kYes, kNo, kUnclear };

// SIE-CIP-01: whether the intermediate point lies on the line through start and end.
OnLine on_line(const Target& start, const Target& via, const Target& end) {
  const Axes rounded = start.rounded | via.rounded | end.rounded;
  if ((rounded & kLinearAxes) == 0) {
    const auto normal = cross(way(start.to, via.to), way(start.to, end.to));
    return normal == std::array<Wide, 3>{} ? OnLine::kYes : OnLine::kNo;
  }
  const Direction to_via = way_between(start, via);
  const Direction to_end = way_between(start, end);
  const Real off = length(cross(to_via, to_end)) / length(to_end);
  const Real spread = 1 + length(to_via) / length(to_end);
  if (((start.coarse | via.coarse | end.coarse) & kLinearAxes) != 0) {
    return off <= kRounding * spread ? OnLine::kUnclear : OnLine::kNo;
  }
  Real farthest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    farthest = std::fmax(farthest, static_cast<Real>(magnitude(end.to[axis])));
  }
  // What is below that may be no more than rounding, or as far beside as the text says.
  constexpr Real kProcessor = 4e-18L;
  if (off <= farthest * kProcessor * spread) return OnLine::kYes;
  return off <= fine_rounding(farthest) * spread ? OnLine::kUnclear : OnLine::kNo;
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
  Target via = start_of(state);
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
      via.rounded &= ~axis_bit(axis);
      via.coarse &= ~axis_bit(axis);
    }
    if (value.number.finer) {
      via.rounded |= axis_bit(axis);
      via.coarse |= axis_bit(axis);
    }
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
  const Target start = start_of(state);
  const Target via = take_intermediate(machine, block);
  arc.via = via.to;
  arc.feed = cutting_feed(machine, arc.target.to, true);
  if (machine.in_alarm()) return;
  const Direction to_via = way_between(start, via);
  const Direction to_end = way_between(start, arc.target);
  const Direction via_to_end = way_between(via, arc.target);
  const AlarmKind kBroken = AlarmKind::kArcIntermediatePoint;
  if (is_nothing(to_via) || is_nothing(to_end) || is_nothing(via_to_end)) {
    return machine.complain(kBroken, first_intermediate_word(block), block);
  }
  arc.target.axes |= kLinearAxes;
  const OnLine in_line = on_line(start, via, arc.target);
  if (in_line == OnLine::kUnclear) machine.lacking = kFlatArc;
  if (in_line == OnLine::kYes) {
    const bool between = dot(to_via, to_end) > 0 && dot(via_to_end, to_end) > 0;
    if (!between || machine.has(Fault::kIntermediateStraightRefused)) {
      return machine.complain(kBroken, first_intermediate_word(block), block);
    }
    plan.heading = straight_heading(state, arc.target);
    plan.motion = Line{arc.target, false, arc.feed};
    return;
  }
  const Direction end_to_start = way_between(arc.target, start);
  const Direction end_to_via = way_between(arc.target, via);
  plan.heading = heading_of(end_to_start, end_to_via);
  const Real beside =
      doubt_between(start, arc.target, kLinearAxes) + doubt_between(start, via, kLinearAxes);
  plan.heading.doubt = beside / std::fmin(length(end_to_start), length(end_to_via));
  if (machine.has(Fault::kThroughPointSenseFlipped)) take_other_side(state.position, arc);
  plan.motion = arc;
}

bool perform(Machine& machine, const SpaceArc& arc) {
  return machine.tracer.space_arc(machine.frame.to_machine(arc.via),
                                  machine.frame.to_machine(arc.target.to),
                                  machine.frame.to_machine(arc.target.axes), arc.feed);
}

}  // namespace gonogo::expanders::sinumerik
