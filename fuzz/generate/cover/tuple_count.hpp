// SPDX-License-Identifier: GPL-3.0-or-later
//
// How complete rows are, counted by trying every tuple: what the corpus states as its completeness.
// Shares nothing with the maker of covering arrays but the parameters.
#pragma once

#include "fuzz/generate/cover/covering_array.hpp"

namespace gonogo::cover {

struct TupleCount {
  std::size_t allowed = 0;           // tuples that some row within the rules holds
  std::size_t covered = 0;           // of them, that one of the rows holds
  std::size_t excluded = 0;          // tuples that the rules leave no row for
  std::vector<std::string> missing;  // the uncovered: "plane=G18 R=zero"
  std::vector<std::string> invalid;  // rows that break a rule or have two faults

  bool complete() const { return covered == allowed && invalid.empty(); }
};

TupleCount count_tuples(const Parameters& parameters, Strength strength,
                        const std::vector<Row>& rows);

// The tuples that one row covers, as in `missing`.
std::vector<std::string> tuples_of(const Parameters& parameters, Strength strength, const Row& row);

}  // namespace gonogo::cover
