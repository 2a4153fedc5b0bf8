// SPDX-License-Identifier: GPL-3.0-or-later
//
// Records of the corpus in a short form that people can type:
//   "2 rapid z0"                         line, kind, axes that are named in the order x y z a c
//   "2 feed x0 z0 f200"                  the path feed, /rev behind it under G99
//   "2 arc G18 -1 cx25 cz50.75 x25 z51.5 f800"   plane, turns, centre, end point
//   "3 arc3 via x1 y2 z3 to x4 y5 z6 f100"
//   "4 thread x30 z-28 lead3"
//   "3 dwell 2.5", "1 m 3", "end x65 y0 z5 a0 c0"
#pragma once

#include <string>
#include <vector>

#include "reference/record.hpp"

namespace gonogo::testing {

using Lines = std::vector<std::string>;

using NumberText = std::string (*)(const reference::Number&);
std::string line_of(const reference::Record& record, NumberText text);

// The records of one expectation of a checked-in case; throws std::out_of_range when there is none.
Lines records_of(const std::string& id, std::size_t expectation = 0);

// One after the other.
Lines operator+(Lines a, const Lines& b);

}  // namespace gonogo::testing
