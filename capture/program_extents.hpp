// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far, and how fast, a program takes the machine at most, under every combination of the
// readings that it leaves open.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "oracle/judge/judge_session.hpp"

namespace gonogo::oracle {

struct Extents {
  reference::Position low;  // mm as true lengths, degrees
  reference::Position high;
  AxisSet moved;                // the axes that a motion names
  Number largest_feed;          // mm/min, of the feeds per minute
  bool per_revolution = false;  // feeds in mm/rev: no bound in mm/min without a spindle speed
  bool threads = false;         // the same of spindle-synchronous motions
  bool alarms = false;          // ends with an alarm: what stands behind it is not bounded
  bool not_covered = false;     // ... where the gauge stops reading
};

// The box of the start, and of every end and extreme point of the path; where the manual leaves the
// path open, also of all that may be cleared. Circles in space count whole. Nothing where the
// readings have too many assignments. May throw exact::Undecided.
std::optional<Extents> extents_of(const reference::Profile& profile, std::string_view program);

}  // namespace gonogo::oracle
