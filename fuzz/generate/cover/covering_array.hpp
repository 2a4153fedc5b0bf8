// SPDX-License-Identifier: GPL-3.0-or-later
//
// Covering arrays: few rows that hold every t-tuple of classes that the rules allow.
#pragma once

#include "fuzz/generate/cover/parameters.hpp"

namespace gonogo::cover {

// How many parameters a tuple names. A row with a fault shows nothing of its other classes but in
// their company with that fault, so tuples with and without one are covered apart.
struct Strength {
  unsigned valid = 3;   // of valid classes alone
  unsigned faulty = 2;  // of one class that must alarm and valid ones beside it
};

struct CoveringArray {
  std::vector<Row> rows;     // those without a fault first
  std::size_t tuples = 0;    // that the rows cover: all that the rules allow
  std::size_t excluded = 0;  // that no row may hold
};

// Deterministic: the same parameters, strength and seed give the same rows. Each row has at most
// one class that must alarm. A strength above the number of parameters counts as that number.
// Throws ModelError where the rules leave no row.
CoveringArray covering_array(const Parameters& parameters, Strength strength, std::uint64_t seed);

}  // namespace gonogo::cover
