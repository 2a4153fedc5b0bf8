// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/distance_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/region/constants.hpp"
#include "oracle/region/order.hpp"

namespace gonogo::oracle::region {

DistanceHistory::DistanceHistory(std::span<const CutUnit> units) : units_(units) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  while (leaves_ < units.size()) leaves_ *= 2;
  boxes_.assign(2 * leaves_, Box{kFar, -kFar, kFar, -kFar});
  for (std::size_t i = 0; i < units.size(); ++i) {
    const double x = median(units[i].end.x());
    const double y = median(units[i].end.y());
    boxes_[leaves_ + i] = {x, x, y, y};
  }
  for (std::size_t k = leaves_ - 1; k > 0; --k) {
    const Box& a = boxes_[2 * k];
    const Box& b = boxes_[2 * k + 1];
    boxes_[k] = {std::min(a.low_x, b.low_x), std::max(a.high_x, b.high_x),
                 std::min(a.low_y, b.low_y), std::max(a.high_y, b.high_y)};
  }
}

// By its corner that is farthest off. False of an empty one.
bool DistanceHistory::may_be_beyond(const Box& box, double x, double y, double limit) const {
  if (!(box.low_x <= box.high_x)) return false;
  const double dx = std::max(x - box.low_x, box.high_x - x);
  const double dy = std::max(y - box.low_y, box.high_y - y);
  return dx * dx + dy * dy > limit * limit;
}

std::int64_t DistanceHistory::last_beyond(std::size_t unit, const IntervalVector& point,
                                          Interval limit) const {
  // So far beyond that the enclosures agree.
  const double x = median(point.x());
  const double y = median(point.y());
  const double least = limit.sup() * (1 + kBeside) + kBeside;
  // The subtrees that hold the units before `unit`, the last ones first; then down to the right.
  for (std::size_t k = leaves_ + unit; k > 1; k /= 2) {
    if (k % 2 == 0) continue;
    std::vector<std::size_t> open{k - 1};
    while (!open.empty()) {
      const std::size_t node = open.back();
      open.pop_back();
      if (!may_be_beyond(boxes_[node], x, y, least)) continue;
      if (node < leaves_) {
        open.push_back(2 * node);
        open.push_back(2 * node + 1);
        continue;
      }
      const std::size_t found = node - leaves_;
      if (norm(units_[found].end - point).inf() > limit.sup())
        return static_cast<std::int64_t>(found);
    }
  }
  return -1;
}

}  // namespace gonogo::oracle::region
