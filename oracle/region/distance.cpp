// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/distance.hpp"

#include <limits>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {

Interval distance_to_round(const Arc& arc, const IntervalVector& point) {
  const IntervalVector offset = point - arc.c;
  const Interval to_circle = abs(norm(offset) - arc.ra);
  if (arc.full) return to_circle;
  const Interval left_of_a = determinant(arc.ua, offset);
  const Interval right_of_b = determinant(offset, arc.ub);
  const bool before = left_of_a.sup() < 0;
  const bool after = right_of_b.sup() < 0;
  const bool in = arc.sweep.wide ? left_of_a.inf() > 0 || right_of_b.inf() > 0
                                 : left_of_a.inf() > 0 && right_of_b.inf() > 0;
  if (in) return to_circle;
  const Interval a = norm(offset - arc.ra * arc.ua);
  const Interval b = norm(offset - arc.ra * arc.ub);
  const Interval to_end = CGAL::min(a, b);
  const bool out = arc.sweep.wide ? before && after : before || after;
  return out ? to_end : Interval{std::min(to_circle.inf(), to_end.inf()), to_end.sup()};
}

namespace {

Interval distance_to_stretch(const Arc& arc, const Stretch& stretch, const IntervalVector& point) {
  const IntervalVector offset = point - arc.c;
  const Interval radius = hull(stretch.ra, stretch.rb);
  const double least = abs(norm(offset) - radius).inf();
  const double at_a = norm(offset - stretch.a()).sup();
  if (stretch.turns > 0 || stretch.wide) return {least, at_a};
  // All of it lies in a disc about the point at its middle direction and end radius.
  const IntervalVector m = middle_direction(stretch.ua, stretch.ub, false);
  const Interval size = radius * norm(m - stretch.ua) + abs(stretch.rb - stretch.ra);
  return {std::max(least, (norm(offset - stretch.ra * m) - size).inf()), at_a};
}

// A lower bound of the distance that is above `reach`, if one shows.
std::optional<double> clear_of_spiral(const Arc& arc, const IntervalVector& point, Interval reach) {
  std::vector<Stretch> open{whole(arc)};
  double least = std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  for (int budget = kMostStretches; !open.empty(); --budget) {
    const Stretch stretch = open.back();
    open.pop_back();
    const Interval distance = distance_to_stretch(arc, stretch, point);
    upper = std::min(upper, distance.sup());
    if (upper <= reach.sup() || budget <= 0) return std::nullopt;
    // Good enough once it is clear, or as close as the midway to the nearest point known.
    if (distance.inf() > reach.sup() + (upper - reach.sup()) * kAlmost) {
      least = std::min(least, distance.inf());
      continue;
    }
    const auto parts = halves(stretch);
    open.insert(open.end(), parts.begin(), parts.end());
  }
  return least;
}

// The squared distance from the point to the nearest of the arc's ends.
Number squared_distance_to_ends(const Arc& arc, const PlanePoint& offset) {
  return min(norm_squared(offset - arc.sweep.a), norm_squared(offset - arc.sweep.b));
}

// Whether the exact distance to a round arc is above the reach; squared until no root is left.
bool beyond_round(const Arc& arc, const PlanePoint& point, const Number& reach) {
  const PlanePoint offset = point - arc.centre;
  const Number d2 = norm_squared(offset);
  const Number s2 = reach * reach;
  if (!arc.full && !contains(arc.sweep, offset)) {
    return squared_distance_to_ends(arc, offset) > s2;
  }
  const Number outward = d2 - arc.a2 - s2;  // d > r + s
  if (outward.sign() > 0 && outward * outward > Number(4) * s2 * arc.a2) return true;
  const Number inward = arc.a2 - d2 - s2;  // d + s < r
  return inward.sign() > 0 && inward * inward > Number(4) * s2 * d2;
}

Number exact_distance(const Arc& arc, const PlanePoint& point) {
  const PlanePoint offset = point - arc.centre;
  if (!arc.full && !contains(arc.sweep, offset)) {
    return exact::sqrt(squared_distance_to_ends(arc, offset));
  }
  return exact::abs(exact::sqrt(norm_squared(offset)) - exact::sqrt(arc.a2));
}

Number smaller(const Number& a, const Number& b) {
  try {
    return min(a, b);
  } catch (const exact::Undecided&) {
    return a;  // equal to thousands of bits
  }
}

// What is nearest to the point, gathered over the path.
struct Nearest {
  const PlanePoint& point;
  const Number& reach;
  IntervalVector approximate = enclose(point);
  Interval limit = enclose(reach);
  std::vector<std::pair<double, const Arc*>> arcs{};  // by the lower bound of the distance
  std::vector<Number> distances{};                    // to points and spirals
  double upper = std::numeric_limits<double>::infinity();

  // False when the path comes within reach, or when that stays open.
  bool take(const Arc& arc) {
    if (!arc.round) {
      const auto clear = clear_of_spiral(arc, approximate, limit);
      if (!clear) return false;
      distances.push_back(to_number(*clear));
      return true;
    }
    const Interval distance = distance_to_round(arc, approximate);
    if (distance.sup() < limit.inf()) return false;
    if (!(distance.inf() > limit.sup()) && !beyond_round(arc, point, reach)) return false;
    if (distance.inf() <= upper) arcs.emplace_back(distance.inf(), &arc);
    upper = std::min(upper, distance.sup());
    return true;
  }
  bool take(const PlanePoint& visited) {
    const Number d2 = norm_squared(point - visited);
    if (d2 <= reach * reach) return false;
    distances.push_back(exact::sqrt(d2));
    return true;
  }
  bool take(const Line& line) {
    const Interval distance = square_root(squared_distance(line, approximate));
    if (distance.sup() < limit.inf()) return false;
    const bool clear = distance.inf() > limit.sup();
    if (clear && distance.inf() > upper) return true;
    upper = std::min(upper, distance.sup());
    const Number d2 = squared_distance(line, point);
    if (!clear && d2 <= reach * reach) return false;
    distances.push_back(exact::sqrt(d2));
    return true;
  }
};

}  // namespace

std::optional<Number> excess(const Path& path, const PlanePoint& point, const Number& reach) {
  Nearest nearest{point, reach};
  for (const PlanePoint& visited : path.points) {
    if (!nearest.take(visited)) return std::nullopt;
  }
  for (const Line& line : path.lines) {
    if (!nearest.take(line)) return std::nullopt;
  }
  for (const Arc& arc : path.arcs) {
    if (!nearest.take(arc)) return std::nullopt;
  }
  std::optional<Number> least;
  const auto add = [&least](const Number& d) { least = least ? smaller(*least, d) : d; };
  for (const Number& distance : nearest.distances) add(distance);
  for (const auto& [lower, arc] : nearest.arcs) {
    if (lower <= nearest.upper) add(exact_distance(*arc, point));
  }
  if (!least) return std::nullopt;
  return *least - reach;
}

}  // namespace gonogo::oracle::region
