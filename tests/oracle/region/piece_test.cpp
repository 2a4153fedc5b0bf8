// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filter holds certain about a piece of a circle, against points on the piece.
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

double between(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

struct Turn {
  double start;
  double size;

  IntervalVector at(double part) const {
    const double angle = start + size * part;
    return IntervalVector(std::cos(angle), std::sin(angle));
  }
  // Doubles: near the edges either answer may come.
  bool holds(double x, double y, double margin) const {
    double ahead = std::fmod(std::atan2(y, x) - start, kTurn);
    if (ahead < 0) ahead += kTurn;
    return ahead > margin && ahead < size - margin;
  }
};

struct Scene {
  CirclePiece piece;
  Turn sweep_of_piece;
  Band band;
  Turn sweep_of_band;
};

Scene scene() {
  Scene s;
  // Pieces from tiny to a quarter, bands of the same size as the circles, not far apart.
  const double size = *rc::gen::element(0.01, 0.2, kTurn / 4 - 1e-9);
  s.sweep_of_piece = {between(0, kTurn), size};
  s.piece.c = IntervalVector(between(-2, 2), between(-2, 2));
  const double r = between(0.1, 5);
  s.piece.r = r;
  s.piece.ua = s.sweep_of_piece.at(0);
  s.piece.ub = s.sweep_of_piece.at(1);
  s.band.shape = *rc::gen::element(Band::Shape::disc, Band::Shape::ring, Band::Shape::sector);
  s.band.c =
      *rc::gen::arbitrary<bool>() ? s.piece.c : IntervalVector(between(-1, 1), between(-1, 1));
  const double outer = between(0.2, 7);
  const double inner = s.band.shape == Band::Shape::disc ? 0 : between(-1, outer);
  s.band.outer = outer;
  s.band.inner = inner;
  s.band.square_radii();
  s.sweep_of_band = {between(0, kTurn), between(0.01, kTurn - 0.01)};
  s.band.wide = s.sweep_of_band.size > kTurn / 2;
  s.band.ua = s.sweep_of_band.at(0);
  s.band.ub = s.sweep_of_band.at(1);
  return s;
}

// By how much the point lies inside the band: `margin` and more (1), or outside (-1), or neither.
int place(const Scene& s, double x, double y) {
  constexpr double kMargin = 1e-9;
  const double dx = x - s.band.c.x().inf();
  const double dy = y - s.band.c.y().inf();
  const double d = std::hypot(dx, dy);
  const bool sector = s.band.shape == Band::Shape::sector;
  const bool in = !sector || s.sweep_of_band.holds(dx, dy, kMargin);
  const bool nearly_in = !sector || d < kMargin || s.sweep_of_band.holds(dx, dy, -kMargin);
  if (in && d < s.band.outer.inf() - kMargin && d > s.band.inner.inf() + kMargin) return 1;
  return nearly_in && d < s.band.outer.inf() + kMargin && d > s.band.inner.inf() - kMargin ? 0 : -1;
}

constexpr int kSamples = 200;

template <class Visit>
void sample(const Scene& s, const Visit& visit) {
  for (int k = 0; k <= kSamples; ++k) {
    const IntervalVector u = s.sweep_of_piece.at(static_cast<double>(k) / kSamples);
    visit(s.piece.c.x().inf() + s.piece.r.inf() * u.x().inf(),
          s.piece.c.y().inf() + s.piece.r.inf() * u.y().inf());
  }
}

RC_GTEST_PROP(RegionPiece, APieceCalledInsideHasNoPointOutside, ()) {
  const Rounding outward;
  int claims = 0;
  for (int n = 0; n < 200; ++n) {
    const Scene s = scene();
    if (!lies_inside(s.piece, s.band)) continue;
    ++claims;
    sample(s, [&s](double x, double y) { RC_ASSERT(place(s, x, y) >= 0); });
  }
  RC_ASSERT(claims > 0);
}

// A sweep above 180 degrees is tested edge by edge, so a piece across the middle may need halving.
RC_GTEST_PROP(RegionPiece, APieceWellInsideIsCalledInside, ()) {
  const Rounding outward;
  for (int n = 0; n < 50; ++n) {
    const Scene s = scene();
    if (s.band.shape == Band::Shape::sector && s.band.wide) continue;
    int least = 1;
    sample(s, [&](double x, double y) { least = std::min(least, place(s, x, y)); });
    // Between two samples a piece of radius 5 sags by less than 1e-4.
    Scene smaller = s;
    smaller.band.outer = smaller.band.outer - 1e-4;
    smaller.band.inner = smaller.band.inner + 1e-4;
    sample(smaller, [&](double x, double y) { least = std::min(least, place(smaller, x, y)); });
    if (least == 1) RC_ASSERT(lies_inside(s.piece, s.band));
  }
}

RC_GTEST_PROP(RegionPiece, APieceCalledOutsideADiscHasNoPointInIt, ()) {
  const Rounding outward;
  int claims = 0;
  for (int n = 0; n < 50; ++n) {
    const Scene s = scene();
    const double radius = s.band.outer.inf();
    if (!lies_outside(s.piece, square(s.band.outer))) continue;
    ++claims;
    sample(s, [radius](double x, double y) { RC_ASSERT(std::hypot(x, y) > radius - 1e-9); });
  }
  RC_ASSERT(claims > 0);
}

TEST(RegionPieces, TheOtherHalfOfASectorIsNotInside) {
  const Rounding outward;
  Scene s;
  s.band.shape = Band::Shape::sector;
  s.band.outer = 3;
  s.band.inner = 1;
  s.band.square_radii();
  s.band.ua = IntervalVector(1, 0);
  s.band.ub = IntervalVector(0, 1);
  s.piece = {IntervalVector(0, 0), 2, IntervalVector(0.8, 0.6), IntervalVector(0.6, 0.8)};
  EXPECT_TRUE(lies_inside(s.piece, s.band));
  s.piece.ub = IntervalVector(-0.28, 0.96);
  EXPECT_FALSE(lies_inside(s.piece, s.band));
}

}  // namespace
}  // namespace gonogo::oracle::region
