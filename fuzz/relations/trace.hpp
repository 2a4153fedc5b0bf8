// SPDX-License-Identifier: GPL-3.0-or-later
//
// What two runs of related programs put out, side by side.
#pragma once

#include <string>

#include "oracle/records/subject_outcome.hpp"
#include "fuzz/relations/relation.hpp"

namespace gonogo::relations {

struct Trace {
  std::vector<reference::Record> records;
  oracle::RunEnd end;
  // Whether it can be compared: expanded, or an alarm.
  bool answered() const {
    return end.kind == oracle::RunEnd::Kind::ok || end.kind == oracle::RunEnd::Kind::alarm;
  }
};

// Whether they differ by no more than the tolerance; what cannot be compared does not.
bool is_near(const Number& a, const Number& b, const Number& tolerance);

// The first thing in which the other trace is not what the first one asks for.
struct Difference {
  std::size_t record = 0;   // from 1, of the other trace
  std::uint64_t block = 0;  // line of the first program; 0: not known
  std::string want;         // the record or alarm that the first program asks for; empty: none
  std::string got;          // what came; empty: nothing
};

// Numbers may differ by `tolerance`; enclosures that overlap are equal. Both
// traces have answers. Records without line numbers are compared without them; a beginning cannot
// be.
std::optional<Difference> first_difference(const Trace& first, const Trace& other,
                                           const Related& related, const Number& tolerance);

}  // namespace gonogo::relations
