// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/gouge.hpp"

#include <vector>

namespace gonogo::oracle::region {
namespace {

// Halvings of a spiral before it is called undecided.
constexpr int kMaximumStretches = 20'000;

Reach outside(const PlanePoint& witness, const Number& beyond) {
  return {Reach::Kind::outside, witness, beyond};
}

// The point of the round arc farthest from the origin, when it is not an end: straight away from
// the origin through the arc's centre.
Reach farthest_of_round(const Arc& arc, const Number& limit) {
  const PlanePoint& c = arc.centre;
  const Number c2 = norm_squared(c);
  // About the origin itself all points are equally far: the ends have decided.
  if (c2.sign() == 0) return {};
  if (!arc.full && !contains(arc.sweep, c)) return {};
  // sqrt(c2) + sqrt(a2) <= limit, squared twice.
  const Number room = limit * limit - c2 - arc.a2;
  if (room.sign() >= 0 && Number(4) * c2 * arc.a2 <= room * room) return {};
  const Number ratio = arc.a2 / c2;
  const PlanePoint far{c.p + c.p * exact::sqrt(ratio), c.q + c.q * exact::sqrt(ratio)};
  return outside(far, exact::sqrt(c2) + exact::sqrt(arc.a2) - limit);
}

// The squared distance from the origin over the stretch.
Interval squared_distance(const Arc& arc, const Stretch& stretch) {
  const Interval radius = hull(stretch.ra, stretch.rb);
  if (stretch.turns > 0 || stretch.wide || !(dot(stretch.ua, stretch.ub).lo > 0)) {
    const Interval far = norm(arc.c) + radius;
    return {0, square(far).hi};
  }
  const Interval along = projection(stretch.ua, stretch.ub, arc.c);
  return norm_squared(arc.c) + square(radius) + Interval{2, 2} * radius * along;
}

Reach farthest_of_spiral(const Arc& arc, const Number& limit) {
  const Interval bound = enclose(limit);
  const Interval bound2 = square(bound);
  std::vector<Stretch> open{whole(arc)};
  bool undecided = false;
  for (int budget = kMaximumStretches; !open.empty() && budget > 0; --budget) {
    const Stretch stretch = open.back();
    open.pop_back();
    if (squared_distance(arc, stretch).hi <= bound2.lo) continue;
    const auto parts = halves(stretch);
    const IntervalVector point = arc.c + parts[0].rb * parts[0].ub;
    const Interval distance = norm(point);
    if (distance.lo > bound.hi) {
      const PlanePoint witness{to_number(point.x.middle()), to_number(point.y.middle())};
      return outside(witness, to_number((distance - bound).lo));
    }
    if (norm(stretch.rb * stretch.ub - stretch.ra * stretch.ua).hi < 1e-10 && !stretch.wide &&
        stretch.turns == 0) {
      undecided = true;
      continue;
    }
    open.insert(open.end(), parts.begin(), parts.end());
  }
  if (undecided || !open.empty()) return {Reach::Kind::undecided, {}, {}};
  return {};
}

}  // namespace

Reach reach_of_point(const PlanePoint& point, const Number& limit) {
  const Number d2 = norm_squared(point);
  if (d2 <= limit * limit) return {};
  return outside(point, exact::sqrt(d2) - limit);
}

Reach reach_of_arc(const Arc& arc, const Number& limit) {
  const Interval radius = hull(arc.ra, arc.rb);
  if ((norm(arc.c) + radius).hi <= enclose(limit).lo) return {};
  for (const PlanePoint& end : {arc.end_a(), arc.end_b()}) {
    Reach reach = reach_of_point(end, limit);
    if (reach.kind != Reach::Kind::inside) return reach;
  }
  if (arc.round) return farthest_of_round(arc, limit);
  // About the origin the distance is the radius, which is largest at an end.
  if (norm_squared(arc.centre).sign() == 0) return {};
  return farthest_of_spiral(arc, limit);
}

}  // namespace gonogo::oracle::region
