// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/grade.hpp"

#include <algorithm>

#include "oracle/motion/places.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

using reference::kAllAxes;

namespace {

// Whether a point lies on the circle of a flat arc or an arc3; false where that takes more than
// rationals.
bool is_exactly_on(const Motion& round, const Position& point) {
  const SpacePoint from = space_point(round.from);
  const SpacePoint at = space_point(point);
  if (!is_rational(from) || !is_rational(at)) return false;
  if (round.record.kind == RecordKind::arc) {
    const Axis d = reference::axes_of(round.record.plane).d;
    const PlaneVector a = from_centre(round.record, round.from);
    const PlaneVector b = from_centre(round.record, point);
    if (!a.p.is_rational() || !a.q.is_rational() || round.to()[d] != round.from[d]) return false;
    return point[d] == round.from[d] && norm_squared(a) == norm_squared(b);
  }
  const SpacePoint via = space_point(round.record.via);
  const SpacePoint to = space_point(round.to());
  if (!is_rational(via) || !is_rational(to)) return false;
  const auto circle = circle_through(from, via, to);
  if (!circle) return false;
  const SpacePoint v = at - circle->centre;
  return dot(v, circle->normal).sign() == 0 && dot(v, v) == circle->radius_2;
}

// An enclosure may be its exact value or not: it is not.
bool is_exactly(const Number& got, const Number& exact) {
  const Number difference = got - exact;
  return difference.form() != Number::Form::enclosure && difference.sign() == 0;
}

bool is_exactly_on_line(const Motion& line, const Position& point) {
  const Axis longest = longest_axis(line);
  const Number whole = line.to()[longest] - line.from[longest];
  const Number part = point[longest] - line.from[longest];
  return std::ranges::all_of(kAllAxes, [&](Axis axis) {
    return is_exactly((point[axis] - line.from[axis]) * whole,
                      (line.to()[axis] - line.from[axis]) * part);
  });
}

}  // namespace

bool is_exact_piece(const Motion& piece, const Motion& want) try {
  if (want.record.kind == RecordKind::rapid) return true;
  if (!is_round(want.record.kind)) {
    return !is_round(piece.record.kind) && is_exactly_on_line(want, piece.to());
  }
  if (!is_round(piece.record.kind) || !is_exactly_on(want, piece.to())) return false;
  if (piece.record.kind == RecordKind::arc3) return is_exactly_on(want, via_of(piece));
  const std::optional<Motion> arc = as_arc(want);
  return arc && is_exactly(piece.record.centre[0], arc->record.centre[0]) &&
         is_exactly(piece.record.centre[1], arc->record.centre[1]);
} catch (const exact::Undecided&) {
  return false;
}

bool is_correctly_rounded(const Number& got, const Number& exact,
                          const Tolerances& tolerances) try {
  // Half a unit in the last place of a double is at most 2^-53 of its value.
  if (tolerances.binary64) return agree(got, exact, abs(got) * Number::binary(1, -kUlpBits - 1));
  return tolerances.resolution && agree(got, exact, *tolerances.resolution / 2);
} catch (const exact::Undecided&) {
  return false;  // an enclosure may be rounded so or not
}

Grade grade_of(const Motion& motion, const Motion& want, const Tolerances& tolerances,
               RoundingCensus* census) {
  Grade grade;
  // `exact_ones` takes a coordinate that is exact, `others` one that is not.
  const auto compare = [&](const Number& got, const Number& exact, RoundingCensus* exact_ones,
                           RoundingCensus* others) {
    if (is_exactly(got, exact)) {
      if (exact_ones != nullptr) exact_ones->take_exact(1);
      return;
    }
    grade.exact = false;
    const bool is_correct = is_correctly_rounded(got, exact, tolerances);
    grade.rounded = grade.rounded && is_correct;
    if (others != nullptr) others->take(exact, got, is_correct);
  };
  for (Axis axis : kAllAxes) {
    // What a subject moves by mistake is off, too; that it comes back from there says nothing.
    RoundingCensus* const told = tells_end(want, axis) ? census : nullptr;
    RoundingCensus* const moved = tells_end(motion, axis) ? census : told;
    compare(motion.to()[axis], want.to()[axis], told, moved);
  }
  if (motion.record.kind == RecordKind::arc) {
    const std::optional<Motion> arc = as_arc(want);
    for (std::size_t i : {0U, 1U}) {
      compare(motion.record.centre[i], arc->record.centre[i], census, census);
    }
  } else if (motion.record.kind == RecordKind::arc3 && !is_exactly_on(want, via_of(motion))) {
    if (want.record.kind == RecordKind::arc3) {
      for (Axis axis : reference::kLinearAxes) {
        compare(motion.record.via[axis], want.record.via[axis], nullptr, nullptr);
      }
    } else {
      grade.exact = grade.rounded = false;
    }
  }
  return grade;
}

}  // namespace gonogo::oracle
