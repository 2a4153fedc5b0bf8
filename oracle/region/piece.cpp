// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {
namespace {

// From the origin.
Interval squared_distance(const LinePiece& piece) {
  const IntervalVector d = piece.b - piece.a;
  const Interval length = norm(d);
  return region::squared_distance(piece.a, piece.b, d / length, length, IntervalVector(0, 0));
}

// Whether all that lies in the box, and so far from each corner of the core as `from_corner` says,
// is outside. For the corner o in the quadrant x, y >= 0 and any point of the plane,
//   dist(core)^2 >= |point - o|^2 - max(0, o.x - x)^2 - max(0, o.y - y)^2,
// and where the core has no extent along an axis, without the term of that axis.
template <class FromCorner>
bool lies_outside(const IntervalVector& box, const EnclosedRectangle& shape,
                  const FromCorner& from_corner) {
  if (abs(box.x()).inf() >= (shape.core_p + shape.radius).sup()) return true;
  if (abs(box.y()).inf() >= (shape.core_q + shape.radius).sup()) return true;
  const bool right = median(box.x()) >= 0;
  const bool upper = median(box.y()) >= 0;
  const auto short_of = [](Interval half, Interval coordinate, bool positive) {
    if (half.sup() == 0) return 0.0;
    return std::max(0.0, (half - (positive ? coordinate : -coordinate)).sup());
  };
  const double ex = short_of(shape.core_p, box.x(), right);
  const double ey = short_of(shape.core_q, box.y(), upper);
  const IntervalVector corner{right ? shape.core_p : -shape.core_p,
                              upper ? shape.core_q : -shape.core_q};
  const Interval lacking = square(Interval(ex, ex)) + square(Interval(ey, ey));
  return (from_corner(corner) - lacking).inf() >= shape.radius2.sup();
}

// Every point of the piece lies at most so far from the chord between its ends.
double sagitta(const CirclePiece& piece) {
  const Interval chord2 = (piece.ub - piece.ua).squared_length();
  // 1 - sqrt(1 - s^2) = s^2 / (1 + sqrt(1 - s^2)), s being half the chord of the unit circle.
  const Interval s2 = chord2 * 0.25;
  return (piece.r * s2 / (1.0 + square_root(Interval(1) - s2))).sup();
}

// Upper bound of how far the point lies from the middle of a convex band, squared: its line, its
// core, its centre.
double squared_distance(const Band& band, const IntervalVector& point) {
  switch (band.shape) {
    case Band::Shape::capsule:
      return region::squared_distance(band.c, band.to, band.ua, band.length, point).sup();
    case Band::Shape::rectangle:
      return squared_distance_to_core(band.rectangle(), point).sup();
    default:
      return (point - band.c).squared_length().sup();
  }
}

bool is_convex(const Band& band) {
  return band.shape == Band::Shape::capsule || band.shape == Band::Shape::rectangle;
}

bool lies_in_disc(const CirclePiece& piece, const IntervalVector& centre, Interval radius2) {
  return squared_distance(piece, piece.c - centre).sup() < radius2.inf();
}

// Beside the line of a capsule, not beyond its ends.
bool lies_beside(const CirclePiece& piece, const Band& band) {
  const IntervalVector& u = band.ua;
  const IntervalVector d = piece.c - band.c;
  const Interval aside =
      determinant(u, d) +
      piece.r * projection(piece.ua, piece.ub, u.perpendicular(CGAL::COUNTERCLOCKWISE));
  if (!(abs(aside).sup() < band.outer.inf())) return false;
  const Interval along = scalar_product(u, d) + piece.r * projection(piece.ua, piece.ub, u);
  return along.inf() > 0 && along.sup() < band.length.inf();
}

bool lies_in_convex(const CirclePiece& piece, const Band& band) {
  const double at_a = squared_distance(band, piece.c + piece.r * piece.ua);
  const double at_b = squared_distance(band, piece.c + piece.r * piece.ub);
  const double worst = std::max(at_a, at_b);
  if (!(worst < band.outer2.inf())) return false;
  const double sag = sagitta(piece);
  const Interval reach = square_root(Interval(0, worst)) + Interval(sag, sag);
  if (reach.sup() < band.outer.inf()) return true;
  if (band.shape != Band::Shape::capsule) return false;
  return lies_in_disc(piece, band.c, band.outer2) || lies_in_disc(piece, band.to, band.outer2) ||
         lies_beside(piece, band);
}

}  // namespace

bool lies_outside(const CirclePiece& piece, Interval radius2) {
  return squared_distance(piece, piece.c).inf() >= radius2.sup();
}

bool lies_outside(const CirclePiece& piece, const EnclosedRectangle& shape) {
  if (shape.is_disc()) return lies_outside(piece, shape.radius2);
  return lies_outside(box_of(piece), shape, [&piece](const IntervalVector& corner) {
    return squared_distance(piece, piece.c - corner);
  });
}

bool lies_outside(const LinePiece& piece, const EnclosedRectangle& shape) {
  const IntervalVector box{hull(piece.a.x(), piece.b.x()), hull(piece.a.y(), piece.b.y())};
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
  const bool left_of_a =
      (determinant(a, d) + side(a.perpendicular(CGAL::COUNTERCLOCKWISE))).inf() > 0;
  // Wide: on the inner side of 1.0 of the edges; else of both.
  if (left_of_a == band.wide) return left_of_a;
  return (determinant(d, b) + side(b.perpendicular(CGAL::CLOCKWISE))).inf() > 0;
}

bool lies_inside(const CirclePiece& piece, const Band& band) {
  if (is_convex(band)) return lies_in_convex(piece, band);
  const Interval d2 = squared_distance(piece, piece.c - band.c);
  if (!(d2.sup() < band.outer2.inf())) return false;
  if (band.has_hole() && !(d2.inf() > band.inner2.sup())) return false;
  return lies_within_sweep(piece, band);
}

bool lies_inside(const LinePiece& piece, const Band& band) {
  if (!(squared_distance(band, piece.a) < band.outer2.inf())) return false;
  if (!(squared_distance(band, piece.b) < band.outer2.inf())) return false;
  if (is_convex(band)) return true;
  const LinePiece seen{piece.a - band.c, piece.b - band.c};
  if (band.has_hole() && !(squared_distance(seen).inf() > band.inner2.sup())) return false;
  if (band.shape != Band::Shape::sector) return true;
  const bool left_of_a =
      determinant(band.ua, seen.a).inf() > 0 && determinant(band.ua, seen.b).inf() > 0;
  if (left_of_a == band.wide) return left_of_a;
  return determinant(seen.a, band.ub).inf() > 0 && determinant(seen.b, band.ub).inf() > 0;
}

}  // namespace gonogo::oracle::region
