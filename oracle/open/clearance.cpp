// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/clearance.hpp"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "oracle/motion/approximate.hpp"
#include "oracle/region/arc.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using exact::Number;
using region::Interval;
using region::norm;
using region::PlanePoint;

namespace {

Clearance touching_at(const PlanePoint& point, const Keep& keep) {
  const Number distance = exact::sqrt(norm_squared(point));
  return {Clearance::Kind::touches, point, abs(distance - keep.radius)};
}

// Clear where the point lies on the free side of the limit, or beyond it by no more than the slack;
// else the evidence.
Clearance clearance_of_point(const PlanePoint& point, const Keep& keep) {
  const Number d2 = norm_squared(point);
  const Number bound = keep.bound();
  const bool clear = keep.outside ? bound.sign() <= 0 || d2 >= bound * bound : d2 <= bound * bound;
  return clear ? Clearance{} : touching_at(point, keep);
}

const PlanePoint& farther(const PlanePoint& a, const PlanePoint& b) {
  return norm_squared(a) < norm_squared(b) ? b : a;
}

// The point of [from, to] nearest to zero.
Number nearest(const Number& from, const Number& to, const Number& zero) {
  if (from.sign() * to.sign() <= 0) return zero;
  return abs(from) < abs(to) ? from : to;
}

// The distance of a stretch from the origin.
Interval distance_of(const region::Arc& arc, const region::Stretch& stretch) {
  const region::CirclePiece piece = stretch.circles(arc.c);
  if (stretch.is_at_most_quarter()) {
    return region::square_root(region::squared_distance(piece, arc.c));
  }
  const Interval centre = norm(arc.c);
  return {abs(centre - piece.r).inf(), (centre + piece.r).sup()};
}

// +1 on the free side, -1 beyond the limit, 0 neither for sure.
int side(const Interval& distance, const Interval& bound, bool outside) {
  if (outside ? distance.inf() >= bound.sup() : distance.sup() <= bound.inf()) return 1;
  return (outside ? distance.sup() < bound.inf() : distance.inf() > bound.sup()) ? -1 : 0;
}

// Parts of a sweep, which halving keeps exact.
struct PartOfSweep {
  double low = 0;
  double high = 1;
};

struct OpenStretch {
  region::Stretch stretch;
  PartOfSweep part;
};

// `counts`: the part of the arc's sweep that is looked at.
Clearance halve(const region::Arc& arc, const Keep& keep, const PartOfSweep& counts) {
  const region::Rounding outward;
  const Interval bound = region::enclose(keep.bound());
  std::vector<OpenStretch> open{{whole(arc), {}}};
  bool undecided = false;
  for (int budget = kMostStretches; !open.empty() && budget > 0; --budget) {
    const auto [stretch, part] = open.back();
    open.pop_back();
    if (part.high <= counts.low || part.low >= counts.high) continue;
    if (side(distance_of(arc, stretch), bound, keep.outside) > 0) continue;
    const auto parts = halves(stretch);
    const double middle = (part.low + part.high) / 2;
    const region::IntervalVector point = arc.c + parts[0].b();
    const bool is_looked_at = counts.low <= middle && middle <= counts.high;
    if (is_looked_at && side(norm(point), bound, keep.outside) < 0) {
      return touching_at(region::middle_of(point), keep);
    }
    if (stretch.is_tiny()) {
      undecided = true;
      continue;
    }
    open.push_back({parts[0], {part.low, middle}});
    open.push_back({parts[1], {middle, part.high}});
  }
  if (undecided || !open.empty()) return {Clearance::Kind::undecided, {}, {}};
  return {};
}

// Whether a motion from `from` to `to` about the origin, of less than a turn more than its whole
// turns, passes the direction v. `sense`: +1 counterclockwise.
bool passes(const PlanePoint& from, const PlanePoint& to, const PlanePoint& v, int rot) {
  const int sense = rot < 0 ? -1 : 1;
  if (std::abs(rot) > 1 || from == to) return true;
  const int after_from = cross(from, v).sign() * sense;
  const int before_to = cross(v, to).sign() * sense;
  const bool less_than_half = cross(from, to).sign() * sense >= 0;
  return less_than_half ? after_from >= 0 && before_to >= 0 : after_from >= 0 || before_to >= 0;
}

// For an arc too flat for the intervals: it leaves the circle of its start by no more than its two
// radii differ, and on a circle the point nearest to the origin, or farthest from it, is known.
bool is_clear_as_circle(const region::LevelMotion& arc, const Keep& keep) {
  const PlanePoint from = arc.from - arc.centre;
  const PlanePoint to = arc.to - arc.centre;
  const Number radius = exact::sqrt(norm_squared(from));
  const Number spiral = abs(exact::sqrt(norm_squared(to)) - radius);
  const Number centre = exact::sqrt(norm_squared(arc.centre));
  const Number bound = keep.outside ? keep.bound() + spiral : keep.bound() - spiral;
  for (const PlanePoint& end : {arc.from, arc.to}) {
    const Number distance = exact::sqrt(norm_squared(end));
    if (keep.outside ? distance < bound : distance > bound) return false;
  }
  const PlanePoint towards{-arc.centre.p, -arc.centre.q};
  if (!passes(from, to, keep.outside ? towards : arc.centre, arc.rot)) return true;
  return keep.outside ? abs(radius - centre) >= bound : radius + centre <= bound;
}

}  // namespace

Clearance clearance_of_line(const PlanePoint& from, const PlanePoint& to, const Keep& keep) {
  if (!keep.outside) return clearance_of_point(farther(from, to), keep);
  const PlanePoint along = to - from;
  const Number length_2 = norm_squared(along);
  const Number at = -dot(from, along);
  if (length_2.sign() == 0 || at.sign() <= 0) return clearance_of_point(from, keep);
  if (at >= length_2) return clearance_of_point(to, keep);
  const Number part = at / length_2;
  return clearance_of_point({from.p + part * along.p, from.q + part * along.q}, keep);
}

Clearance clearance_of_box(const PlanePoint& from, const PlanePoint& to, const Keep& keep) {
  if (keep.outside) {
    const Number zero = 0;
    return clearance_of_point({nearest(from.p, to.p, zero), nearest(from.q, to.q, zero)}, keep);
  }
  return clearance_of_point(
      {abs(from.p) < abs(to.p) ? to.p : from.p, abs(from.q) < abs(to.q) ? to.q : from.q}, keep);
}

Clearance clearance_of_arc(const region::LevelMotion& motion, const Keep& keep,
                           const Number& from) {
  Clearance at_ends = clearance_of_point(motion.to, keep);
  if (at_ends.kind == Clearance::Kind::clear && from.sign() == 0) {
    at_ends = clearance_of_point(motion.from, keep);
  }
  if (at_ends.kind != Clearance::Kind::clear) return at_ends;
  if (motion.from == motion.centre || motion.to == motion.centre) {
    if (motion.from == motion.to) return at_ends;  // a turn of no radius is a place
    return {Clearance::Kind::undecided, {}, {}};
  }
  // An arc is read counterclockwise, so that the sweep of a clockwise one begins at its end.
  const double first = from.sign() > 0 ? std::nextafter(approximate(from), 0.0) : 0;
  const PartOfSweep counts =
      motion.rot > 0 ? PartOfSweep{first, 1} : PartOfSweep{0, std::nextafter(1 - first, 1.0)};
  Clearance clearance = halve(region::make_arc(motion, {Number(0), Number(0)}), keep, counts);
  if (clearance.kind == Clearance::Kind::undecided && is_clear_as_circle(motion, keep)) return {};
  return clearance;
}

}  // namespace gonogo::oracle
