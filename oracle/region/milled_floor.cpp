// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/milled_floor.hpp"

#include <algorithm>
#include <utility>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

// Strictly, whichever way rounding falls.
bool surely_inside(const EnclosedRectangle& shape, const IntervalVector& point) {
  if (shape.radius.inf() > 0)
    return squared_distance_to_core(shape, point).sup() < shape.radius2.inf();
  return abs(point.x()).sup() < shape.core_p.inf() && abs(point.y()).sup() < shape.core_q.inf();
}

bool is_turning(const LevelMotion& motion) {
  return motion.is_arc && motion.rot != 0 && !(motion.from == motion.centre) &&
         !(motion.to == motion.centre);
}

// The ends of an arc's pieces.
std::vector<IntervalVector> places_along(const Arc& arc) {
  std::vector<Stretch> pieces{whole(arc)};
  while (pieces.size() < kPiecesOfWay) {
    std::vector<Stretch> halved;
    for (const Stretch& piece : pieces) {
      for (const Stretch& half : halves(piece)) halved.push_back(half);
    }
    pieces = std::move(halved);
  }
  std::vector<IntervalVector> places{arc.c + whole(arc).a()};
  for (const Stretch& piece : pieces) places.push_back(arc.c + piece.b());
  return places;
}

std::vector<IntervalVector> places_along(const Line& line) {
  std::vector<IntervalVector> places;
  for (double k = 0; k <= kPiecesOfWay; ++k) {
    const Interval part = Interval(k) / Interval(kPiecesOfWay);
    places.push_back(line.a + part * (line.b - line.a));
  }
  return places;
}

}  // namespace

void MilledFloor::add(const LevelMotion& motion) {
  const Rounding outward;
  std::vector<IntervalVector> places;
  if (is_turning(motion)) {
    const Arc arc = make_arc(motion, {});
    places = places_along(arc);
    if (arc.round) path_.arcs.push_back(arc);
    if (!arc.round) places_.insert(places_.end(), places.begin(), places.end());
  } else if (!(motion.from == motion.to)) {
    path_.lines.push_back(make_line(motion.from, motion.to));
    places = places_along(path_.lines.back());
  }
  for (std::size_t i = 1; i < places.size(); ++i) add_way(places[i - 1], places[i]);
}

void MilledFloor::add_way(const IntervalVector& from, const IntervalVector& to) {
  if (!surely_inside(roughed_, from) || !surely_inside(roughed_, to)) return;
  const double length = norm(to - from).inf();
  way_ = way_ + Interval(length);
}

bool MilledFloor::is_milled(const PlanePoint& place) const {
  const IntervalVector at = enclose(place);
  const double reach = enclose(radius_).inf();
  const auto is_near = [&](Interval distance) { return distance.sup() <= reach; };
  return std::ranges::any_of(
             path_.lines,
             [&](const Line& line) { return is_near(square_root(squared_distance(line, at))); }) ||
         std::ranges::any_of(path_.arcs,
                             [&](const Arc& arc) { return is_near(distance_to_round(arc, at)); }) ||
         std::ranges::any_of(places_,
                             [&](const IntervalVector& each) { return is_near(norm(at - each)); });
}

std::optional<PlanePoint> MilledFloor::milled_place() const {
  const Rounding outward;
  const Number half_sides = area_.core_p + area_.core_q + (area_.radius - radius_) * Number(2);
  const auto rest = eroded(area_, radius_ * Number(2));
  if (!rest || !(way_.inf() > enclose(half_sides * Number(2)).sup())) return std::nullopt;
  const Number half_p = rest->core_p + rest->radius;
  const Number half_q = rest->core_q + rest->radius;
  int all = 0, milled = 0;
  std::optional<PlanePoint> place;
  for (int i = 1; i < 2 * kPlacesAcross; i += 2) {
    for (int j = 1; j < 2 * kPlacesAcross; j += 2) {
      const PlanePoint at{half_p * Number(i - kPlacesAcross) / Number(kPlacesAcross),
                          half_q * Number(j - kPlacesAcross) / Number(kPlacesAcross)};
      if (!contains(*rest, at) || norm_squared(at) <= radius_ * radius_) continue;
      ++all;
      if (!is_milled(at)) continue;
      ++milled;
      place = at;
    }
  }
  const Number of_a_place = half_p * half_q * Number(4) / Number(kPlacesAcross * kPlacesAcross);
  const Number along_way = radius_ * half_sides * Number(4);
  const bool much = 2 * milled > all || of_a_place * Number(milled) > along_way;
  return much ? place : std::nullopt;
}

}  // namespace gonogo::oracle::region
