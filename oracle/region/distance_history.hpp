// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where the units of a path end, by time: which unit was the last to end farther off than a limit.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "oracle/region/interval.hpp"

namespace gonogo::oracle::region {

struct CutUnit;

class DistanceHistory {
 public:
  // The units must outlive it.
  explicit DistanceHistory(std::span<const CutUnit> units);

  // The last unit before `unit` whose end surely lies farther than `limit` from the point; -1:
  // none is found.
  std::int64_t last_beyond(std::size_t unit, const IntervalVector& point, Interval limit) const;

 private:
  struct Box {
    double low_x, high_x, low_y, high_y;
  };
  bool may_be_beyond(const Box& box, double x, double y, double limit) const;

  std::span<const CutUnit> units_;
  std::size_t leaves_ = 1;  // a power of two
  std::vector<Box> boxes_;  // a binary tree: the root is 1, the children of k are 2 k and 2 k + 1
};

}  // namespace gonogo::oracle::region
