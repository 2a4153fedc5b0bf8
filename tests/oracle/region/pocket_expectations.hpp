// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expectations for pockets with rounded corners that re-check the evidence of every verdict.
#pragma once

#include "tests/oracle/region/expectations.hpp"
#include "tests/oracle/region/naive.hpp"
#include "tests/oracle/region/pockets.hpp"

namespace gonogo::oracle::region {

// Whether the point must be cleared: in the area, and not in what was cleared before.
bool must_be_cleared(const RectangularLevel& level, const PlanePoint& point);
// How far the point is from the motions and the plunge point. REQUIRES: all arcs are round.
Number exact_distance(const Pocket& pocket, const PlanePoint& point);

// What is wrong with a NO-GO, derived again from the motions; empty when the witness holds.
std::string flaw_of_finding(const Pocket& pocket, const Finding& finding);
// A place that a GO leaves uncovered by more than 1e-6, sampled densely in doubles; empty: none.
std::string flaw_of_go(const Pocket& pocket);

// Only the border, with a tool of 5, plunged on one of its long sides: they are 10 less than the
// pocket's width apart, and reach 5.001 each.
inline Pocket sides_apart(std::string_view width) {
  Pocket job = pocket("60", width, "5", "5", "0");
  job.level.plunge = {Number(), -border_of(job).core_q};
  finish(job);
  return job;
}

}  // namespace gonogo::oracle::region
