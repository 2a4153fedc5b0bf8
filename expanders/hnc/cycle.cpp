// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/hnc/machine.hpp"

#include <utility>

namespace gonogo::expanders::hnc {
namespace {

// HNC-MOD-03.
Fixed coordinate(Machine& machine, const Block& block, std::size_t axis) {
  if (axis_word(machine, block, axis).present) return target(machine, block, axis);
  const bool is_x = axis == GONOGO_X;
  const Retained& kept = is_x ? machine.state.store.end_x : machine.state.store.end_z;
  if (!block.has_any(kAxisAddresses)) return kept.value;  // the cycle again
  if (machine.follows("hnc.missing-axis=none"_reading)) return machine.state.position[axis];
  if (machine.follows("hnc.missing-axis=keep"_reading) && kept.present) return kept.value;
  machine.complain(AlarmKind::kMissingWord, is_x ? 'X' : 'Z', kNowhere);
  return machine.state.position[axis];
}

// Reading hnc.empty-block.
bool runs_again(const Machine& machine, const Block& block, bool needs_x, bool needs_z) {
  constexpr AddressSet kOwn{"IKRECAPFJQ"};
  const State& state = machine.state;
  if (state.motion == Motion::kGroove || !(state.named || block.has_any(kOwn))) return false;
  if ((needs_x && !state.store.end_x.present) || (needs_z && !state.store.end_z.present)) {
    return false;
  }
  return machine.follows("hnc.empty-block=repeat"_reading);
}

}  // namespace

bool is_idle(const Machine& machine, const Block& block, bool needs_x, bool needs_z) {
  if (!block.has_any(kAxisAddresses)) return !runs_again(machine, block, needs_x, needs_z);
  if (!machine.follows("hnc.missing-axis=nothing"_reading)) return false;
  return (needs_x && !axis_word(machine, block, GONOGO_X).present) ||
         (needs_z && !axis_word(machine, block, GONOGO_Z).present);
}

CycleEnd cycle_end(Machine& machine, const Block& block, bool needs_x, bool needs_z) {
  CycleEnd end{machine.state.position[GONOGO_X], machine.state.position[GONOGO_Z]};
  if (needs_x) end.x = coordinate(machine, block, GONOGO_X);
  if (needs_z) end.z = coordinate(machine, block, GONOGO_Z);
  return end;
}

void take_up_words(Machine& machine, Motion before, const CycleStore& left) {
  State& state = machine.state;
  if (before == Motion::kThread && left.lead != 0) state.line_lead = left.lead;
  if (state.motion == Motion::kThread && machine.follows("hnc.g32.lead=kept"_reading)) {
    state.store.lead = state.line_lead;
  }
  if (is_cycle(before)) {
    state.kept_of = is_cycle(state.motion) ? Motion::kRapid : before;
    state.kept = left;
    state.kept.feed = 0;  // reading hnc.modal.f has it
    state.kept.end_x = state.kept.end_z = {};
  } else if (is_cycle(state.motion)) {
    const bool is_same = std::exchange(state.kept_of, Motion::kRapid) == state.motion;
    if (is_same && machine.follows("hnc.modal.words=kept"_reading)) state.store = state.kept;
  }
}

void keep_end(Machine& machine, const CycleEnd& end) {
  machine.state.store.end_x = {true, end.x};
  machine.state.store.end_z = {true, end.z};
}

Feed cycle_feed(Machine& machine) {
  const State& state = machine.state;
  const bool own = machine.follows("hnc.modal.f=forgotten"_reading);
  const Feed feed{own ? state.store.feed : state.feed,
                  state.per_revolution && !machine.has("revolution-ignored"_fault)};
  if (feed.value == 0) machine.complain(AlarmKind::kFeedMissing);
  return feed;
}

Fixed moved(Machine& machine, Fixed from, Fixed by) {
  const Wide place = static_cast<Wide>(from) + by;
  if (fits(place)) return static_cast<Fixed>(place);
  machine.complain(AlarmKind::kValueOutOfRange);
  return from;
}

bool cut_around(Machine& machine, std::size_t first, Fixed b, const CycleEnd& end, const Feed& feed,
                bool rapid_out) {
  Tracer& tracer = machine.tracer;
  const Point start = machine.state.position;
  const std::size_t second = first == GONOGO_X ? GONOGO_Z : GONOGO_X;
  if (!tracer.rapid_axis(first, b)) return false;  // A to B
  Point to = start;
  to[GONOGO_X] = end.x;
  to[GONOGO_Z] = end.z;
  if (!tracer.feed(to, kBothAxes, feed)) return false;  // B to C
  const bool out = rapid_out ? tracer.rapid_axis(first, start[first])
                             : tracer.feed_axis(first, start[first], feed);
  return out && tracer.rapid_axis(second, start[second]);  // C to D, D to A
}

}  // namespace gonogo::expanders::hnc
