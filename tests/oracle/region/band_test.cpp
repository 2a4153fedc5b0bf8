// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bands of a spiral lie within reach of it, and not much closer than they must.
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/region/band.hpp"
#include "tests/oracle/region/paths.hpp"

namespace gonogo::oracle::region {
namespace {

// Radius linear in the angle, about the origin, counterclockwise.
struct PlainSpiral {
  double r0, r1, start, turn;

  double distance(double x, double y) const {
    const auto at = [&](double part) {
      const double r = r0 + (r1 - r0) * part;
      return std::hypot(x - r * std::cos(start + turn * part),
                        y - r * std::sin(start + turn * part));
    };
    const int count = static_cast<int>(turn * 400);
    double best = 0;
    double least = at(0);
    for (int k = 1; k <= count; ++k) {
      const double part = static_cast<double>(k) / count;
      if (at(part) < least) {
        least = at(part);
        best = part;
      }
    }
    // Ternary search about the best sample.
    double low = std::max(0.0, best - 1.0 / count);
    double high = std::min(1.0, best + 1.0 / count);
    for (int k = 0; k < 60; ++k) {
      const double a = low + (high - low) / 3;
      const double b = high - (high - low) / 3;
      (at(a) < at(b) ? high : low) = at(a) < at(b) ? b : a;
    }
    return std::min(least, at((low + high) / 2));
  }
};

Number thousandths(int count) {
  return Number::millionths(std::int64_t{1000} * count);
}

RC_GTEST_PROP(RegionBands, TheBorderOfASpiralsBandsIsWithinReach, ()) {
  const Rounding outward;
  const int r0 = *rc::gen::inRange(100, 4'000);
  const int r1 = *rc::gen::inRange(100, 4'000);
  const int turns = *rc::gen::inRange(1, 4);
  RC_PRE(r0 != r1);
  LevelMotion motion;
  motion.is_arc = true;
  motion.rot = turns;
  motion.from = {thousandths(r0), 0};
  motion.to = {Number(), thousandths(r1)};  // a quarter more
  const Path path{{make_arc(motion, {})}, {}};
  constexpr double kWidth = 1e-3;
  const auto bands = make_bands(path, 1, kWidth);
  const PlainSpiral spiral{r0 / 1e3, r1 / 1e3, 0, (turns - 0.75) * 2 * std::numbers::pi};
  double deepest = 1;
  for (int n = 0; n < 60; ++n) {
    const Band& band = bands->bands[*rc::gen::inRange<std::size_t>(0, bands->bands.size())];
    if (band.shape != Band::Shape::sector || band.wide) continue;
    // A direction between the two ends, on the outer border and on the hole's.
    const double part = *rc::gen::inRange(0, 1'001) / 1e3;
    const double ux = (1 - part) * median(band.ua.x()) + part * median(band.ub.x());
    const double uy = (1 - part) * median(band.ua.y()) + part * median(band.ub.y());
    for (const double radius : {median(band.outer), std::max(0.0, median(band.inner))}) {
      const double scale = radius / std::hypot(ux, uy);
      const double away =
          spiral.distance(median(band.c.x()) + scale * ux, median(band.c.y()) + scale * uy);
      RC_ASSERT(away < 1 + 1e-9);
      if (radius == median(band.outer) && r1 > r0) deepest = std::min(deepest, away);
    }
  }
  // A quarter turn outward has nothing beside it that comes nearer than the width says; near its
  // centre a spiral runs outward and the bands along the rays give away more.
  if (turns == 1 && r0 > 1'500) RC_ASSERT(deepest > 1 - 3 * kWidth);
}

}  // namespace
}  // namespace gonogo::oracle::region
