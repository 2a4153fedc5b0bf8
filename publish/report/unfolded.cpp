// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/unfolded.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace gonogo::oracle::report {
namespace {

constexpr std::size_t kMostAtOnce = 120;  // motions that fit beside each other
constexpr int kLeastTurns = 4;            // to and fro twice

double value_of(const Point3& point, char axis) {
  return axis == 'X' ? point.x : axis == 'Y' ? point.y : point.z;
}

// Whether a motion takes a column: a negligible one takes none.
bool is_shown(const Motion& motion, std::uint64_t block) {
  const Point3& begin = motion.points.front();
  const auto leads_away = [&](const Point3& point) {
    return std::fabs(point.x - begin.x) > kStill || std::fabs(point.y - begin.y) > kStill ||
           std::fabs(point.z - begin.z) > kStill;
  };
  return motion.moves() && (block == 0 || motion.block == block) &&
         std::ranges::any_of(motion.points, leads_away);
}

// How often a coordinate changes its direction over motions that move nothing else.
int turns_of(const Path& path, char axis, std::uint64_t block) {
  int turns = 0;
  double last = 0;
  for (const Motion& motion : path.motions) {
    if (!is_shown(motion, block)) continue;
    const double way = value_of(motion.points.back(), axis) - value_of(motion.points.front(), axis);
    if (std::fabs(way) < kStill) continue;
    if (last != 0 && (way > 0) != (last > 0)) ++turns;
    last = way;
  }
  return turns;
}

// The block with most motions.
std::uint64_t busiest_block(const Path& path) {
  std::map<std::uint64_t, std::size_t> motions;
  for (const Motion& motion : path.motions) {
    if (motion.moves()) ++motions[motion.block];
  }
  const auto most = std::ranges::max_element(
      motions, [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == motions.end() ? 0 : most->first;
}

}  // namespace

std::optional<Unfolding> unfolding_of(const Path& path, std::uint64_t block) {
  const auto moving = static_cast<std::size_t>(std::ranges::count_if(path.motions, &Motion::moves));
  const std::uint64_t shown = moving <= kMostAtOnce ? 0 : block != 0 ? block : busiest_block(path);
  Unfolding best{'Z', shown};
  int most = 0;
  for (const char axis : {'Z', 'X', 'Y'}) {
    const int turns = turns_of(path, axis, shown);
    if (turns > most) {
      most = turns;
      best.axis = axis;
    }
  }
  if (most < kLeastTurns) return std::nullopt;
  return best;
}

Path unfolded(const Path& path, const Unfolding& how) {
  Path out = path;
  double place = 0;
  double last = path.motions.empty() ? 0 : value_of(path.motions.front().points.front(), how.axis);
  for (Motion& motion : out.motions) {
    if (!is_shown(motion, how.block) || place >= static_cast<double>(kMostAtOnce)) {
      motion.points = {Point3{place, 0, last}};
      continue;
    }
    const auto steps = static_cast<double>(motion.points.size() - 1);
    double step = 0;
    for (Point3& point : motion.points) {
      last = value_of(point, how.axis);
      point = {place + step++ / steps, 0, last};
    }
    place += 1;
  }
  return out;
}

void align(Path& departing, const std::optional<std::size_t>& motion, const Path& reference,
           const std::optional<std::size_t>& due) {
  if (!motion || !due || *motion >= departing.motions.size() || *due >= reference.motions.size()) {
    return;
  }
  const double from = departing.motions[*motion].points.front().x;
  const double to = reference.motions[*due].points.front().x;
  for (std::size_t i = 0; i < departing.motions.size(); ++i) {
    for (Point3& point : departing.motions[i].points) {
      point.x = i < *motion && from > 0 ? point.x * to / from : point.x + to - from;
    }
  }
}

}  // namespace gonogo::oracle::report
