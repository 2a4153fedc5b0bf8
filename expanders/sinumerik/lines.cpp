// SPDX-License-Identifier: GPL-3.0-or-later
// G0, G1 and the dwell.
#include "expanders/sinumerik/machine.hpp"

namespace gonogo::expanders::sinumerik {

void clear_untravelled(Machine& machine, Axes axes) {
  Direction& untravelled = machine.state.untravelled;
  Direction along = machine.frame.to_workpiece(untravelled);
  for (std::size_t axis = 0; axis < along.size(); ++axis) {
    if ((axes & axis_bit(axis)) != 0) along[axis] = 0;
  }
  untravelled = machine.frame.to_machine(along);
}

void arrive(Machine& machine, const Target& target, const Direction& heading) {
  State& state = machine.state;
  state.position = target.to;
  clear_untravelled(machine, target.axes);
  // SIE-CT-02: motions without length leave it.
  if (!is_nothing(heading)) state.heading = heading;
  const bool arc = state.motion == Motion::kClockwise || state.motion == Motion::kCounterclockwise;
  if (arc && machine.has("arc-not-modal"_fault)) state.motion = Motion::kLine;
}

void plan_line(Machine& machine, const Target& target, const std::optional<Feed>& feed,
               Plan& plan) {
  const bool kept = !feed && machine.has("ct-skips-rapids"_fault);
  const Direction way = kept ? Direction{} : way_between(machine.state.position, target.to);
  plan = [&machine, target, feed, way] {
    const Point to = machine.output(target.to);
    const Axes axes = machine.frame.to_machine(target.axes);
    arrive(machine, target, way);
    return feed ? machine.tracer.feed(to, axes, *feed) : machine.tracer.rapid(to, axes);
  };
}

void prepare_line(Machine& machine, const Block& block, bool rapid, Plan& plan) {
  refuse(machine, block, kArcWords | kIntermediateWords | bit(Address::kTurn));
  const Target target = target_of(machine, block);
  std::optional<Feed> feed;
  if (!rapid) feed = cutting_feed(machine, target.to, false);
  plan_line(machine, target, feed, plan);
}

// SIE-MOD-03
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  State& state = machine.state;
  const bool in_seconds = block.has(Address::kFeed);
  const bool in_turns = block.has(Address::kSpindle);
  if (!block.has_only(addresses(Address::kFeed, Address::kSpindle)) || (in_seconds && in_turns)) {
    machine.complain(AlarmKind::kConflictingWords);
  }
  if (!in_seconds && !in_turns) return machine.complain(AlarmKind::kMissingWord);
  const Address word = in_seconds ? Address::kFeed : Address::kSpindle;
  const Decimal& number = block.number(word);
  Fixed seconds = number.value;
  if (number.overflow || !in_reach(static_cast<Real>(seconds))) {
    return machine.complain(AlarmKind::kValueOutOfRange, word, block);
  }
  if (seconds < 0) return machine.complain(AlarmKind::kValueSign, word, block);
  if (!in_seconds && !machine.has("dwell-revolutions-as-seconds"_fault)) {
    if (state.speed == 0) return machine.complain(AlarmKind::kSpindleStopped, word, block);
    const Wide time = (static_cast<Wide>(seconds) * 60 * kOne + state.speed / 2) / state.speed;
    if (!in_reach(static_cast<Real>(time)))
      return machine.complain(AlarmKind::kValueOutOfRange, word, block);
    seconds = static_cast<Fixed>(time);
  }
  if (in_seconds && machine.has("dwell-feed-kept"_fault)) state.feed = seconds;
  plan = [&machine, seconds] { return machine.tracer.dwell(seconds); };
}

}  // namespace gonogo::expanders::sinumerik
