// SPDX-License-Identifier: GPL-3.0-or-later
// G00, G01, G04, G32 and G92.
#include "expanders/hnc/machine.hpp"

namespace gonogo::expanders::hnc {

// P milliseconds or seconds; nothing else of the block counts.
void prepare_dwell(Machine& machine, const Block& block, Plan& plan) {
  if (!block.has('P')) return machine.complain(AlarmKind::kMissingWord, 'P', kNowhere);
  const Fixed written = block.number('P').value;
  if (written < 0) return machine.complain(AlarmKind::kValueSign, 'P', block);
  const Fixed parts = machine.follows("hnc.dwell.unit=s"_reading) ? 1 : 1000;
  plan = [&machine, seconds = static_cast<Fixed>(scaled(written, 1, parts))] {
    return machine.tracer.dwell(seconds);
  };
}

// The position gets new work coordinates: X and Z are absolute under G91 too, U and W change those
// in force.
void prepare_rename(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  Point position = state.position;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Z}) {
    const AxisWord word = axis_word(machine, block, axis);
    if (!word.present) continue;
    const bool absolute = word.address == 'X' || word.address == 'Z';
    Wide place = word.value;
    if (!absolute) {
      place += state.position[axis];
    } else if (state.frame != nullptr && !machine.has("rename-ignores-offset"_fault)) {
      place += (*state.frame)[axis];
    }
    if (!fits(place)) {
      machine.complain(AlarmKind::kValueOutOfRange, word.address, block);
      continue;
    }
    position[axis] = static_cast<Fixed>(place);
  }
  plan = [&machine, position] {
    machine.state.position = position;
    return true;
  };
}

void prepare_line(Machine& machine, const Block& block, Plan& plan) {
  Axes axes = 0;
  const Point to = commanded_point(machine, block, axes);
  if (axes == 0) return;
  const bool cut = machine.state.motion == Motion::kLine;
  if (cut && machine.state.feed == 0) machine.complain(AlarmKind::kFeedMissing);
  plan = [&machine, to, axes, cut] {
    return cut ? machine.tracer.feed(to, axes, feed_in_force(machine))
               : machine.tracer.rapid(to, axes);
  };
}

namespace {

// Reading hnc.g32.lead = feed: F in force, which means as a lead what it would in the block.
Fixed lead_of_feed(const Machine& machine) {
  const State& state = machine.state;
  const bool counts_inches = machine.follows("hnc.lead.unit=units"_reading) ||
                             machine.follows("hnc.lead.unit=units-tpi"_reading);
  if (!state.inch || counts_inches) return state.feed;
  return static_cast<Fixed>(scaled(state.feed, 10, 254));
}

}  // namespace

// G32: one thread, straight or tapered.
void prepare_thread(Machine& machine, const Block& block, Plan& plan) {
  Axes axes = 0;
  const Point to = commanded_point(machine, block, axes);
  if (axes == 0) return;
  Fixed& own = machine.state.store.lead;
  if (own == 0 && machine.follows("hnc.g32.lead=feed"_reading)) own = lead_of_feed(machine);
  const Fixed lead = own;
  if (lead == 0) machine.complain(AlarmKind::kLeadMissing);  // HNC-MOD-04
  if (machine.has("thread-lead-forgotten"_fault)) machine.state.store.lead = 0;
  plan = [&machine, to, axes, lead] { return machine.tracer.thread(to, axes, lead); };
}

}  // namespace gonogo::expanders::hnc
