// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/arc_turns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "oracle/motion/round_curve.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

// The ends as they are seen from the centre.
struct SeenEnds {
  explicit SeenEnds(const Motion& arc)
      : from(from_centre(arc.record, arc.from)), to(from_centre(arc.record, arc.to())) {}
  PlaneVector from;
  PlaneVector to;
};

// An end straight above the centre is not near it, though one of its numbers is about 0.
bool is_near_centre(const PlaneVector& v, const Number& within) {
  const auto is_beyond = [&](const Number& number) {
    return visible_sign(number - within) > 0 || visible_sign(number + within) < 0;
  };
  if (is_beyond(v.p) || is_beyond(v.q)) return false;
  return agree(v.p, 0, within) && agree(v.q, 0, within);
}

// The directions in which a box of half width `within` about a point is seen from the centre: from
// `first` counterclockwise to `last`. REQUIRES: the centre lies outside.
struct Directions {
  Directions(const PlaneVector& point, const Number& within) {
    for (const int p : {-1, 1}) {
      for (const int q : {-1, 1}) add({point.p + within * p, point.q + within * q});
    }
  }
  void add(const PlaneVector& corner) {
    if (!first || visible_sign(cross(*first, corner)) < 0) first = corner;
    if (!last || visible_sign(cross(*last, corner)) > 0) last = corner;
  }
  bool hold(const PlaneVector& v) const {
    return visible_sign(cross(*first, v)) >= 0 && visible_sign(cross(v, *last)) >= 0;
  }
  std::optional<PlaneVector> first;
  std::optional<PlaneVector> last;
};

// A filter: whether the ends are seen at more than 36 degrees from each other and boxes about them
// at less than 9.
bool are_surely_apart(const Motion& arc, const SeenEnds& seen, const Number& within) {
  const double part = approximate_turns(arc) - std::abs(arc.record.rot) + 1;
  return part > kTenthOfTurn && part < 1 - kTenthOfTurn &&
         std::min(estimate_length(seen.from), estimate_length(seen.to)) >
             kFarOff * estimate(within);
}

}  // namespace

Number rounding_of(const Motion& arc, const Tolerances& tolerances) {
  if (tolerances.resolution) return *tolerances.resolution / 2;
  if (!tolerances.binary64) return tolerances.exact ? Number(0) : tolerances.increment / 2;
  const reference::PlaneAxes axes = reference::axes_of(arc.record.plane);
  double largest = 0;
  for (const Number* each : {&arc.from[axes.p], &arc.from[axes.q], &arc.to()[axes.p],
                             &arc.to()[axes.q], &arc.record.centre[0], &arc.record.centre[1]}) {
    largest = std::max(largest, std::abs(estimate(*each)));
  }
  return two_units_of_double(largest);
}

region::OpenTurns open_turns(const std::array<Number, 2>& centre, const Number& reach,
                             const Tolerances& tolerances) {
  if (tolerances.resolution) return {*tolerances.resolution, true};
  if (!tolerances.binary64) return {tolerances.exact ? Number(0) : tolerances.increment, true};
  const double largest =
      std::max(std::abs(estimate(centre[0])), std::abs(estimate(centre[1]))) + estimate(reach);
  return {two_units_of_double(largest) * 2, false};
}

// The centre is rounded as the ends are. Exact, for a NO-GO depends on it.
bool may_be_nil_or_whole(const Motion& arc, const Number& rounding) {
  if (rounding.sign() == 0) return false;
  const Number within = rounding * 2;
  const SeenEnds seen(arc);
  if (are_surely_apart(arc, seen, within)) return false;
  if (is_near_centre(seen.from, within) || is_near_centre(seen.to, within)) return true;
  const Directions from(seen.from, within);
  const Directions to(seen.to, within);
  return from.hold(*to.first) || from.hold(*to.last) || to.hold(*from.first);
}

bool may_end_on_its_centre(const Motion& arc, const Number& rounding) {
  const Number within = rounding * 2;
  const SeenEnds seen(arc);
  return is_near_centre(seen.from, within) || is_near_centre(seen.to, within);
}

namespace {

// How an arc lies about its chord.
struct Bow {
  explicit Bow(const Motion& arc) {
    const SeenEnds seen(arc);
    side = cross(seen.from, seen.to) * (arc.record.rot < 0 ? -1 : 1);
    is_half_at_most = std::abs(arc.record.rot) == 1 &&
                      (visible_sign(side) > 0 ||
                       (visible_sign(side) == 0 && visible_sign(dot(seen.from, seen.to)) < 0));
    radius_2 = max(dot(seen.from, seen.from), dot(seen.to, seen.to));
    const PlaneVector chord{seen.to.p - seen.from.p, seen.to.q - seen.from.q};
    chord_2 = dot(chord, chord);
  }
  Number side;  // the chord's distance from the centre, times its length
  bool is_half_at_most = false;
  Number radius_2;  // of the larger radius
  Number chord_2;
};

// No point is farther from the chord than the larger radius less the distance of the chord from the
// centre: r <= d + tolerance.
bool is_shallow(const Bow& bow, const Number& tolerance) {
  const Number tau_2 = tolerance * tolerance;
  // r^2 <= d^2 + 2 d tau + tau^2 with d^2 = side^2 / chord^2, times the chord's square.
  const Number rest = (bow.radius_2 - tau_2) * bow.chord_2 - bow.side * bow.side;
  return rest.sign() <= 0 || rest * rest <= tau_2 * 4 * bow.side * bow.side * bow.chord_2;
}

}  // namespace

// More than half a turn: none is farther than the larger radius and that distance, r + d <=
// tolerance; of whole turns, and of one that leads on beside its plane, than the diameter.
bool is_narrow_arc(const Motion& arc, const Number& tolerance) {
  if (arc.record.rot == 0) return false;
  const Bow bow(arc);
  if (bow.is_half_at_most) return false;
  const reference::PlaneAxes axes = reference::axes_of(arc.record.plane);
  const bool rises = std::ranges::any_of(reference::kAllAxes, [&](Axis axis) {
    const bool is_in_plane = axis == axes.p || axis == axes.q;
    return !is_in_plane && visible_sign(arc.to()[axis] - arc.from[axis]) != 0;
  });
  if (!rises && visible_sign(bow.chord_2) == 0) return false;  // there is no chord
  const Number tau_2 = tolerance * tolerance;
  if (bow.radius_2 * 4 <= tau_2) return true;
  if (rises || std::abs(arc.record.rot) > 1) return false;
  // r^2 <= tau^2 - 2 d tau + d^2, times the chord's square.
  const Number rest = (tau_2 - bow.radius_2) * bow.chord_2 + bow.side * bow.side;
  return rest.sign() >= 0 && rest * rest >= tau_2 * 4 * bow.side * bow.side * bow.chord_2;
}

bool is_flat_arc(const Motion& arc, const Number& tolerance) {
  if (arc.record.rot == 0) return false;
  const Bow bow(arc);
  return bow.is_half_at_most ? is_shallow(bow, tolerance) : is_narrow_arc(arc, tolerance);
}

bool agrees_with_chord(const Motion& motion, const Number& tolerance) {
  if (motion.record.kind == RecordKind::arc) return is_flat_arc(motion, tolerance);
  if (motion.record.kind != RecordKind::arc3) return false;
  const ThreePoints points(motion);
  return points.circle ? points.is_flat(tolerance) : !points.is_over_half();
}

Motion chord_of(const Motion& round) {
  Motion chord = round;
  Record& record = chord.record;
  record.kind = RecordKind::feed;
  record.rot = 0;
  record.centre = {};
  record.via = {};
  return chord;
}

namespace {

// The point half way along an arc of at most half a turn.
Position middle_of_arc(const Motion& arc) {
  const reference::PlaneAxes axes = reference::axes_of(arc.record.plane);
  const SeenEnds seen(arc);
  PlaneVector towards{seen.from.p + seen.to.p, seen.from.q + seen.to.q};
  const int sense = arc.record.rot < 0 ? -1 : 1;
  if (towards.p.sign() == 0 && towards.q.sign() == 0) {
    towards = {-seen.from.q * sense, seen.from.p * sense};
  }
  const Number scale = exact::sqrt(dot(seen.from, seen.from) / dot(towards, towards));
  Position middle;
  for (Axis axis : reference::kAllAxes) middle[axis] = (arc.from[axis] + arc.to()[axis]) / 2;
  middle[axes.p] = arc.record.centre[0] + towards.p * scale;
  middle[axes.q] = arc.record.centre[1] + towards.q * scale;
  return middle;
}

}  // namespace

std::vector<Position> farthest_of_flat(const Motion& arc, const Number& tolerance) {
  if (!is_narrow_arc(arc, tolerance)) return {middle_of_arc(arc)};
  const reference::PlaneAxes axes = reference::axes_of(arc.record.plane);
  const SeenEnds seen(arc);
  const Number radius = exact::sqrt(max(dot(seen.from, seen.from), dot(seen.to, seen.to)));
  std::vector<Position> corners;
  for (const Position& end : {arc.from, arc.to()}) {
    for (const int p : {-1, 1}) {
      for (const int q : {-1, 1}) {
        corners.push_back(end);
        corners.back()[axes.p] = arc.record.centre[0] + radius * p;
        corners.back()[axes.q] = arc.record.centre[1] + radius * q;
      }
    }
  }
  return corners;
}

}  // namespace gonogo::oracle
