// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the filter holds certain about pieces of circles and lines beside capsules and rounded
// rectangles, against points on the pieces.
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {
namespace {

// All of the range from the first case on.
double between(double low, double high) {
  return low +
         (high - low) * *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 1'000'001)) / 1e6;
}

struct Point {
  double x, y;
};

constexpr int kSamples = 200;
constexpr double kMargin = 1e-9;

// A piece, and the points on it by their place from 0 to 1.
template <class Piece>
struct Curve {
  Piece piece;
  std::function<Point(double)> at;

  bool all(const std::function<bool(Point)>& holds) const {
    for (int k = 0; k <= kSamples; ++k) {
      if (!holds(at(static_cast<double>(k) / kSamples))) return false;
    }
    return true;
  }
};

Curve<LinePiece> line_piece() {
  const Point a{between(-6, 6), between(-6, 6)};
  const double size = *rc::gen::element(0.01, 1.0, 4.0);
  const Point b{a.x + between(-size, size), a.y + between(-size, size)};
  return {{IntervalVector(a.x, a.y), IntervalVector(b.x, b.y)}, [a, b](double part) {
            return Point{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)};
          }};
}

Curve<CirclePiece> circle_piece() {
  const double start = between(0, 2 * std::numbers::pi);
  const double size = *rc::gen::element(0.01, 0.3, std::numbers::pi / 2 - 1e-9);
  const Point c{between(-5, 5), between(-5, 5)};
  const double r = between(0.1, 4);
  const auto unit_at = [start, size](double part) {
    return Point{std::cos(start + size * part), std::sin(start + size * part)};
  };
  const Point a = unit_at(0);
  const Point b = unit_at(1);
  return {{IntervalVector(c.x, c.y), r, IntervalVector(a.x, a.y), IntervalVector(b.x, b.y)},
          [c, r, unit_at](double part) {
            const Point u = unit_at(part);
            return Point{c.x + r * u.x, c.y + r * u.y};
          }};
}

Number number(double value) {
  return Number::millionths(static_cast<std::int64_t>(std::round(value * 1e6)));
}

// A rounded rectangle, at times a slot or a disc, and how far a point is from its border: negative
// inside, as far as the nearest place of the border is off the core.
struct Shape {
  Cleared shape;
  double p, q, r;

  double outside(Point point) const {
    return std::hypot(std::max(0.0, std::fabs(point.x) - p),
                      std::max(0.0, std::fabs(point.y) - q)) -
           r;
  }
  Band band() const {
    Bands bands;
    add_cleared(bands, shape);
    return bands.bands.front();
  }
};

Shape shape() {
  Shape result;
  result.p = *rc::gen::arbitrary<bool>() ? std::round(between(0, 4)) : 0;
  result.q = *rc::gen::arbitrary<bool>() ? std::round(between(0, 3)) : 0;
  result.r = std::round(between(1, 8)) / 4;
  result.shape.exact = {number(result.p), number(result.q), number(result.r)};
  result.shape.enclosed = enclose(result.shape.exact);
  return result;
}

struct Capsule {
  Path path;
  Bands bands;
  Point a, b;
  double r;

  const Band& band() const { return bands.bands.back(); }
  double outside(Point point) const {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double part =
        std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    return std::hypot(point.x - a.x - part * dx, point.y - a.y - part * dy) - r;
  }
};

Capsule capsule() {
  Capsule result;
  result.a = {std::round(between(-4, 4)), std::round(between(-4, 4))};
  result.b = {result.a.x + std::round(between(1, 5)), std::round(between(-4, 4))};
  result.r = std::round(between(1, 12)) / 4;
  result.path.lines.push_back(make_line({number(result.a.x), number(result.a.y)},
                                        {number(result.b.x), number(result.b.y)}));
  result.bands = *make_bands(result.path, number(result.r), 1e-3);
  return result;
}

template <class Piece>
void check_inside(const Curve<Piece>& curve, const Band& band,
                  const std::function<double(Point)>& outside, int& claims) {
  if (lies_inside(curve.piece, band)) {
    ++claims;
    RC_ASSERT(curve.all([&](Point point) { return outside(point) < kMargin; }));
  } else if (std::is_same_v<Piece, LinePiece>) {
    // Convex bands: nothing else keeps a line from being inside than a point that is not.
    RC_ASSERT(!curve.all([&](Point point) { return outside(point) < -kMargin; }));
  }
}

RC_GTEST_PROP(RegionLinePiece, APieceCalledInsideACapsuleIsInside, ()) {
  const Rounding outward;
  int claims = 0;
  for (int n = 0; n < 100; ++n) {
    const Capsule c = capsule();
    const auto outside = [&c](Point point) { return c.outside(point); };
    check_inside(line_piece(), c.band(), outside, claims);
    check_inside(circle_piece(), c.band(), outside, claims);
  }
  RC_ASSERT(claims > 0);
}

RC_GTEST_PROP(RegionLinePiece, APieceCalledInsideARoundedRectangleIsInside, ()) {
  const Rounding outward;
  int claims = 0;
  for (int n = 0; n < 100; ++n) {
    const Shape s = shape();
    const auto outside = [&s](Point point) { return s.outside(point); };
    check_inside(line_piece(), s.band(), outside, claims);
    check_inside(circle_piece(), s.band(), outside, claims);
  }
  RC_ASSERT(claims > 0);
}

template <class Piece>
void check_outside(const Curve<Piece>& curve, const Shape& s, int& claims) {
  if (lies_outside(curve.piece, s.shape.enclosed)) {
    ++claims;
    RC_ASSERT(curve.all([&s](Point point) { return s.outside(point) > -kMargin; }));
  }
}

RC_GTEST_PROP(RegionLinePiece, APieceCalledOutsideHasNoPointInside, ()) {
  const Rounding outward;
  int claims = 0;
  for (int n = 0; n < 100; ++n) {
    const Shape s = shape();
    check_outside(line_piece(), s, claims);
    check_outside(circle_piece(), s, claims);
  }
  RC_ASSERT(claims > 0);
}

// A short piece a hundredth away from the border is called what it is: halving comes to an end.
RC_GTEST_PROP(RegionLinePiece, AShortPieceClearOfTheBorderIsDecided, ()) {
  const Rounding outward;
  for (int n = 0; n < 100; ++n) {
    const Shape s = shape();
    const Capsule c = capsule();
    Curve<LinePiece> line = line_piece();
    const Point a = line.at(0);
    line.piece.b = IntervalVector(a.x + 1e-4, a.y - 1e-4);
    if (s.outside(a) > 0.01) RC_ASSERT(lies_outside(line.piece, s.shape.enclosed));
    if (s.outside(a) < -0.01) RC_ASSERT(lies_inside(line.piece, s.band()));
    if (c.outside(a) < -0.01) RC_ASSERT(lies_inside(line.piece, c.band()));
  }
}

// A sector: a line through the wedge is inside, one through the hole is not.
TEST(RegionLinePieces, ALineInASectorKeepsClearOfTheHole) {
  const Rounding outward;
  Band band;
  band.shape = Band::Shape::sector;
  band.c = IntervalVector(0, 0);
  band.inner = 1;
  band.outer = 3;
  band.square_radii();
  band.ua = IntervalVector(1, 0);
  band.ub = IntervalVector(0, 1);
  EXPECT_TRUE(lies_inside(LinePiece{IntervalVector(2, 0.1), IntervalVector(0.1, 2)}, band));
  EXPECT_FALSE(lies_inside(LinePiece{IntervalVector(1.2, 0.1), IntervalVector(0.1, 1.2)}, band));
  EXPECT_FALSE(lies_inside(LinePiece{IntervalVector(2, 0.1), IntervalVector(2, -0.1)}, band));
  EXPECT_FALSE(lies_inside(LinePiece{IntervalVector(2, 0.1), IntervalVector(2.5, 2)}, band));
  band.wide = true;
  band.ua = IntervalVector(0, 1);
  band.ub = IntervalVector(1, 0);
  EXPECT_TRUE(lies_inside(LinePiece{IntervalVector(-2, 0.5), IntervalVector(-0.5, -2)}, band));
  EXPECT_FALSE(lies_inside(LinePiece{IntervalVector(2, 0.1), IntervalVector(0.1, 2)}, band));
}

}  // namespace
}  // namespace gonogo::oracle::region
