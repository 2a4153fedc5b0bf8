// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {
namespace {

// With d = c - o: |c + r u - o|^2 = r^2 + |d|^2 + 2 r <u, d>, constant when d = 0, so that
// concentric circles need no halving.
Interval squared_distance(const CirclePiece& piece, const IntervalVector& d) {
  const Interval along = projection(piece.ua, piece.ub, d);
  return square(piece.r) + norm_squared(d) + Interval{2, 2} * piece.r * along;
}

}  // namespace

bool lies_outside(const CirclePiece& piece, Interval radius2) {
  return squared_distance(piece, piece.c).lo >= radius2.hi;
}

bool lies_within_sweep(const CirclePiece& piece, const Band& band) {
  if (band.shape != Band::Shape::sector) return true;
  const IntervalVector d = piece.c - band.c;
  const IntervalVector& a = band.ua;
  const IntervalVector& b = band.ub;
  const auto side = [&piece](const IntervalVector& normal) {
    return piece.r * projection(piece.ua, piece.ub, normal);
  };
  const bool left_of_a = (cross(a, d) + side({-a.y, a.x})).lo > 0;
  // Wide: on the inner side of one of the edges; else of both.
  if (left_of_a == band.wide) return left_of_a;
  return (cross(d, b) + side({b.y, -b.x})).lo > 0;
}

bool lies_inside(const CirclePiece& piece, const Band& band) {
  const Interval d2 = squared_distance(piece, piece.c - band.c);
  if (!(d2.hi < band.outer2.lo)) return false;
  if (band.has_hole() && !(d2.lo > band.inner2.hi)) return false;
  return lies_within_sweep(piece, band);
}

}  // namespace gonogo::oracle::region
