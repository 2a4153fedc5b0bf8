// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

/// G0 and G1.
struct Line {
  Point to{};
  Axes axes = 0;
  bool cut = false;
  Feed feed;
};

bool moves_straight(const Point& from, const Point& to) {
  return from[GONOGO_X] != to[GONOGO_X] || from[GONOGO_Y] != to[GONOGO_Y] ||
         from[GONOGO_Z] != to[GONOGO_Z];
}

// NGC-MOD-02: G0 or G1 without an axis word.
void check_bare(Machine& machine, const Block& block, bool cut) {
  if (block.code(Group::kMotion) == nullptr) return;
  if (machine.follows("ngc.bare-motion=missing-word"_reading)) {
    machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  } else if (cut && machine.spares("bare-feed-unchecked"_fault, machine.state.feed.linear == 0)) {
    machine.complain(AlarmKind::kFeedMissing);
  }
}

// NGC-FED-01: the speed at which the way takes 1/F minutes.
Fixed timed(Machine& machine, const Block& block, const Point& to) {
  if (!block.has('F')) {
    machine.complain(AlarmKind::kFeedMissing);
    return 0;
  }
  const Point& from = machine.state.position;
  const bool straight = moves_straight(from, to);
  long double squares = 0;
  for (std::size_t axis = 0; axis < GONOGO_AXES; ++axis) {
    const bool is_linear = (kLinearAxes & axis_bit(axis)) != 0;
    if (machine.spares("inverse-time-of-all-axes"_fault, straight != is_linear)) continue;
    const auto way = static_cast<long double>(to[axis] - from[axis]);
    squares += way * way;
  }
  return timed_feed(block, std::sqrt(squares));
}

}  // namespace

Fixed timed_feed(const Block& block, long double way) {
  const auto turns = static_cast<long double>(block.number('F').value) / kOne;
  return static_cast<Fixed>(std::llround(way * turns));
}

// NGC-G0-01, NGC-DIS-01
void prepare_line(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  Line line;
  line.to = commanded_point(machine, block, line.axes);
  line.cut = state.motion == Motion::kLine;
  if (line.axes == 0) return check_bare(machine, block, line.cut);
  const bool linear =
      machine.alters("rotary-feed-scaled"_fault, moves_straight(state.position, line.to), true);
  if (line.cut && state.feed_mode == FeedMode::kInverseTime) {
    line.feed.value = timed(machine, block, line.to);
  } else {
    if (line.cut && state.feed.linear == 0) machine.complain(AlarmKind::kFeedMissing);
    line.feed = feed_of(state);
    if (!linear) line.feed.value = state.feed.rotary;
  }
  plan.motion = [&machine, line] {
    return line.cut ? machine.tracer.feed(line.to, line.axes, line.feed)
                    : machine.tracer.rapid(line.to, line.axes);
  };
}

}  // namespace gonogo::expanders::ngc
