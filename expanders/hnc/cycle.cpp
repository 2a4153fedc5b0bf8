// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/cycle.hpp"

namespace gonogo::expanders::hnc {
namespace {

// HNC-MOD-03.
Fixed coordinate(Machine& machine, const Block& block, std::size_t axis) {
  if (axis_word(machine, block, axis).present) return target(machine, block, axis);
  const bool is_x = axis == GONOGO_X;
  const Retained& kept = is_x ? machine.state.store.end_x : machine.state.store.end_z;
  switch (machine.configuration.missing_axis) {
    case MissingAxis::kNone:
      return machine.state.position[axis];
    case MissingAxis::kKeep:
      if (kept.present) return kept.value;
      break;
    case MissingAxis::kReject:
    case MissingAxis::kNothing:  // is_idle
      break;
  }
  machine.complain(AlarmKind::kMissingWord, is_x ? 'X' : 'Z', kNowhere);
  return machine.state.position[axis];
}

}  // namespace

bool is_idle(const Machine& machine, const Block& block, bool needs_x, bool needs_z) {
  if (!block.has_any(kAxisAddresses)) return true;
  if (machine.configuration.missing_axis != MissingAxis::kNothing) return false;
  return (needs_x && !axis_word(machine, block, GONOGO_X).present) ||
         (needs_z && !axis_word(machine, block, GONOGO_Z).present);
}

CycleEnd cycle_end(Machine& machine, const Block& block, bool needs_x, bool needs_z) {
  CycleEnd end{machine.state.position[GONOGO_X], machine.state.position[GONOGO_Z]};
  if (needs_x) end.x = coordinate(machine, block, GONOGO_X);
  if (needs_z) end.z = coordinate(machine, block, GONOGO_Z);
  return end;
}

void keep_end(Machine& machine, const CycleEnd& end) {
  machine.state.store.end_x = {true, end.x};
  machine.state.store.end_z = {true, end.z};
}

Feed cycle_feed(Machine& machine) {
  const State& state = machine.state;
  const bool own = machine.configuration.cycle_feed_forgotten;
  const Feed feed{own ? state.store.feed : state.feed,
                  state.per_revolution && !machine.has(Fault::kRevolutionIgnored)};
  if (feed.value == 0) machine.complain(AlarmKind::kFeedMissing);
  return feed;
}

Fixed moved(Machine& machine, Fixed from, Fixed by) {
  const Wide place = static_cast<Wide>(from) + by;
  if (fits(place)) return static_cast<Fixed>(place);
  machine.complain(AlarmKind::kValueOutOfRange);
  return from;
}

}  // namespace gonogo::expanders::hnc
