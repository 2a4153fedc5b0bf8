// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/order_proof.hpp"

#include <algorithm>

#include "oracle/region/constants.hpp"

namespace gonogo::oracle::region {
namespace {

class Proof {
 public:
  Proof(const IntervalVector& at, const Support& support)
      : at_(at), step_(support.step), reach_(support.reach) {}

  // The distance of the place from all points of a stretch of a unit of an arc, or of a line.
  Interval distance(const CutUnit& unit, const Stretch& stretch) const {
    return square_root(squared_distance(stretch.circles(unit.c), unit.c - at_));
  }
  Interval distance_to_line(const CutUnit& unit) const {
    const Interval from = norm(unit.begin - at_);
    const Interval to = norm(unit.end - at_);
    const Interval length = norm(unit.end - unit.begin);
    const double farthest = std::max(from.sup(), to.sup());
    if (!(length.inf() > 0))
      return {std::max(0.0, std::min(from.inf(), to.inf()) - length.sup()), farthest};
    const IntervalVector u = region::unit(unit.end - unit.begin);
    const Interval nearest = square_root(squared_distance(unit.begin, unit.end, u, length, at_));
    return {nearest.inf(), farthest};
  }

  bool take(const CutUnit& unit, const Stretch& stretch, int depth = 0);
  bool take_line(const CutUnit& unit);
  // All of the unit is out of reach.
  bool is_out(const CutUnit& unit, const Stretch& stretch, int depth = 0);
  bool is_line_out(const CutUnit& unit) { return notes(distance_to_line(unit)); }

  // Remembers the distance of what is surely out of reach.
  bool notes(Interval distance) {
    if (!(distance.inf() > reach_.sup())) return false;
    least_ = std::min(least_, distance.inf());
    return true;
  }
  double least() const { return least_; }

 private:
  // Whether the path comes nearer all along.
  bool approaches(const CutUnit& unit, const Stretch& stretch) const;
  bool approaches_on_line(const CutUnit& unit) const {
    return scalar_product(unit.end - unit.begin, unit.end - at_).sup() < 0;
  }

  IntervalVector at_;
  Interval step_;
  Interval reach_;
  bool was_out_ = false;  // the path may have been farther off than the step since what comes now
  double least_ = std::numeric_limits<double>::infinity();
};

// With w = c - at and g = c + r u: half the derivative of |g - at|^2 by the angle is
// r' (r + <u, w>) + r <u', w>, u' being u turned left; <u', w> = <u, w turned right>.
bool Proof::approaches(const CutUnit& unit, const Stretch& stretch) const {
  const IntervalVector w = unit.c - at_;
  const Interval r = hull(stretch.ra, stretch.rb);
  const Interval chord = norm(stretch.ub - stretch.ua);
  // An angle up to 90 degrees is at most 1.1108 times its chord.
  const Interval angle = chord * Interval{1, 1.1108};
  const Interval slope =
      stretch.ra.is_same(stretch.rb) ? Interval(0) : (stretch.rb - stretch.ra) / angle;
  const Interval growth = slope * (r + projection(stretch.ua, stretch.ub, w)) +
                          r * projection(stretch.ua, stretch.ub, w.perpendicular(CGAL::CLOCKWISE));
  return unit.counterclockwise ? growth.sup() < 0 : growth.inf() > 0;
}

// Backwards in time. What is within reach supports the place once the path was farther off since;
// where it only comes nearer, it was not.
bool Proof::take(const CutUnit& unit, const Stretch& stretch, int depth) {
  const Interval d = distance(unit, stretch);
  if (notes(d)) {
    was_out_ = true;
    return true;
  }
  if (!was_out_ && d.sup() <= step_.inf()) return true;
  if (!was_out_ && approaches(unit, stretch)) {
    was_out_ = true;
    return true;
  }
  if (depth == kMostHalvings) return false;
  const auto parts = halves(stretch);
  const std::size_t later = unit.counterclockwise ? 1 : 0;
  return take(unit, parts[later], depth + 1) && take(unit, parts[1 - later], depth + 1);
}

bool Proof::take_line(const CutUnit& unit) {
  const Interval d = distance_to_line(unit);
  if (!unit.clears) {
    was_out_ = was_out_ || !(d.sup() <= step_.inf());
    return true;
  }
  if (notes(d)) {
    was_out_ = true;
    return true;
  }
  if (was_out_) return false;
  if (d.sup() <= step_.inf()) return true;
  was_out_ = true;
  return approaches_on_line(unit);
}

bool Proof::is_out(const CutUnit& unit, const Stretch& stretch, int depth) {
  if (notes(distance(unit, stretch))) return true;
  if (depth == kMostHalvings || distance(unit, stretch).sup() <= reach_.inf()) return false;
  const auto parts = halves(stretch);
  return is_out(unit, parts[0], depth + 1) && is_out(unit, parts[1], depth + 1);
}

}  // namespace

std::optional<double> distance_from_support(std::span<const CutUnit> units, std::size_t unit,
                                            const Stretch& behind, const IntervalVector& at,
                                            const Support& support) {
  Proof proof(at, support);
  if (!proof.notes(norm(at - support.plunge))) return std::nullopt;
  const CutUnit& own = units[unit];
  if (own.clears) {
    if (own.is_line) {
      CutUnit part = own;
      part.end = at;
      if (!proof.take_line(part)) return std::nullopt;
    } else if (!proof.take(own, behind)) {
      return std::nullopt;
    }
  }
  for (std::size_t i = unit; i-- > 0;) {
    const CutUnit& other = units[i];
    bool proved = true;
    if (own.clears) {
      proved = other.is_line ? proof.take_line(other) : proof.take(other, other.stretch);
    } else if (other.clears) {
      proved = other.is_line ? proof.is_line_out(other) : proof.is_out(other, other.stretch);
    }
    if (!proved) return std::nullopt;
  }
  return proof.least();
}

}  // namespace gonogo::oracle::region
