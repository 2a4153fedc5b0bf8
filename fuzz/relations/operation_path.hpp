// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject made of a list of operations: the path without what dialects say differently,
// held against another one, and against what no path of these operations may do.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/relations/operation.hpp"
#include "fuzz/relations/trace.hpp"

namespace gonogo::relations {

// A motion or a dwell with where it begins. Negligible motions, dwells of no time, M
// functions and the end are left out.
struct Leg {
  reference::Record record;
  reference::Position from;
  reference::Position to;  // every axis
};
std::vector<Leg> legs_of(const Trace& trace, const reference::Position& start);

struct PathDifference {
  std::size_t leg = 0;  // from 1
  std::string want;     // the record of the first path; empty: it has ended
  std::string got;
  std::uint64_t block = 0;  // of the second path's program; 0: not known
};
// Kinds, ends, centres, senses, feeds and seconds; numbers may differ by `tolerance` mm, feeds and
// seconds not at all.
std::optional<PathDifference> first_difference(const std::vector<Leg>& first,
                                               const std::vector<Leg>& second,
                                               const Number& tolerance);

// What must never be under any manual.
enum class Rule : std::uint8_t {
  traverse_in_stock,  // a traverse through what has not been cut
  beyond_contour,     // deeper than the bottom of a hole, closer than the contour
  not_cut,            // a hole that is not there, or not deep enough
  retract_level,      // a hole is left at another level than its R plane or initial level
  peck_too_deep,      // more than a peck at once
};
std::string_view name(Rule rule);      // "traverse-in-stock"
std::string_view sentence(Rule rule);  // what has to hold

struct Breach {
  Rule rule = Rule::traverse_in_stock;
  std::size_t leg = 0;      // from 1; behind the last one: the end
  std::uint64_t block = 0;  // of the program; 0: not known
  std::string record;       // that breaks it; empty: the end
  std::string witness;      // a point of the machine where it does, "X10 Y0 Z-3"
};
// The first breach of each rule. Traverses along several axes at once may go any way: of them the
// ends count. A place that is only enclosed and may lie on a limit ends the search.
std::vector<Breach> breaches(const OperationList& list, const std::vector<Leg>& legs,
                             const Number& tolerance);

}  // namespace gonogo::relations
