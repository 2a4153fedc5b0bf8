// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/mismatch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "oracle/judge/unit_error.hpp"
#include "oracle/motion/labels.hpp"
#include "oracle/motion/places.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/compared.hpp"

namespace gonogo::oracle {

GapReason reason_of(const reference::NotCovered& outside) {
  return outside.lacks.empty() ? GapReason::not_covered : GapReason::profile_lacks;
}

Verdict not_covered_verdict(const reference::NotCovered& outside) {
  Verdict verdict = gap_verdict(reason_of(outside), outside.message);
  verdict.block = outside.block;
  return verdict;
}

// J-ALM-01
Verdict advised(Verdict departure, const Tolerances& tolerances) {
  if (tolerances.strict || !reference::is_silent(departure.clause)) return departure;
  departure.departure = departure.kind;
  departure.kind = VerdictKind::advice;
  return departure;
}

// R9.
std::optional<Verdict> coarse_centre_advice(const CurveAnswer& answer, const Motion& motion,
                                            const Motion& want, const Tolerances& tolerances) {
  if (want.record.centre_clause == reference::kNoClause || !answer.centre) return std::nullopt;
  // R7: the silence is about the centre, and excuses no feed and no turn.
  if (motion.record.rot != want.record.rot ||
      !feeds_agree(want.record, motion.record, tolerances)) {
    return std::nullopt;
  }
  if (!agree(answer.centre->distance, 0, tolerances.tolerance * 2) ||
      !same_place(motion.to(), want.to(), tolerances)) {
    return std::nullopt;
  }
  Verdict verdict =
      verdict_on(VerdictKind::fail_geometry, motion.record, motion.number,
                 "The corrected centre of the arc differs by more than the tolerance.");
  verdict.clause = want.record.centre_clause;
  verdict.block = want.record.block;
  verdict.want = record_text(want.record);
  set_deviation(verdict, answer.centre->distance);
  verdict = advised(std::move(verdict), tolerances);
  if (verdict.kind != VerdictKind::advice) return std::nullopt;
  return verdict;
}

std::string place_text(const Position& at) {
  AxisSet axes{Axis::x, Axis::y, Axis::z};
  for (Axis axis : {Axis::a, Axis::c}) {
    if (visible_sign(at[axis]) != 0) axes.add(axis);
  }
  return point_text(at, axes);
}

void tell_distance(Verdict& verdict, const Number& distance, const Position& got,
                   const Position& want, const Number& tolerance) {
  set_deviation(verdict, distance);
  for (Axis axis : {Axis::a, Axis::c}) {
    if (!agree(got[axis], want[axis], tolerance)) tell_degrees(verdict, axis, got, want);
  }
}

namespace {

// J-CMP-12: whether the motion is one that the reference makes later on, from step `number`.
bool fits_later(const Motion& motion, std::size_t number, ReferenceSteps& steps,
                const Tolerances& tolerances) {
  if (agree(motion.from, motion.to(), tolerances.tolerance)) return false;
  for (std::size_t i = number; i < number + kLookAhead; ++i) {
    const ReferenceSteps::Step& step = steps.at(i);
    if (is_end(step.what)) return false;
    const Motion* later = std::get_if<Motion>(&step.what);
    if (later == nullptr || !agree(motion.from, later->from, tolerances.tolerance)) continue;
    const CurveAnswer answer = steps.curve_of(step)->follow({}, motion);
    if (!answer.departs() && answer.ways.front().done) return true;
  }
  return false;
}

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

// What is said of whole turns, where pieces of an arc have come as far as `from` and all else of
// its end agrees. The estimate only chooses between whole numbers.
std::string missing_turns(const Hypothesis& from, const Tolerances& tolerances) {
  const Motion& want = from.curve->motion();
  if (want.record.kind != RecordKind::arc ||
      !agree(from.piece->to(), want.to(), tolerances.tolerance)) {
    return {};
  }
  return turns_that_came(Number(std::abs(std::int64_t{want.record.rot})),
                         approximate_turns(want) - from.progress.arc);
}

// The same where an arc goes on beyond its end.
std::string more_turns(const Refutation& refutation, const Tolerances& tolerances) {
  const Motion& want = refutation.from.curve->motion();
  const Motion& motion = *refutation.motion;
  const bool are_arcs =
      want.record.kind == RecordKind::arc && motion.record.kind == RecordKind::arc;
  if (!are_arcs || refutation.answer.departure != Departure::geometry || refutation.answer.centre ||
      motion.record.plane != want.record.plane ||
      !agree(motion.to(), want.to(), tolerances.tolerance)) {
    return {};
  }
  const double more = std::round(refutation.from.progress.arc + approximate_turns(motion) -
                                 approximate_turns(want));
  if (more < 1) return {};
  const Number due(std::abs(std::int64_t{want.record.rot}));
  return reference::with_values(" It makes {} turns in place of {}.",
                                {due + Number(static_cast<std::int64_t>(more)), due});
}

}  // namespace

Verdict short_of(const Hypothesis& from, const Tolerances& tolerances) {
  const Motion& want = from.curve->motion();
  const Motion& piece = *from.piece;
  Verdict verdict =
      verdict_on(VerdictKind::fail_geometry, piece.record, piece.number + piece.behind_first,
                 std::string(short_sentence(want.record.kind)));
  if (want.record.kind == RecordKind::rapid) verdict.rule = RelationRule::traverse;
  verdict.clause = want.record.clause;
  if (want.record.block != 0) verdict.block = want.record.block;
  verdict.want = record_text(want.record);
  verdict.witness = place_text(piece.to());
  try {
    tell_distance(verdict, largest_difference(piece.to(), want.to()), piece.to(), want.to(), 0);
    verdict.message += missing_turns(from, tolerances);
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

void tell_degrees(Verdict& verdict, Axis rotary, const Position& got, const Position& want) {
  verdict.message +=
      reference::with_values(fmt::format(" The axis {} is at {{}} degrees in place of {{}}.",
                                         rotary == Axis::a ? 'A' : 'C'),
                             {got[rotary], want[rotary]});
}

Verdict ends_early(const Hypothesis& from, const ReferenceStep& step, std::size_t records,
                   const std::string& got, const Tolerances& tolerances) {
  if (std::holds_alternative<Motion>(step) && from.piece) return short_of(from, tolerances);
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.rule = RelationRule::event;  // R5: the end comes at another place
  verdict.got = got;
  verdict.clause = clause_of(step);
  verdict.block = block_of(step);
  verdict.want = step_text(step);
  verdict.witness = place_text(from.at);
  verdict.record = records;
  verdict.message =
      fmt::format("{} comes before this {}.", got == "end" ? "The end of the trace" : "The alarm",
                  dwell_of(step) != nullptr ? "dwell" : "motion");
  return verdict;
}

Number rounding_of_number(const Number& number, const std::optional<Number>& resolution,
                          const Tolerances& tolerances) {
  if (resolution) return *resolution / 2;
  return tolerances.binary64 ? abs(number) * Number::binary(1, 1 - kUlpBits) : Number(0);
}

namespace {

// For a feed or a lead that differs: both values.
std::string values_of(const Motion& want, const Record& got) {
  if (want.record.kind == RecordKind::thread) {
    return reference::with_values(" It is {} mm in place of {}.", {got.lead, want.record.lead});
  }
  return feed_in_place_of(got, want.record.feed, want.record.feed_mode,
                          turns_alone(want.record, want.from));
}

// What it may come from.
std::string unit_error_of(const Motion& motion, const Record& got, const Tolerances& tolerances) {
  const Record& want = motion.record;
  if (want.kind == RecordKind::thread) {
    return unit_error(Quantity::lead, want.lead, got.lead,
                      rounding_of_number(got.lead, tolerances.resolution, tolerances));
  }
  if (want.feed_mode != got.feed_mode) return {};
  return unit_error(turns_alone(want, motion.from) ? Quantity::rotary_feed : Quantity::feed,
                    want.feed, got.feed,
                    rounding_of_number(got.feed, tolerances.feed_resolution, tolerances));
}

// J-CMP-12: whether the motion that departs follows one that ended too early. It did where this
// one leads on as the reference does next, or where less was missing than this one is off.
bool ended_short(const Refutation& refutation, const Apart& apart, ReferenceSteps& steps,
                 const Tolerances& tolerances) {
  const Hypothesis& from = refutation.from;
  if (!from.piece) return false;
  const ReferenceSteps::Step& next = steps.at(from.step + from.joined + 1);
  if (auto* later = std::get_if<Motion>(&next.what)) {
    Motion moved = *refutation.motion;
    moved.from = later->from;
    if (!steps.curve_of(next)->follow({}, moved).departs()) return true;
  }
  return apart.distance > tolerances.tolerance &&
         largest_difference(from.piece->to(), from.curve->motion().to()) <= apart.distance;
}

// That motions differ is known; how far, and which departs first, may depend on an enclosure's
// width, and then stays unsaid.
void explain_path(const Refutation& refutation, ReferenceSteps& steps, const Tolerances& tolerances,
                  Verdict& verdict) {
  const Hypothesis& from = refutation.from;
  const Motion& motion = *refutation.motion;
  const Motion& want = from.curve->motion();
  const Departure how = refutation.answer.departure;
  if (how == Departure::kind || how == Departure::block) {
    verdict.rule = RelationRule::label;
  } else if (want.record.kind == RecordKind::rapid) {
    verdict.rule = RelationRule::traverse;
  }
  const std::optional<Apart>& centre = refutation.answer.centre;
  verdict.witness = place_text(centre ? centre->at : motion.to());
  try {
    const Apart apart = centre ? *centre : from.curve->apart(from.progress, motion);
    const Apart shown = from.curve->farthest(apart, from.progress, motion);
    verdict.witness = place_text(shown.at);
    tell_distance(verdict, shown.distance, motion.to(), want.to(), tolerances.tolerance);
    if (ended_short(refutation, apart, steps, tolerances)) {
      verdict = short_of(from, tolerances);
    } else if (fits_later(motion, from.step + from.joined + 1, steps, tolerances)) {
      verdict.kind = VerdictKind::fail_order;
      verdict.rule = RelationRule::event;
      verdict.message = "A later motion comes here: one before it is missing, or comes after it.";
    } else {
      verdict.message += more_turns(refutation, tolerances);
    }
  } catch (const exact::Undecided&) {
  }
}

// A motion of an earlier block is too many there, unless it is the one that is due.
std::uint64_t departing_block(const Refutation& refutation, const ReferenceSteps& steps) {
  Motion motion = *refutation.motion;
  const std::uint64_t got = motion.record.block;
  const std::uint64_t due = refutation.from.curve->motion().record.block;
  if (due == 0) return got;
  motion.record.block = due;
  const bool is_earlier = got != 0 && got < due && steps.is_in_order();
  return is_earlier && refutation.from.curve->follow(refutation.from.progress, motion).departs()
             ? got
             : due;
}

}  // namespace

std::optional<Verdict> known_verdict(const Refutation& refutation, const Tolerances& tolerances) {
  if (refutation.verdict) return refutation.verdict;
  const Motion& want = refutation.from.curve->motion();
  if (refutation.answer.departure != Departure::feed &&
      hangs_on_rounding(want, tolerances.tolerance)) {
    return gap_verdict(GapReason::rounding, kPointsNearlyInLine);
  }
  return std::nullopt;
}

Verdict explain(const Refutation& refutation, ReferenceSteps& steps, const Tolerances& tolerances) {
  const Motion& motion = *refutation.motion;
  const Motion& want = refutation.from.curve->motion();
  const CurveAnswer& answer = refutation.answer;
  const bool is_feed = answer.departure == Departure::feed;
  Verdict verdict = verdict_on(is_feed ? VerdictKind::fail_feed : VerdictKind::fail_geometry,
                               motion.record, motion.number, answer.reason);
  verdict.clause = want.record.clause;
  verdict.block = departing_block(refutation, steps);
  verdict.want = record_text(want.record);
  if (is_feed) {
    verdict.word = 'F';
    verdict.message += values_of(want, motion.record);
    verdict.message += unit_error_of(want, motion.record, tolerances);
  } else {
    explain_path(refutation, steps, tolerances, verdict);
  }
  return verdict;
}

}  // namespace gonogo::oracle
