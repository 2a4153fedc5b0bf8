// SPDX-License-Identifier: GPL-3.0-or-later
// G33 and G33.1.
#include <algorithm>
#include <cmath>

#include "expanders/ngc/plan.hpp"

namespace gonogo::expanders::ngc {
namespace {

/// G33 and G33.1.
struct Synchronous {
  Point to{};
  Axes axes = 0;
  Fixed lead = 0;  ///< along the longer axis
  bool tap = false;
  int spindle = 5;
};

// K is the lead along the way; a record has that along the longer axis.
Fixed lead_along_axis(const Machine& machine, const Point& to, Fixed path_lead) {
  const Point& from = machine.state.position;
  long double square = 0;
  Fixed longest = 0;
  for (const std::size_t axis : {GONOGO_X, GONOGO_Y, GONOGO_Z}) {
    const Fixed way = magnitude(to[axis] - from[axis]);
    longest = std::max(longest, way);
    square += static_cast<long double>(way) * static_cast<long double>(way);
  }
  if (longest == 0) return path_lead;
  const long double turn = static_cast<long double>(path_lead) / std::sqrt(square);
  const auto along = [&](Fixed way) {
    return static_cast<Fixed>(std::llround(turn * static_cast<long double>(way)));
  };
  const Fixed right = machine.alters("g33-lead-along-axis"_fault, along(longest), path_lead);
  return machine.alters("g33-lead-along-z"_fault, right,
                        along(magnitude(to[GONOGO_Z] - from[GONOGO_Z])));
}

// NGC-G33-02, 05: K counts for its block only.
Fixed take_lead(Machine& machine, const Block& block) {
  std::optional<Fixed>& last = machine.state.leftovers.lead;
  std::optional<Fixed> lead;
  if (block.has('K')) {
    lead = length_of(machine, block, 'K');
  } else {
    lead = machine.alters("g33-k-sticky"_fault, lead, last);
  }
  last = lead;
  if (!lead) machine.complain(AlarmKind::kLeadMissing, 'K', kNowhere);
  const Fixed value = lead.value_or(kOne);
  if (value <= 0 && !machine.follows("ngc.g33.k=free"_reading)) {
    machine.complain(AlarmKind::kValueSign, 'K', block);
  }
  return value;
}

// NGC-G331-01, 02
bool run(Machine& machine, const Synchronous& motion) {
  Tracer& tracer = machine.tracer;
  const Point from = machine.state.position;
  if (!tracer.thread(motion.to, motion.axes, motion.lead)) return false;
  if (!motion.tap || machine.adds("g331-ends-at-bottom"_fault)) return true;
  if (machine.adds("g331-without-reversal"_fault)) {
    return tracer.thread(from, motion.axes, motion.lead);
  }
  return tracer.function(motion.spindle == 3 ? 4 : 3) &&
         tracer.thread(from, motion.axes, motion.lead) && tracer.function(motion.spindle);
}

}  // namespace

// NGC-G33-01 to 04, NGC-G331-01
void prepare_synchronous(Machine& machine, const Block& block, Plan& plan) {
  const State& state = machine.state;
  Synchronous motion;
  motion.to = commanded_point(machine, block, motion.axes);
  motion.tap = state.motion == Motion::kG331;
  motion.spindle = state.spindle;
  if (motion.axes == 0) machine.complain(AlarmKind::kMissingWord, 'X', kNowhere);
  if (block.has('F') && machine.spares("g33-feed-passed"_fault)) {
    machine.complain(AlarmKind::kConflictingWords, 'F', block);
  }
  if (machine.spares("g33-stopped-passed"_fault, state.spindle == 5)) {
    machine.complain(AlarmKind::kSpindleStopped);
  }
  const Fixed lead = take_lead(machine, block);
  motion.lead = lead_along_axis(machine, motion.to, lead);
  plan.motion = [&machine, motion] { return run(machine, motion); };
}

}  // namespace gonogo::expanders::ngc
