// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/region/border.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/region/shapes.hpp"

namespace gonogo::oracle::region {
namespace {

Coverage undecided(GapReason reason, std::string why) {
  Coverage result;
  result.kind = Coverage::Kind::undecided;
  result.by_filter = false;
  result.why = std::move(why);
  result.reason = reason;
  return result;
}

class Decision {
 public:
  Decision(const Path& path, const Target& target, const Bands& bands)
      : path_(path),
        target_(target),
        bands_(bands.bands),
        area_(enclose(target.area)),
        reach_(median(enclose(target.reach))),
        grid_(bands_, half_side(), reach_) {}

  Coverage by_filter();
  Coverage by_circle_sets();

 private:
  double half_side() const {
    return std::max(area_.core_p.sup(), area_.core_q.sup()) + area_.radius.sup();
  }
  bool is_asked_for(const PlanePoint& point) const {
    if (!contains(target_.area, point)) return false;
    return !target_.cleared || !contains(*target_.cleared, point);
  }
  double clearance(double x, double y) const;
  std::array<double, 2> climb(double x, double y) const;
  std::optional<Coverage> refute(double x, double y) const;
  Coverage settle(const std::vector<Spot>& open);
  Coverage settle(const std::vector<std::uint32_t>& near, const std::optional<Window>& window);

  const Path& path_;
  const Target& target_;
  std::span<const Band> bands_;
  EnclosedRectangle area_;
  double reach_;
  Grid grid_;
};

// About how far the point is from the nearest band near it; negative: covered, or outside the area.
double Decision::clearance(double x, double y) const {
  if (rough_distance(area_, x, y) > 0) return -1;
  double least = 2 * reach_;
  for (const std::uint32_t band : grid_.near(x, y)) {
    least = std::min(least, rough_distance(bands_[band], x, y));
  }
  return least;
}

// To a place about as deep in the hole as there is nearby: the finding that says most.
std::array<double, 2> Decision::climb(double x, double y) const {
  double best = clearance(x, y);
  std::size_t moves = 0;
  for (double stride = reach_; stride > kBeside && moves < kMostSpots; stride /= 2) {
    for (bool better = true; better && moves < kMostSpots;) {
      better = false;
      for (int k = 0; k < 9; ++k) {
        const int column = k / 3 - 1;
        const int row = k % 3 - 1;
        const double nx = x + stride * column;
        const double ny = y + stride * row;
        const double there = clearance(nx, ny);
        if (there <= best) continue;
        best = there;
        x = nx;
        y = ny;
        better = true;
        ++moves;
      }
    }
  }
  return {x, y};
}

// A witness near the spot, as short as it can be written, proved exactly.
std::optional<Coverage> Decision::refute(double x, double y) const {
  const auto [px, py] = climb(x, y);
  const double depth = clearance(px, py);
  for (const double step : {1e3, 1e6, 0.0}) {
    if (step > 0 && depth * step < 2) continue;
    const auto rounded = [step](double value) {
      if (step == 0) return to_number(value);
      const auto count = static_cast<std::int64_t>(std::round(value * step));
      return Number(count) / Number(static_cast<std::int64_t>(step));
    };
    const PlanePoint point{rounded(px), rounded(py)};
    if (!is_asked_for(point)) continue;
    if (const auto far = excess(path_, point, target_.reach + target_.margin)) {
      Coverage result;
      result.kind = Coverage::Kind::uncovered;
      result.witness = point;
      result.excess = *far;
      return result;
    }
  }
  return std::nullopt;
}

Coverage Decision::by_filter() {
  BorderFilter filter(bands_, grid_, target_);
  std::size_t attempts = 0;
  while (attempts < kMostTries && filter.find_hole()) {
    ++attempts;
    if (auto hole = refute(filter.hole().x, filter.hole().y)) return *hole;
  }
  if (attempts == kMostTries)
    return undecided(GapReason::comparison, "No place that seems uncovered proves to be.");
  if (filter.covered()) return {};
  // A path that nowhere comes near the area: its middle is as good a place as any.
  if (!filter.only_open_spots()) {
    if (auto hole = refute(0, 0)) return *hole;
    return undecided(GapReason::cap_area, "The budget of the certified subdivision ran out.");
  }
  return settle(filter.open());
}

// Exact decisions in small windows about the open spots.
Coverage Decision::settle(const std::vector<Spot>& open) {
  std::vector<Spot> done;
  for (const Spot& spot : open) {
    if (spot.size > kWindow)
      return undecided(GapReason::comparison, "A place seems uncovered but does not prove to be.");
    const auto inside = [&spot](const Spot& other) {
      return std::max(std::fabs(spot.x - other.x), std::fabs(spot.y - other.y)) < kWindow / 2;
    };
    if (std::any_of(done.begin(), done.end(), inside)) continue;
    const Window window{{to_number(spot.x), to_number(spot.y)}, to_number(2 * kWindow)};
    const Coverage local = settle(grid_.near_box(spot.x, spot.y, 2 * kWindow), window);
    if (local.kind != Coverage::Kind::covered) return local;
    done.push_back(spot);
  }
  Coverage result;
  result.by_filter = false;
  return result;
}

Coverage Decision::settle(const std::vector<std::uint32_t>& near,
                          const std::optional<Window>& window) {
  const RoundedRectangle& area = target_.area;
  if (!area.core_p.is_rational() || !area.core_q.is_rational() || !area.radius.is_rational()) {
    return undecided(GapReason::comparison, "The exact decision needs a rational area.");
  }
  std::vector<Shape> shapes;
  for (const std::uint32_t band : near) {
    if (!append_shapes(bands_[band], target_.reach, shapes)) {
      return undecided(GapReason::comparison, "The exact decision needs rational coordinates.");
    }
  }
  if (shapes.size() > kMostShapes)
    return undecided(GapReason::cap_area, "The exact decision would take too long.");
  Coverage result;
  result.by_filter = false;
  try {
    const Remainder remainder = uncovered_remainder(target_.area, window, shapes);
    if (remainder.empty) return result;
    for (const auto& [x, y] : remainder.samples) {
      if (auto hole = refute(x, y)) {
        hole->by_filter = false;
        return *hole;
      }
    }
  } catch (const CircleSetsError& error) {
    return undecided(GapReason::comparison, error.what());
  }
  return undecided(GapReason::comparison, "The uncovered part is too small to prove it.");
}

Coverage Decision::by_circle_sets() {
  std::vector<std::uint32_t> all(bands_.size());
  for (std::uint32_t band = 0; band < all.size(); ++band) all[band] = band;
  return settle(all, std::nullopt);
}

}  // namespace

Coverage check_coverage(const Path& path, const Target& target, const Number& tolerance,
                        Method method) {
  std::optional<Cleared> cleared;
  if (target.cleared) cleared = Cleared{*target.cleared, enclose(*target.cleared)};
  const bool spirals =
      std::any_of(path.arcs.begin(), path.arcs.end(), [](const Arc& arc) { return !arc.round; });
  Coverage result;
  double finest = enclose(target.reach).inf();
  for (const double cuts : kSpiralCuts) {
    // Where a spiral takes too many parts, wider ones still prove a hole, and most that is covered.
    double width = enclose(tolerance).inf() / cuts;
    auto bands = make_bands(path, target.reach, width);
    while (!bands && width * kWiderCut < finest) {
      width *= kWiderCut;
      bands = make_bands(path, target.reach, width);
    }
    if (!bands && result.kind == Coverage::Kind::undecided) return result;
    if (!bands)
      return undecided(GapReason::cap_area, "The spirals of the level have too many parts.");
    finest = width;
    if (cleared) add_cleared(*bands, *cleared);
    Decision decision(path, target, *bands);
    result = method == Method::filter_first ? decision.by_filter() : decision.by_circle_sets();
    if (!spirals || result.kind != Coverage::Kind::undecided) break;
  }
  return result;
}

}  // namespace gonogo::oracle::region
