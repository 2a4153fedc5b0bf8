// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for the answer to one motion: how it departs, or how well it matches.
#include "oracle/judge/advice.hpp"
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/standing.hpp"

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
    return point[d] == round.from[d] && a.p * a.p + a.q * a.q == b.p * b.p + b.q * b.q;
  }
  const SpacePoint via = space_point(round.record.via);
  const SpacePoint to = space_point(round.to());
  if (!is_rational(via) || !is_rational(to)) return false;
  const auto circle = circle_through(from, via, to);
  if (!circle) return false;
  const SpacePoint v = at - circle->centre;
  return dot(v, circle->normal).sign() == 0 && dot(v, v) == circle->radius_2;
}

}  // namespace

// J-ALM-07. The centre that a control works out itself, within twice the tolerance of the right
// one: what follows is judged, for the arc ends where it should.
bool ProgramJudge::takes_coarse_centre(const MatchResult& result, const Motion& motion,
                                       const Motion& want) {
  const reference::ClauseId clause = want.record.centre_clause;
  if (clause == reference::kNoClause || !result.centre) return false;
  if (!agree(result.centre->distance, 0, terms_.tolerance * 2) ||
      !same_place(motion.to(), want.to(), terms_)) {
    return false;
  }
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.clause = clause;
  verdict.block = want.record.block;
  verdict.record = motion.number;
  verdict.want = record_text(want.record);
  verdict.got = record_text(motion.record);
  verdict.message = "The corrected centre of the arc differs by more than the tolerance.";
  set_deviation(verdict, result.centre->distance);
  if (!is_advice(verdict, terms_)) return false;
  if (!advice_) advice_ = advised(std::move(verdict), terms_);
  match_.reset();
  reference_.advance();
  return true;
}

// J-CMP-12: whether the motion is one that the reference makes later on.
bool ProgramJudge::fits_later(const Motion& motion) {
  constexpr int kLookAhead = 200;  // J-CONST-09
  for (int i = 0; i < kLookAhead && !reference_.at_end(); ++i, reference_.advance()) {
    const Motion* later = std::get_if<Motion>(&reference_.current());
    if (later == nullptr) continue;
    MatchResult result = CurveMatch(*later, terms_).match(motion);
    if (result.departure == Departure::none && result.done &&
        !agree(motion.from, motion.to(), terms_.tolerance) &&
        agree(motion.from, later->from, terms_.tolerance)) {
      return true;
    }
  }
  return false;
}

namespace {

std::string_view short_sentence(RecordKind kind) {
  switch (kind) {
    case RecordKind::rapid:
      return "The traverse ends before it is where it has to end.";
    case RecordKind::thread:
      return "The thread ends before it is where it has to end.";
    default:
      return "The cut ends before it is where it has to end.";
  }
}

}  // namespace

// J-PATH-13.
Verdict ProgramJudge::short_of(const Motion& want, const Motion& piece) const {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.clause = want.record.clause;
  verdict.block = want.record.block != 0 ? want.record.block : piece.record.block;
  verdict.record = piece.number + piece.behind_first;
  verdict.want = record_text(want.record);
  verdict.got = record_text(piece.record);
  verdict.message = short_sentence(want.record.kind);
  verdict.witness = point_text(piece.to(), moved_axes(piece, 0) | moved_axes(want, 0));
  try {
    set_deviation(verdict, largest_difference(piece.to(), want.to()));
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

// J-PATH-13: whether the motion that departs follows one that ended too early. It did where this
// one leads on as the reference does next, or where less was missing than this one is off. Goes on
// in the reference.
bool ProgramJudge::ended_short(const Motion& motion, const Motion& want, const Apart& apart) {
  reference_.advance();
  const Motion* piece = piece_before();
  if (piece == nullptr) return false;
  if (auto* next = std::get_if<Motion>(&reference_.behind_m_functions()); next != nullptr) {
    Motion moved = motion;
    moved.from = next->from;
    if (CurveMatch(*next, terms_).match(moved).departure == Departure::none) return true;
  }
  return apart.distance > terms_.tolerance &&
         largest_difference(piece->to(), want.to()) <= apart.distance;
}

// That motions differ is known; how far, and which departs first, may hang on an enclosure's width,
// and then stays unsaid.
void ProgramJudge::report_path_departure(const MatchResult& result, const Motion& motion,
                                         const Motion& want, Verdict& verdict) {
  departed_at_ = reference_.items();
  verdict.kind = VerdictKind::fail_geometry;
  const AxisSet axes = moved_axes(motion, 0) | moved_axes(want, 0);
  verdict.witness = point_text(result.centre ? result.centre->at : motion.to(), axes);
  try {
    const Apart apart = result.centre ? *result.centre : match_->apart(motion);
    verdict.witness = point_text(apart.at, axes);
    set_deviation(verdict, apart.distance);
    if (ended_short(motion, want, apart)) {
      verdict = short_of(want, *piece_before());
    } else if (fits_later(motion)) {
      verdict.kind = VerdictKind::fail_order;
      verdict.message = "A later motion comes here: one before it is missing, or comes after it.";
    }
  } catch (const exact::Undecided&) {
  }
}

void ProgramJudge::report_departure(const MatchResult& result, const Motion& motion,
                                    const Motion& want) {
  if (result.departure == Departure::undecided) {
    decide_gap(result.reason);
    return;
  }
  if (result.departure == Departure::geometry && takes_coarse_centre(result, motion, want)) return;
  if (result.departure != Departure::feed && hangs_on_rounding(want, terms_.tolerance)) {
    decide_gap(kPointsNearlyInLine);
    return;
  }
  Verdict verdict;
  verdict.clause = want.record.clause;
  verdict.block = want.record.block != 0 ? want.record.block : motion.record.block;
  verdict.record = motion.number;
  verdict.want = record_text(want.record);
  verdict.got = record_text(motion.record);
  verdict.message = result.reason;
  if (result.departure == Departure::feed) {
    verdict.kind = VerdictKind::fail_feed;
    verdict.word = 'F';
  } else {
    report_path_departure(result, motion, want, verdict);
  }
  decide(std::move(verdict));
}

// Whether ends and centres are exact, or correctly rounded, for the grade of a pass.
void ProgramJudge::note_match(const Motion& motion, const Motion& want) {
  auto compare = [&](const Number& got, const Number& exact) {
    const Number difference = got - exact;
    // An enclosure cannot be told from its exact value: not exact, for the grade.
    const bool enclosed = difference.form() == Number::Form::enclosure;
    if (!enclosed && difference.sign() == 0) return;
    exact_ = false;
    const bool half = terms_.resolution && agree(got, exact, *terms_.resolution / 2);
    // Half a unit in the last place of a double is at most 2^-53 of its value.
    const bool nearest = terms_.binary64 && agree(got, exact, abs(got) * Number::binary(1, -53));
    rounded_ = rounded_ && (terms_.binary64 ? nearest : half);
  };
  for (Axis axis : kAllAxes) compare(motion.to()[axis], want.to()[axis]);
  if (motion.record.kind == RecordKind::arc) {
    const std::optional<Motion> arc =
        want.record.kind == RecordKind::arc3 ? as_arc(want) : std::optional(want);
    for (std::size_t i : {0U, 1U}) compare(motion.record.centre[i], arc->record.centre[i]);
  } else if (motion.record.kind == RecordKind::arc3 && !is_exactly_on(want, via_of(motion))) {
    if (want.record.kind == RecordKind::arc3) {
      for (Axis axis : reference::kLinearAxes)
        compare(motion.record.via[axis], want.record.via[axis]);
    } else {
      exact_ = rounded_ = false;
    }
  }
}

}  // namespace gonogo::oracle
