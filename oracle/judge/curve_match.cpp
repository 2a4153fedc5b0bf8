// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/curve_match.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/judge/standing.hpp"

namespace gonogo::oracle {
namespace {

using reference::kAllAxes;
using reference::PlaneAxes;

// 2^-exponent of the magnitude of a.
Number scaled_down(const Number& a, int exponent) {
  return abs(a) * Number::binary(1, -exponent);
}

// The parameters t of [0, 1] at which from + t (to - from) agrees with `point` on every axis.
struct Span01 {
  Number low = 0;
  Number high = 1;
  bool empty() const { return high < low; }
};

Span01 agreeing_parameters(const Motion& line, const Position& point, const Number& tolerance) {
  Span01 span;
  for (Axis axis : kAllAxes) {
    const Number travel = line.to()[axis] - line.from[axis];
    if (travel.sign() == 0) {
      if (!agree(point[axis], line.from[axis], tolerance)) return {1, 0};
      continue;
    }
    const Number offset = point[axis] - line.from[axis];
    Number first = (offset - tolerance) / travel;
    Number second = (offset + tolerance) / travel;
    if (travel.sign() < 0) std::swap(first, second);
    span.low = max(span.low, first);
    span.high = min(span.high, second);
  }
  return span;
}

// Whether two rational points agree; false also where that takes more than rationals.
bool rationally_agree(const Position& a, const Position& b, const Number& tolerance) {
  return std::ranges::all_of(kAllAxes, [&](Axis axis) {
    const Number difference = a[axis] - b[axis];
    return difference.is_rational() && difference <= tolerance && -difference <= tolerance;
  });
}

// Whether there is such a parameter. Most often it is an end of the line, without a division.
bool agrees_with_line(const Motion& line, const Position& point, const Number& tolerance) {
  return rationally_agree(point, line.to(), tolerance) ||
         rationally_agree(point, line.from, tolerance) ||
         !agreeing_parameters(line, point, tolerance).empty();
}

bool moves_one_axis(const Motion& motion, const Number& tolerance) {
  const AxisSet moved = moved_axes(motion, tolerance);
  return std::ranges::count_if(kAllAxes, [&](Axis axis) { return moved.has(axis); }) == 1;
}

// J-PATH-04: whether `got` is the exact value, or that correctly rounded.
bool rounds_to(const Number& exact, const Number& got, const std::optional<Number>& resolution,
               const JudgeTerms& terms) {
  if (resolution && agree(exact * 2, got * 2, *resolution)) return true;
  // J-CONST-03. Two units in the last place of a double lie between 2^-52 and 2^-51 of the value.
  if (terms.binary64 && agree(exact, got, scaled_down(exact, 51))) return true;
  return exact == got;
}

}  // namespace

Axis longest_axis(const Motion& motion) {
  Axis longest = Axis::x;
  double length = -1;
  for (Axis axis : kAllAxes) {
    const double travel = std::abs(estimate(motion.to()[axis] - motion.from[axis]));
    if (travel > length) {
      length = travel;
      longest = axis;
    }
  }
  return longest;
}

bool feeds_agree(const Record& reference, const Record& subject, const JudgeTerms& terms) {
  return reference.feed_mode == subject.feed_mode &&
         rounds_to(reference.feed, subject.feed, terms.feed_resolution, terms);
}

CurveMatch::CurveMatch(const Motion& reference, const JudgeTerms& terms,
                       std::optional<OpenArc> open)
    : reference_(reference), terms_(terms), open_(std::move(open)) {
  if (is_round(reference.record.kind)) round_.emplace(reference_, open_);
}

MatchResult CurveMatch::match(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  if (terms_.compare_blocks && want.block != got.block) {
    return MatchResult::departs(Departure::block, "The motion belongs to another block.");
  }
  const bool is_cut = want.kind != RecordKind::rapid && want.kind != RecordKind::thread;
  const bool same_feed = !is_cut || feeds_agree(want, got, terms_);
  const std::optional<Progress> before = same_feed ? std::nullopt : std::optional(progress_);
  MatchResult result = MatchResult::departs(Departure::kind, "The motion is of another kind.");
  if (got.kind == RecordKind::feed && is_flat_arc3()) {
    result = match_line(subject);
  } else if (round_) {
    result = match_round(subject);
  } else if (want.kind == RecordKind::feed && got.kind == RecordKind::arc3) {
    result = match_flat(subject);
  } else if (want.kind == got.kind) {
    if (want.kind == RecordKind::rapid) return match_rapid(subject);
    if (want.kind == RecordKind::thread) return match_thread(subject);
    result = match_line(subject);
  }
  if (result.departure == Departure::none && before) {
    progress_ = *before;
    return MatchResult::departs(Departure::feed, "The feed differs.");
  }
  return result;
}

// An arc as small as the tolerance that is not the reference's may be a piece of the reference's,
// as far as can be seen, or nothing at all: what does not go on from it as a piece may as nothing.
MatchResult CurveMatch::match_round(const Motion& subject) {
  const double before = progress_.arc;
  MatchResult result = match_piece(subject);
  if (result.departure == Departure::none) {
    const bool may_be_none =
        may_mean_none(subject, reference_.from, reference_.dropped.get(), terms_);
    if (!result.done && may_be_none) progress_.none += progress_.arc - before;
    return result;
  }
  if (progress_.none == 0) return result;
  progress_.arc -= progress_.none;
  MatchResult without = match_piece(subject);
  if (without.departure == Departure::none) {
    progress_.none = 0;
    return without;
  }
  progress_.arc = before;
  return result;
}

// A piece of which it is open whether it ends on the curve decides nothing yet, for it is not the
// end: if what follows departs, so does the whole; if it leads to the end, the whole is open.
MatchResult CurveMatch::match_piece(const Motion& subject) {
  MatchResult result = match_any_piece(subject);
  if (result.departure != Departure::undecided || !result.reached) return result;
  progress_.arc = *result.reached;
  progress_.doubt = std::move(result.reason);
  return {};
}

MatchResult CurveMatch::match_any_piece(const Motion& subject) {
  const RecordKind got = subject.record.kind;
  if (got == RecordKind::arc) return match_arc(subject);
  if (got == RecordKind::arc3) return match_arc3(subject);
  if (got == RecordKind::feed && terms_.chord.sign() > 0) return match_chord(subject);
  return MatchResult::departs(Departure::kind, "The motion is of another kind.");
}

// J-PATH-03. A line whose lead counts instead of a feed. The spindle angle is that of its
// beginning: of the first of several pieces.
MatchResult CurveMatch::match_thread(const Motion& subject) {
  const Record& want = reference_.record;
  const Record& got = subject.record;
  const bool begins = agree(subject.from, reference_.from, terms_.tolerance);
  const MatchResult result = match_line(subject);
  if (result.departure != Departure::none) return result;
  if (!rounds_to(want.lead, got.lead, terms_.resolution, terms_)) {
    return MatchResult::departs(Departure::feed, "The lead differs.");
  }
  const Number turn = 360;
  const Number apart = got.start - want.start - turn * ((got.start - want.start) / turn).floor();
  if (begins && !rounds_to(want.start, got.start, terms_.resolution, terms_) &&
      !rounds_to(0, min(apart, turn - apart), terms_.resolution, terms_)) {
    return MatchResult::departs(Departure::geometry,
                                "The thread starts at another angle of the spindle.");
  }
  return result;
}

// J-PATH-02: rapids that end where it ends, monotone on each axis, no other axis.
MatchResult CurveMatch::match_rapid(const Motion& subject) {
  const Position& reached = progress_.traverse ? *progress_.traverse : subject.from;
  for (Axis axis : kAllAxes) {
    const Number& target = reference_.to()[axis];
    const Number& end = subject.to()[axis];
    const Number& tau = terms_.tolerance;
    const bool above_low = end >= target - tau || end >= reached[axis] - tau;
    const bool below_high = end <= target + tau || end <= reached[axis] + tau;
    if (!above_low || !below_high) {
      return MatchResult::departs(Departure::geometry, "The traverse leaves the way to its end.");
    }
  }
  const bool done = agree(subject.to(), reference_.to(), terms_.tolerance);
  if (!done) {
    // Not the piece's own end: steps back within the tolerance must not add up. By estimates, of
    // which each is nearer than the one before, for places at enclosures may be equal.
    Position nearest = reached;
    for (Axis axis : kAllAxes) {
      const Number& target = reference_.to()[axis];
      const double before = estimate(target - nearest[axis]);
      const double now = estimate(target - subject.to()[axis]);
      if (before * now < 0) {
        nearest[axis] = target;
      } else if (std::abs(now) < std::abs(before)) {
        nearest[axis] = subject.to()[axis];
      }
    }
    progress_.traverse = std::move(nearest);
  }
  return {Departure::none, done, {}};
}

MatchResult CurveMatch::match_line(const Motion& subject) {
  const Number& tau = terms_.tolerance;
  if (!agrees_with_line(reference_, subject.from, tau) &&
      !may_stand_at(subject.from, reference_.from, reference_.dropped.get(), terms_)) {
    return MatchResult::departs(Departure::geometry, "The cut does not start on the line.");
  }
  if (!agrees_with_line(reference_, subject.to(), tau))
    return MatchResult::departs(Departure::geometry, "The cut does not end on the line.");
  const Axis axis = longest_axis(reference_);
  const int direction = (reference_.to()[axis] - reference_.from[axis]).sign();
  const Number progress = (subject.to()[axis] - reference_.from[axis]) * direction;
  if (progress < progress_.line - terms_.tolerance) {
    return MatchResult::departs(Departure::geometry, "The cut goes back along the line.");
  }
  progress_.line = max(progress_.line, progress);
  return {Departure::none, agree(subject.to(), reference_.to(), terms_.tolerance), {}};
}

// J-PATH-11: whether the reference is an arc in space that nothing tells from its chord: rounded,
// its three points may lie in line, and then it can be put out only as that.
bool CurveMatch::is_flat_arc3() const {
  if (reference_.record.kind != RecordKind::arc3) return false;
  const ThreePoints points(reference_);
  return points.circle ? points.is_flat(terms_.tolerance) : !points.is_over_half();
}

// An arc in space that nothing tells from its chord.
MatchResult CurveMatch::match_flat(const Motion& subject) {
  const Position via = via_of(subject);
  if (!ThreePoints(subject).is_flat(terms_.tolerance) ||
      !agrees_with_line(reference_, via, terms_.tolerance)) {
    return MatchResult::departs(Departure::kind,
                                "The cut goes along an arc instead of a straight line.");
  }
  return match_line(subject);
}

bool CurveMatch::goes_beyond(const Motion& subject) const {
  const bool cut = reference_.record.kind != RecordKind::rapid;
  if (cut && !feeds_agree(reference_.record, subject.record, terms_)) return false;
  if (round_) return is_round(subject.record.kind) && arc_goes_beyond(subject);
  return reference_.record.kind == subject.record.kind && line_goes_beyond(subject);
}

bool CurveMatch::line_goes_beyond(const Motion& subject) const {
  const Number& tau = terms_.tolerance;
  // Traverses are joined along a single axis only.
  const bool traverse = reference_.record.kind == RecordKind::rapid;
  if (traverse &&
      (!moves_one_axis(subject, tau) || moved_axes(reference_, tau) != moved_axes(subject, tau))) {
    return false;
  }
  return agrees_with_line(reference_, subject.from, tau) &&
         agrees_with_line(subject, reference_.to(), tau);
}

}  // namespace gonogo::oracle
