// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-CYC-02: which records make progress, so that they do not count against the budget of records.
#pragma once

#include <cstdint>
#include <unordered_set>

#include "oracle/judge/motion.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

// Whether a straight motion brings an axis nearer to where it is due by more than the tolerance,
// and none farther from it. As many do so as the way has tolerances.
bool comes_nearer(const Motion& motion, const Position& due, const Number& tolerance);

// Whether a motion ends within the pocket of a level, as far as that is wide along each axis.
bool ends_in_pocket(const Motion& motion, const reference::PocketLevel& level);

// The places, four tolerances wide, that a path has been to.
class VisitedPlaces {
 public:
  // Whether the path has not been here since it came to step number `step`. No more than
  // kMaximumPlaces of a step are new.
  bool is_new(std::size_t step, const Position& at, const Number& tolerance);

  static constexpr std::size_t kMaximumPlaces = 200'000;

 private:
  std::size_t step_ = 0;
  std::unordered_set<std::uint64_t> places_;
};

}  // namespace gonogo::oracle
