// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of a program of path commands, to be compared exactly with what it says
// of the same path written in another way, in other axes, or backwards.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "axes_change.hpp"
#include "gsk988ta/expanding.hpp"

namespace gonogo::reference::testing {

struct PathItem {
  int kind = 0;  // of the item
  RecordKind record = RecordKind::rapid;
  std::uint64_t block = 0;
  ClauseId clause = kNoClause;
  Plane plane = Plane::g17;
  std::array<bool, kAxes> named = {};
  std::array<Number, kAxes> to = {};  // of named axes
  std::array<Number, 3> via = {};     // of arc3
  std::array<Number, 2> centre = {};  // of arc
  int rot = 0;
  Number feed;
  FeedMode feed_mode = FeedMode::per_minute;
  Number seconds;
  std::vector<std::pair<AlarmClass, ClauseId>> alarms;  // in the order of their classes
};
using PathTrace = std::vector<PathItem>;

bool operator==(const PathItem& a, const PathItem& b);
std::ostream& operator<<(std::ostream& out, const PathTrace& trace);

PathItem path_item(const Item& item);
PathTrace path_trace(const std::string& program, const Profile& profile);

// In the new axes.
PathTrace changed(PathTrace trace, const AxesChange& change);
// The motions alone, walked from the end back to the start; without blocks.
PathTrace reversed(const PathTrace& trace, const Vector& start);
// Without what says where a record comes from.
PathTrace without_blocks(PathTrace trace);
PathTrace without_clauses(PathTrace trace);
// The motions alone.
PathTrace motions_of(PathTrace trace);

}  // namespace gonogo::reference::testing
