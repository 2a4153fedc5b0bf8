// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

bool moves_straight(const Point& from, const Point& to) {
  return from[GONOGO_X] != to[GONOGO_X] || from[GONOGO_Y] != to[GONOGO_Y] ||
         from[GONOGO_Z] != to[GONOGO_Z];
}

// NGC-MOD-02: G0 or G1 without an axis word.
void check_bare(Machine& machine, const Block& block, bool cut) {
  if (block.code(Group::kMotion) == nullptr) return;
  if (machine.configuration.motion_needs_axis) {
    machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  } else if (cut && machine.spares("bare-feed-unchecked"_fault, machine.state.feed.linear == 0)) {
    machine.complain(AlarmKind::kFeedMissing);
  }
}

}  // namespace

// NGC-G0-01, NGC-DIS-01
void prepare_line(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  Line line;
  line.to = commanded_point(machine, block, line.axes);
  line.cut = state.motion == Motion::kLine;
  if (line.axes == 0) return check_bare(machine, block, line.cut);
  if (line.cut && state.feed.linear == 0) machine.complain(AlarmKind::kFeedMissing);
  const bool linear =
      machine.alters("rotary-feed-scaled"_fault, moves_straight(state.position, line.to), true);
  line.feed.value = linear ? state.feed.linear : state.feed.rotary;
  plan.motion = line;
}

bool perform(Machine&, const Idle&) {
  return true;
}

bool perform(Machine& machine, const Line& line) {
  return line.cut ? machine.tracer.feed(line.to, line.axes, line.feed)
                  : machine.tracer.rapid(line.to, line.axes);
}

}  // namespace gonogo::expanders::ngc
