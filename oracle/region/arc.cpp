// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/arc.hpp"

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {

Sweep make_sweep(const PlanePoint& a, const PlanePoint& b) {
  const int side = cross(a, b).sign();
  return {a, b, side < 0 || (side == 0 && dot(a, b).sign() > 0)};
}

bool contains(const Sweep& sweep, const PlanePoint& direction) {
  if (!sweep.wide) {
    return cross(sweep.a, direction).sign() >= 0 && cross(direction, sweep.b).sign() >= 0;
  }
  // Outside is the open turn from b to a, less than 180 degrees.
  return !(cross(sweep.b, direction).sign() > 0 && cross(direction, sweep.a).sign() > 0);
}

namespace {

void add_enclosures(Arc& arc) {
  const Rounding outward;
  const IntervalVector a = enclose(arc.sweep.a);
  const IntervalVector b = enclose(arc.sweep.b);
  arc.c = enclose(arc.centre);
  arc.ua = unit(a);
  arc.ub = unit(b);
  arc.ra = norm(a);
  arc.rb = arc.round ? arc.ra : norm(b);
}

}  // namespace

Arc make_arc(const LevelMotion& motion, const PlanePoint& middle) {
  Arc arc;
  arc.record = motion.record;
  arc.centre = motion.centre - middle;
  const PlanePoint from = motion.from - motion.centre;
  const PlanePoint to = motion.to - motion.centre;
  arc.sweep = motion.rot > 0 ? make_sweep(from, to) : make_sweep(to, from);
  arc.turns = whole_turns(motion.rot);
  arc.a2 = norm_squared(arc.sweep.a);
  arc.b2 = norm_squared(arc.sweep.b);
  arc.round = arc.a2 == arc.b2;
  arc.full = arc.round && (arc.turns > 0 || arc.sweep.a == arc.sweep.b);
  add_enclosures(arc);
  return arc;
}

std::optional<Arc> joined(const Arc& first, const Arc& second, bool counterclockwise) {
  if (!first.round || !second.round || first.a2 != second.a2 || !(first.centre == second.centre)) {
    return std::nullopt;
  }
  const Arc& early = counterclockwise ? first : second;
  const Arc& late = counterclockwise ? second : first;
  if (!(early.sweep.b == late.sweep.a)) return std::nullopt;
  Arc arc = first;
  // Together a whole turn when the late one comes by the start of the early one.
  arc.full = first.full || second.full || contains(late.sweep, early.sweep.a);
  arc.sweep = make_sweep(early.sweep.a, late.sweep.b);
  arc.capped_a = early.capped_a;
  arc.capped_b = late.capped_b;
  add_enclosures(arc);
  return arc;
}

Stretch whole(const Arc& arc) {
  return {arc.ua, arc.ub, arc.ra, arc.rb, arc.turns, arc.sweep.wide};
}

IntervalVector middle_direction(const IntervalVector& ua, const IntervalVector& ub, bool wide) {
  // With m in the middle of a sweep f: ub - ua = 2 sin(f/2) (m turned left), ua + ub = 2 cos(f/2)
  // m. The first serves while f is far from 0 and 360 degrees, the second while it is far from 180.
  if (median(scalar_product(ua, ub)) <= 0) {
    return unit((ub - ua).perpendicular(CGAL::CLOCKWISE));
  }
  const IntervalVector sum = unit(ua + ub);
  return wide ? -sum : sum;
}

bool Stretch::is_tiny() const {
  return turns == 0 && !wide && norm(b() - a()).sup() < kBeside;
}

std::array<Stretch, 2> halves(const Stretch& stretch) {
  IntervalVector m = middle_direction(stretch.ua, stretch.ub, stretch.wide);
  const bool odd = stretch.turns % 2 != 0;
  if (odd) m = -m;  // half of an odd number of turns: 180 degrees on
  const Interval radius = (stretch.ra + stretch.rb) * 0.5;
  const int turns = stretch.turns / 2;
  return {Stretch{stretch.ua, m, stretch.ra, radius, turns, odd},
          Stretch{m, stretch.ub, radius, stretch.rb, turns, odd}};
}

Interval projection(const IntervalVector& ua, const IntervalVector& ub, const IntervalVector& d) {
  const Interval at_a = scalar_product(ua, d);
  const Interval at_b = scalar_product(ub, d);
  const Interval ends = hull(at_a, at_b);
  const Interval left_of_a = determinant(ua, d);
  const Interval right_of_b = determinant(d, ub);
  // d itself, or its opposite, may lie in the sweep: the extreme is its length.
  const bool may_hold = !(left_of_a.sup() < 0 || right_of_b.sup() < 0);
  const bool opposite_may_hold = !(left_of_a.inf() > 0 || right_of_b.inf() > 0);
  if (!may_hold && !opposite_may_hold) return ends;
  const double length = norm(d).sup();
  return {opposite_may_hold ? std::min(ends.inf(), -length) : ends.inf(),
          may_hold ? std::max(ends.sup(), length) : ends.sup()};
}

// |c + r u - o|^2 = r^2 + |d|^2 + 2 r <u, d>, constant when d = 0, so that concentric circles need
// no halving.
Interval squared_distance(const CirclePiece& piece, const IntervalVector& d) {
  const Interval along = projection(piece.ua, piece.ub, d);
  return square(piece.r) + d.squared_length() + 2.0 * piece.r * along;
}

IntervalVector box_of(const CirclePiece& piece) {
  const auto along = [&piece](const IntervalVector& axis) {
    return piece.r * projection(piece.ua, piece.ub, axis);
  };
  return piece.c + IntervalVector(along({1, 0}), along({0, 1}));
}

}  // namespace gonogo::oracle::region
