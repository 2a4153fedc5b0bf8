// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/figure_spread.hpp"

#include <algorithm>

namespace gonogo::oracle::report {
namespace {

// Between two motions, of the line's length: upright ones have their numbers in the gap.
constexpr double kGapOfLevel = 0.06;
constexpr double kGapOfUpright = 0.1;

Point3 shifted(const Point3& point, const Direction& step, double times) {
  return {point.x + step.x * times, point.y + step.y * times, point.z + step.z * times};
}

}  // namespace

std::optional<Spread> spread_for(const Extent& extent, bool lathe) {
  const double x = extent.high.x - extent.low.x;
  const double y = extent.high.y - extent.low.y;
  const double z = extent.high.z - extent.low.z;
  if ((x > kStill) + (y > kStill) + (z > kStill) != 1) return std::nullopt;
  const bool level = (lathe ? z : x) > kStill;
  const double gap = (level ? kGapOfLevel : kGapOfUpright) * std::max({x, y, z});
  // To the right on the sheet, or downwards.
  if (x > kStill) return Spread{{0, 0, lathe ? gap : -gap}, 'Z'};
  return Spread{{lathe && z > kStill ? -gap : gap, 0, 0}, 'X'};
}

Path spread_out(const Path& path, const Spread& spread) {
  Path out = path;
  double times = 0;
  for (Motion& motion : out.motions) {
    // What does not move stands where the motion before it ended.
    const double place = motion.moves() ? times : std::max(0.0, times - 1);
    for (Point3& point : motion.points) point = shifted(point, spread.step, place);
    if (motion.moves()) times += 1;
  }
  return out;
}

}  // namespace gonogo::oracle::report
