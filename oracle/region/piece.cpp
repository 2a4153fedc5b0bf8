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

// From the origin.
Interval squared_distance(const LinePiece& piece) {
  const IntervalVector d = piece.b - piece.a;
  const Interval length = norm(d);
  return squared_distance(piece.a, piece.b, {d.x / length, d.y / length}, length, exactly(0, 0));
}

// Whether all that lies in the box, and so far from each corner of the core as `from_corner` says,
// is outside. For the corner o in the quadrant x, y >= 0 and any point of the plane,
//   dist(core)^2 >= |point - o|^2 - max(0, o.x - x)^2 - max(0, o.y - y)^2,
// and where the core has no extent along an axis, without the term of that axis.
template <class FromCorner>
bool lies_outside(const IntervalVector& box, const EnclosedRectangle& shape,
                  const FromCorner& from_corner) {
  if (absolute(box.x).lo >= (shape.core_p + shape.radius).hi) return true;
  if (absolute(box.y).lo >= (shape.core_q + shape.radius).hi) return true;
  const bool right = box.x.middle() >= 0;
  const bool upper = box.y.middle() >= 0;
  const auto short_of = [](Interval half, Interval coordinate, bool positive) {
    if (half.hi == 0) return 0.0;
    return std::max(0.0, (half - (positive ? coordinate : -coordinate)).hi);
  };
  const double ex = short_of(shape.core_p, box.x, right);
  const double ey = short_of(shape.core_q, box.y, upper);
  const IntervalVector corner{right ? shape.core_p : -shape.core_p,
                              upper ? shape.core_q : -shape.core_q};
  const Interval lacking = square(Interval{ex, ex}) + square(Interval{ey, ey});
  return (from_corner(corner) - lacking).lo >= shape.radius2.hi;
}

// Every point of the piece lies at most so far from the chord between its ends.
double sagitta(const CirclePiece& piece) {
  const Interval chord2 = norm_squared(piece.ub - piece.ua);
  const Interval quarter{0.25, 0.25};
  // 1 - sqrt(1 - s^2) = s^2 / (1 + sqrt(1 - s^2)), s being half the chord of the unit circle.
  const Interval s2 = chord2 * quarter;
  const Interval one{1, 1};
  return (piece.r * s2 / (one + square_root(one - s2))).hi;
}

// Upper bound of how far the point lies from the middle of a convex band, squared: its line, its
// core, its centre.
double squared_distance(const Band& band, const IntervalVector& point) {
  switch (band.shape) {
    case Band::Shape::capsule:
      return squared_distance(band.c, band.to, band.ua, band.length, point).hi;
    case Band::Shape::rectangle:
      return squared_distance_to_core(band.rectangle(), point).hi;
    default:
      return norm_squared(point - band.c).hi;
  }
}

bool is_convex(const Band& band) {
  return band.shape == Band::Shape::capsule || band.shape == Band::Shape::rectangle;
}

bool lies_in_disc(const CirclePiece& piece, const IntervalVector& centre, Interval radius2) {
  return squared_distance(piece, piece.c - centre).hi < radius2.lo;
}

// Beside the line of a capsule, not beyond its ends.
bool lies_beside(const CirclePiece& piece, const Band& band) {
  const IntervalVector& u = band.ua;
  const IntervalVector d = piece.c - band.c;
  const Interval aside = cross(u, d) + piece.r * projection(piece.ua, piece.ub, {-u.y, u.x});
  if (!(absolute(aside).hi < band.outer.lo)) return false;
  const Interval along = dot(u, d) + piece.r * projection(piece.ua, piece.ub, u);
  return along.lo > 0 && along.hi < band.length.lo;
}

bool lies_in_convex(const CirclePiece& piece, const Band& band) {
  const double at_a = squared_distance(band, piece.c + piece.r * piece.ua);
  const double at_b = squared_distance(band, piece.c + piece.r * piece.ub);
  const double worst = std::max(at_a, at_b);
  if (!(worst < band.outer2.lo)) return false;
  const double sag = sagitta(piece);
  const Interval reach = square_root({0, worst}) + Interval{sag, sag};
  if (reach.hi < band.outer.lo) return true;
  if (band.shape != Band::Shape::capsule) return false;
  return lies_in_disc(piece, band.c, band.outer2) || lies_in_disc(piece, band.to, band.outer2) ||
         lies_beside(piece, band);
}

}  // namespace

bool lies_outside(const CirclePiece& piece, Interval radius2) {
  return squared_distance(piece, piece.c).lo >= radius2.hi;
}

bool lies_outside(const CirclePiece& piece, const EnclosedRectangle& shape) {
  if (shape.is_disc()) return lies_outside(piece, shape.radius2);
  const IntervalVector box{piece.c.x + piece.r * projection(piece.ua, piece.ub, exactly(1, 0)),
                           piece.c.y + piece.r * projection(piece.ua, piece.ub, exactly(0, 1))};
  return lies_outside(box, shape, [&piece](const IntervalVector& corner) {
    return squared_distance(piece, piece.c - corner);
  });
}

bool lies_outside(const LinePiece& piece, const EnclosedRectangle& shape) {
  const IntervalVector box{hull(piece.a.x, piece.b.x), hull(piece.a.y, piece.b.y)};
  return lies_outside(box, shape, [&piece](const IntervalVector& corner) {
    return squared_distance({piece.a - corner, piece.b - corner});
  });
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
  if (is_convex(band)) return lies_in_convex(piece, band);
  const Interval d2 = squared_distance(piece, piece.c - band.c);
  if (!(d2.hi < band.outer2.lo)) return false;
  if (band.has_hole() && !(d2.lo > band.inner2.hi)) return false;
  return lies_within_sweep(piece, band);
}

bool lies_inside(const LinePiece& piece, const Band& band) {
  if (!(squared_distance(band, piece.a) < band.outer2.lo)) return false;
  if (!(squared_distance(band, piece.b) < band.outer2.lo)) return false;
  if (is_convex(band)) return true;
  const LinePiece seen{piece.a - band.c, piece.b - band.c};
  if (band.has_hole() && !(squared_distance(seen).lo > band.inner2.hi)) return false;
  if (band.shape != Band::Shape::sector) return true;
  const bool left_of_a = cross(band.ua, seen.a).lo > 0 && cross(band.ua, seen.b).lo > 0;
  if (left_of_a == band.wide) return left_of_a;
  return cross(seen.a, band.ub).lo > 0 && cross(seen.b, band.ub).lo > 0;
}

}  // namespace gonogo::oracle::region
