// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/mismatch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "oracle/judge/advice.hpp"
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
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.clause = want.record.centre_clause;
  verdict.block = want.record.block;
  verdict.record = motion.number;
  verdict.want = record_text(want.record);
  verdict.got = record_text(motion.record);
  verdict.message = "The corrected centre of the arc differs by more than the tolerance.";
  set_deviation(verdict, answer.centre->distance);
  verdict = advised(std::move(verdict), tolerances);
  if (verdict.kind != VerdictKind::advice) return std::nullopt;
  return verdict;
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

// X, Y and Z, and the rotary axes that are not at zero.
std::string place_text(const Position& at) {
  AxisSet axes{Axis::x, Axis::y, Axis::z};
  for (Axis axis : {Axis::a, Axis::c}) {
    if (visible_sign(at[axis]) != 0) axes.add(axis);
  }
  return point_text(at, axes);
}

// How far a motion is off: linear axes in mm, rotary ones in degrees.
void tell_distance(Verdict& verdict, const Number& distance, const Position& got,
                   const Position& want, const Number& tolerance) {
  set_deviation(verdict, distance);
  for (Axis axis : {Axis::a, Axis::c}) {
    if (!agree(got[axis], want[axis], tolerance)) tell_degrees(verdict, axis, got, want);
  }
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
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  if (want.record.kind == RecordKind::rapid) verdict.rule = RelationRule::traverse;
  verdict.clause = want.record.clause;
  verdict.block = want.record.block != 0 ? want.record.block : piece.record.block;
  verdict.record = piece.number + piece.behind_first;
  verdict.want = record_text(want.record);
  verdict.got = record_text(piece.record);
  verdict.message = short_sentence(want.record.kind);
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

namespace {

// What is said of a motion that is not due, with the farthest place that it leads to, and how far
// that is from where the tool has to stay.
Verdict undue(const Motion& motion, const ReferenceSteps::Step& step, const Tolerances& tolerances,
              std::string_view sentence) {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.message = sentence;
  verdict.block = motion.record.block;
  verdict.record = motion.number;
  verdict.want = step_text(step.what);
  verdict.got = record_text(motion.record);
  verdict.witness = place_text(motion.to());
  Motion stay;
  stay.from = stay.record.to = step.place;
  stay.record.kind = RecordKind::feed;
  try {
    const Curve place(stay, tolerances);
    const Apart far = place.farthest(place.apart({}, motion), {}, motion);
    verdict.witness = place_text(far.at);
    tell_distance(verdict, far.distance, far.at, step.place, tolerances.tolerance);
  } catch (const exact::Undecided&) {
  }
  return verdict;
}

}  // namespace

Verdict before_renaming(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances) {
  return undue(motion, step, tolerances,
               "The subject moves where the position gets another name, and no motion is due.");
}

Verdict motion_too_many(const Motion& motion, const ReferenceSteps::Step& step,
                        const Tolerances& tolerances) {
  const bool alarms = std::holds_alternative<reference::AlarmReport>(step.what);
  const bool dwells = dwell_of(step.what) != nullptr;
  Verdict verdict =
      undue(motion, step, tolerances,
            alarms   ? "The subject moves before the block that alarms, and no motion is due."
            : dwells ? "The subject moves where a dwell is due."
                     : "All motions of the program have come, and the subject makes another one.");
  verdict.clause = clause_of(step.what);
  if (dwells) {
    verdict.rule = RelationRule::event;
    // A motion of a later block comes for want of the dwell.
    verdict.block = std::min(verdict.block, block_of(step.what));
  }
  if (!alarms && !dwells) verdict.kind = VerdictKind::fail_overrun;
  return verdict;
}

Verdict motion_for_m_function(const DueMFunction& due, const Motion& motion,
                              const ReferenceSteps::Step& step, const Tolerances& tolerances) {
  Verdict verdict = undue(motion, step, tolerances,
                          "The subject moves where an M function is due, and no motion.");
  verdict.clause = due.record.clause;
  verdict.rule = RelationRule::event;
  verdict.want = record_text(due.record);
  return verdict;
}

Verdict m_function_for_dwell(const ReferenceStep& due, const Record& got, std::size_t number) {
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.rule = RelationRule::event;
  verdict.clause = clause_of(due);
  verdict.block = block_of(due);
  verdict.record = number;
  verdict.want = step_text(due);
  verdict.got = record_text(got);
  verdict.message = "An M function comes where a dwell is due.";
  return verdict;
}

namespace {

// How far a number of the subject's may be from what it computed.
Number rounding(const Number& number, const std::optional<Number>& resolution,
                const Tolerances& tolerances) {
  if (resolution) return *resolution / 2;
  return tolerances.binary64 ? abs(number) * Number::binary(1, 1 - kUlpBits) : Number(0);
}

// For a feed or a lead that differs: both values.
std::string values_of(const Motion& want, const Record& got) {
  if (want.record.kind == RecordKind::thread) {
    return reference::with_values(" It is {} mm in place of {}.", {got.lead, want.record.lead});
  }
  return feed_in_place_of(got, want);
}

// What it may come from.
std::string unit_error_of(const Motion& motion, const Record& got, const Tolerances& tolerances) {
  const Record& want = motion.record;
  if (want.kind == RecordKind::thread) {
    return unit_error(Quantity::lead, want.lead, got.lead,
                      rounding(got.lead, tolerances.resolution, tolerances));
  }
  if (want.feed_mode != got.feed_mode) return {};
  return unit_error(turns_alone(want, motion.from) ? Quantity::rotary_feed : Quantity::feed,
                    want.feed, got.feed,
                    rounding(got.feed, tolerances.feed_resolution, tolerances));
}

}  // namespace

bool is_dwell_due(const ReferenceStep& step, const Record& dwell, const Tolerances& tolerances) {
  const Record* want = dwell_of(step);
  if (want == nullptr || dwell.kind != RecordKind::dwell) return false;
  if (tolerances.compare_blocks && want->block != dwell.block) return false;
  return times_agree(*want, dwell, tolerances);
}

namespace {

// J-CMP-12, of one that is not due at step `number`.
VerdictKind kind_of_dwell(const Record& dwell, std::size_t number, ReferenceSteps& steps,
                          const Tolerances& tolerances) {
  for (std::size_t i = number; i < number + kLookAhead; ++i) {
    const ReferenceStep& step = steps.at(i).what;
    if (is_end(step)) break;
    if (is_dwell_due(step, dwell, tolerances)) return VerdictKind::fail_order;
  }
  const Record* want = dwell_of(steps.at(number).what);
  const bool is_of_block =
      want != nullptr && (!tolerances.compare_blocks || want->block == dwell.block);
  return is_of_block ? VerdictKind::fail_feed : VerdictKind::fail_geometry;
}

}  // namespace

// J-CMP-12: a dwell is due behind the motion that the subject has left unfinished.
Verdict wrong_dwell(const Record& dwell, std::size_t number, const Hypothesis& from,
                    ReferenceSteps& steps, const Tolerances& tolerances) {
  const ReferenceStep& step = steps.at(from.step).what;
  if (std::holds_alternative<Motion>(step) && from.piece) {
    const ReferenceStep& behind = steps.at(from.step + from.joined + 1).what;
    if (dwell_of(behind) != nullptr) return short_of(from, tolerances);
  }
  const Record* want = dwell_of(step);
  Verdict verdict;
  verdict.kind = kind_of_dwell(dwell, from.step, steps, tolerances);
  if (verdict.kind != VerdictKind::fail_feed) verdict.rule = RelationRule::event;
  verdict.record = number;
  verdict.block = dwell.block;
  verdict.got = record_text(dwell);
  verdict.want = step_text(step);
  verdict.clause = clause_of(step);
  if (verdict.kind == VerdictKind::fail_order) {
    verdict.message = "A later dwell comes here: what is due before it is missing, or comes later.";
  } else if (want == nullptr) {
    verdict.message = "The subject dwells where no dwell is due.";
  } else if (verdict.kind != VerdictKind::fail_feed) {
    verdict.message = "The dwell belongs to another block.";
  } else {
    verdict.message = reference::with_values("The dwell differs. It is {} s in place of {}.",
                                             {dwell.seconds, want->seconds});
    verdict.message += unit_error(Quantity::dwell, want->seconds, dwell.seconds,
                                  rounding(dwell.seconds, tolerances.resolution, tolerances));
  }
  return verdict;
}

namespace {

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
  verdict.kind = VerdictKind::fail_geometry;
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
  Verdict verdict;
  verdict.clause = want.record.clause;
  verdict.block = departing_block(refutation, steps);
  verdict.record = motion.number;
  verdict.want = record_text(want.record);
  verdict.got = record_text(motion.record);
  verdict.message = answer.reason;
  if (answer.departure == Departure::feed) {
    verdict.kind = VerdictKind::fail_feed;
    verdict.word = 'F';
    verdict.message += values_of(want, motion.record);
    verdict.message += unit_error_of(want, motion.record, tolerances);
  } else {
    explain_path(refutation, steps, tolerances, verdict);
  }
  return verdict;
}

}  // namespace gonogo::oracle
