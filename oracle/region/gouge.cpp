// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/gouge.hpp"

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

Reach outside(const PlanePoint& witness, const Number& beyond) {
  return {Reach::Kind::outside, witness, beyond};
}

// On a round arc the distance from the core, a convex function, is largest at an end or where it
// grows straight away from the arc's centre. There its gradient, the direction from the nearest
// point of the core, is the direction from the centre: that nearest point is a corner, and the
// arc's centre lies beyond it or on it; or it is inside a side, and the point an extreme one.
//
// The first: straight away from a corner through the centre of the arc.
Reach farthest_from_corner(const Arc& arc, const Corner& corner, const RoundedRectangle& limit) {
  const PlanePoint c = arc.centre - corner.at;
  const Number c2 = norm_squared(c);
  // About the corner itself all points are equally far: others decide.
  if (c2.sign() == 0 || !leads_away(limit, corner.sp, corner.sq, c)) return {};
  if (!arc.full && !contains(arc.sweep, c)) return {};
  // sqrt(c2) + sqrt(a2) <= limit, squared twice.
  const Number room = limit.radius * limit.radius - c2 - arc.a2;
  if (room.sign() >= 0 && Number(4) * c2 * arc.a2 <= room * room) return {};
  const Number ratio = exact::sqrt(arc.a2 / c2);
  const PlanePoint far = arc.centre + PlanePoint{c.p * ratio, c.q * ratio};
  return outside(far, exact::sqrt(c2) + exact::sqrt(arc.a2) - limit.radius);
}

// The second: the extreme point in a direction along one axis, given as the unit vector.
Reach farthest_from_side(const Arc& arc, const PlanePoint& axis, const RoundedRectangle& limit) {
  if (!arc.full && !contains(arc.sweep, axis)) return {};
  const bool along_p = axis.p.sign() != 0;
  const Number& aside = along_p ? arc.centre.q : arc.centre.p;
  if (exact::abs(aside) > (along_p ? limit.core_q : limit.core_p)) return {};
  // dot(c, axis) + sqrt(a2) <= half + limit.
  const Number room =
      (along_p ? limit.core_p : limit.core_q) + limit.radius - dot(arc.centre, axis);
  if (room.sign() >= 0 && arc.a2 <= room * room) return {};
  const Number radius = exact::sqrt(arc.a2);
  return outside(arc.centre + PlanePoint{radius * axis.p, radius * axis.q}, radius - room);
}

Reach farthest_of_round(const Arc& arc, const RoundedRectangle& limit) {
  for (const Corner& corner : corners_of(limit)) {
    Reach reach = farthest_from_corner(arc, corner, limit);
    if (reach.kind != Reach::Kind::inside) return reach;
  }
  if (limit.core_p.sign() == 0 && limit.core_q.sign() == 0) return {};
  for (const PlanePoint& axis :
       {PlanePoint{1, 0}, PlanePoint{0, 1}, PlanePoint{-1, 0}, PlanePoint{0, -1}}) {
    Reach reach = farthest_from_side(arc, axis, limit);
    if (reach.kind != Reach::Kind::inside) return reach;
  }
  return {};
}

class SpiralReach {
 public:
  SpiralReach(const Arc& arc, const RoundedRectangle& limit)
      : arc_(arc), limit_(enclose(limit)), corners_(corners_of(limit)) {}

  Reach farthest() const;

 private:
  double squared_distance(const Stretch& stretch) const;

  const Arc& arc_;
  EnclosedRectangle limit_;
  std::vector<Corner> corners_;
};

// An upper bound of the squared distance from the core over the stretch.
double SpiralReach::squared_distance(const Stretch& stretch) const {
  const CirclePiece piece = stretch.circles(arc_.c);
  if (!stretch.is_at_most_quarter()) {
    return square(square_root(squared_distance_to_core(limit_, arc_.c)) + piece.r).sup();
  }
  double least = std::numeric_limits<double>::infinity();
  // No point is farther from the core than from a corner of it.
  for (const Corner& corner : corners_) {
    least = std::min(least, region::squared_distance(piece, arc_.c - enclose(corner.at)).sup());
  }
  if (limit_.is_disc()) return least;
  return std::min(least, squared_distance_to_core(limit_, box_of(piece)).sup());
}

Reach SpiralReach::farthest() const {
  std::vector<Stretch> open{whole(arc_)};
  bool undecided = false;
  for (int budget = kMostStretches; !open.empty() && budget > 0; --budget) {
    const Stretch stretch = open.back();
    open.pop_back();
    if (squared_distance(stretch) <= limit_.radius2.inf()) continue;
    const auto parts = halves(stretch);
    const IntervalVector point = arc_.c + parts[0].b();
    const Interval distance = square_root(squared_distance_to_core(limit_, point));
    if (distance.inf() > limit_.radius.sup()) {
      return outside(middle_of(point), to_number((distance - limit_.radius).inf()));
    }
    if (stretch.is_tiny()) {
      undecided = true;
      continue;
    }
    open.insert(open.end(), parts.begin(), parts.end());
  }
  if (undecided || !open.empty()) return {Reach::Kind::undecided, {}, {}};
  return {};
}

}  // namespace

Reach reach_of(const PlanePoint& point, const RoundedRectangle& limit) {
  const Number d2 = squared_distance_to_core(limit, point);
  if (d2 <= limit.radius * limit.radius) return {};
  return outside(point, exact::sqrt(d2) - limit.radius);
}

Reach reach_of(const Arc& arc, const RoundedRectangle& limit) {
  const Rounding outward;
  const Interval radius = hull(arc.ra, arc.rb);
  const EnclosedRectangle around = enclose(limit);
  const Interval centre = square_root(squared_distance_to_core(around, arc.c));
  if ((centre + radius).sup() <= around.radius.inf()) return {};
  for (const PlanePoint& end : {arc.end_a(), arc.end_b()}) {
    Reach reach = reach_of(end, limit);
    if (reach.kind != Reach::Kind::inside) return reach;
  }
  if (arc.round) return farthest_of_round(arc, limit);
  // About the origin of a disc the distance is the radius, which is largest at an end.
  if (around.is_disc() && norm_squared(arc.centre).sign() == 0) return {};
  return SpiralReach(arc, limit).farthest();
}

}  // namespace gonogo::oracle::region
