// SPDX-License-Identifier: GPL-3.0-or-later
// What the cycles have in common.
#pragma once

#include "expanders/hnc/plan.hpp"

namespace gonogo::expanders::hnc {

/// C.
struct CycleEnd {
  Fixed x = 0;
  Fixed z = 0;
};

/// The coordinates that a running cycle block commands; those that it does not need are the
/// position's (HNC-MOD-03). Complains about what is missing.
CycleEnd cycle_end(Machine& machine, const Block& block, bool needs_x, bool needs_z);

/// Whether the block of a cycle moves nothing: it has no axis word, or under the reading
/// hnc.missing-axis = nothing lacks one that the cycle needs.
bool is_idle(const Machine& machine, const Block& block, bool needs_x, bool needs_z);

/// Keeps C for blocks that leave a coordinate out.
void keep_end(Machine& machine, const CycleEnd& end);

/// The feed of a cycle; complains when there is none in force (HNC-COM-01, HNC-MOD-04).
Feed cycle_feed(Machine& machine);

/// `from` + `by`; complains when it is out of reach.
Fixed moved(Machine& machine, Fixed from, Fixed by);

/// Takes in R and Q of G74 and G75 (HNC-G74-01). `halved`: they are diameter values.
void take_pecks(Machine& machine, const Block& block, bool halved);

/// Fills in how the pecks of a running block go, from what is in force.
void prepare_pecks(Machine& machine, const Block& block, Pecks& pecks);

/// From the position to the bottom, with withdrawals between (HNC-G74-02).
bool perform_pecks(Machine& machine, const Pecks& pecks);

}  // namespace gonogo::expanders::hnc
