// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/alignment.hpp"

#include <algorithm>

#include "oracle/judge/mismatch.hpp"
#include "oracle/motion/curve_follower.hpp"
#include "oracle/motion/places.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;
using reference::Renaming;

Alignment::Alignment(ReferenceSteps& steps, const Position& start, const Tolerances& tolerances,
                     FreeStepMemory& memory)
    : steps_(steps), tolerances_(tolerances), memory_(memory), hypotheses_(1) {
  hypotheses_.front().at = hypotheses_.front().anchor = start;
}

std::size_t Alignment::first_step() const {
  std::size_t first = hypotheses_.front().step;
  for (const Hypothesis& each : hypotheses_) first = std::min(first, each.step);
  return first;
}

bool Alignment::take_motion(const Record& record, std::size_t number) {
  farthest_.reset();
  own_.reset();
  Stage stage;
  stage.branches = hypotheses_.size() > 1;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    Motion motion = motion_from(from.at, record, number);
    if (record.kind == RecordKind::arc3) motion = straightened(std::move(motion));
    if (!tolerances_.compare_blocks) motion.record.block = 0;  // R3
    walk(std::move(from), std::move(motion), stage);
  }
  return finish(std::move(stage.reached));
}

bool Alignment::settle() {
  if (std::ranges::none_of(hypotheses_,
                           [](const auto& each) { return each.waiting.has_value(); })) {
    return true;
  }
  farthest_.reset();
  own_.reset();
  std::vector<Hypothesis> reached;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    std::vector<Hypothesis> beyond;
    if (!from.waiting || take_waiting(from, beyond)) {
      keep(std::move(from), reached);
      continue;
    }
    for (Hypothesis& each : beyond) keep(std::move(each), reached);
  }
  if (!finish(std::move(reached))) return false;
  return settle();
}

// A hypothesis that is given up undecided may be right, until all others are past its step.
bool Alignment::finish(std::vector<Hypothesis> reached) {
  if (reached.size() > kMostHypotheses) {
    leave_undecided(reached.front().step,
                    gap_verdict(GapReason::cap_ways, "The motions may be meant in too many ways."));
    reached.clear();
  }
  hypotheses_ = std::move(reached);
  if (hypotheses_.empty()) return false;
  if (gap_ && first_step() > gap_step_) gap_.reset();
  return true;
}

void Alignment::leave_undecided(std::size_t step, Verdict gap) {
  if (gap_) return;
  gap_ = std::move(gap);
  gap_step_ = step;
}

// R9.
bool Alignment::passes_too_many(const Hypothesis& from, std::size_t passed) {
  if (passed <= kMostSmall) return false;
  leave_undecided(from.step, gap_verdict(GapReason::cap_small, kTooManySmall));
  return true;
}

void Alignment::refute(Refutation refutation) {
  if (refutation.answer.departure == Departure::undecided) {
    return leave_undecided(refutation.from.step,
                           gap_verdict(refutation.answer.gap, std::move(refutation.answer.reason)));
  }
  if (refutation.verdict && refutation.verdict->kind == VerdictKind::oracle_gap) {
    return leave_undecided(refutation.from.step, *std::move(refutation.verdict));
  }
  const bool is_farther = !farthest_ || refutation.from.step > farthest_->from.step;
  const bool is_own = farthest_ && farthest_->may_be_passed && refutation.is_of_other_block();
  if (refutation.may_be_passed) keep_own(refutation);
  if (!is_farther || is_own) return;
  farthest_ = refutation.is_undue && own_ ? *own_ : std::move(refutation);
}

// J-CMP-12: where no motion is due any more, the one that came stands for the first of its block
// that it may be and that was omitted. Not for one whose kind rounding decides.
void Alignment::keep_own(const Refutation& refutation) try {
  const auto is_of_kind = [](const Refutation& one) {
    return one.answer.departure != Departure::kind;
  };
  const bool is_better = !own_ || (!is_of_kind(*own_) && is_of_kind(refutation));
  const Motion& want = refutation.from.curve->motion();
  if (is_better && !hangs_on_rounding(want, tolerances_.tolerance)) own_ = refutation;
} catch (const exact::Undecided&) {  // it may be one
}

void Alignment::refute(Hypothesis from, Verdict verdict, OtherOrder other_order) {
  refute(Refutation{std::move(from), std::nullopt, {}, std::move(verdict), std::move(other_order)});
}

void Alignment::refute_undue(Hypothesis from, Verdict verdict, OtherOrder other_order) {
  Refutation undue{std::move(from), std::nullopt, {}, std::move(verdict), std::move(other_order)};
  undue.is_undue = true;
  refute(std::move(undue));
}

// Two that have come equally far are one.
void Alignment::keep(Hypothesis hypothesis, std::vector<Hypothesis>& reached) {
  for (Hypothesis& other : reached) {
    if (other.step != hypothesis.step || other.open || hypothesis.open) continue;
    if (other.is_fresh() != hypothesis.is_fresh() || other.joined != hypothesis.joined) continue;
    if (!other.is_fresh() && !goes_on_alike(other.progress, hypothesis.progress)) continue;
    if (hypothesis.coordinates.inexact() < other.coordinates.inexact()) {
      other.coordinates = hypothesis.coordinates;
    }
    other.exact = other.exact || hypothesis.exact;
    other.rounded = other.rounded || hypothesis.rounded;
    if (!hypothesis.instead) other.instead.reset();
    return;
  }
  reached.push_back(std::move(hypothesis));
}

// R3: the motion is negligible.
void Alignment::stay(Hypothesis from, const Motion& motion, Stage& stage) {
  from.at = motion.to();
  keep(std::move(from), stage.reached);
}

void Alignment::walk(Hypothesis from, Motion motion, Stage& stage) {
  const bool is_small = stays_at(from.at, motion, tolerances_);
  for (std::size_t passed = 0;; ++passed) {
    if (stage.branches && from.is_fresh() && !stage.seen.insert(from.step).second) return;
    if (is_small && passed > kMostHypotheses) return;
    if (passes_too_many(from, passed)) return;
    // A way that cannot be decided is given up; what was found before it stands.
    const std::size_t here = from.step;
    try {
      if (!meet(from, motion, stage)) return;
    } catch (const exact::Undecided& undecided) {
      return leave_undecided(here, undecided_verdict(undecided));
    }
  }
}

bool Alignment::meet(Hypothesis& from, Motion& motion, Stage& stage) {
  const ReferenceStep& what = step_of(from).what;
  if (from.after_alarm) {
    stay(std::move(from), motion, stage);
    return false;
  }
  if (waits_for_m_function(from, motion, stage)) return false;
  if (std::holds_alternative<Motion>(what)) return meet_motion(from, motion, stage);
  if (std::holds_alternative<Renaming>(what)) return meet_renaming(from, motion, stage);
  if (auto* outside = std::get_if<NotCovered>(&what)) {
    if (!is_negligible(from, motion, step_of(from).place)) {
      leave_undecided(from.step, not_covered_verdict(*outside));
    } else {
      stay(std::move(from), motion, stage);
    }
  } else if (std::holds_alternative<Record>(what) || std::holds_alternative<AlarmReport>(what)) {
    return meet_last(from, motion, stage);
  } else {
    meet_free_step(std::move(from), std::move(motion), stage);
  }
  return false;
}

// R3: it keeps to where the reference stands, and to where the subject's last motion that led
// anywhere ended, or goes on from there.
bool Alignment::is_negligible(const Hypothesis& from, const Motion& motion,
                              const Position& place) const {
  return stays_at(place, motion, tolerances_) && (stays_at(from.anchor, motion, tolerances_) ||
                                                  (from.is_fresh() && ends_left(from, motion)));
}

// R1. A piece before it came within the tolerance of the end; this one may end beyond it.
bool Alignment::ends_left(const Hypothesis& from, const Motion& motion) const {
  return from.left && stays_at(from.left->motion().to(), motion, tolerances_) &&
         !from.left->follow(from.left_progress, motion).departs();
}

bool Alignment::can_pass(const Hypothesis& from, const Motion& want) const {
  return same_place(from.at, want.to(), tolerances_) && !goes_round(want, tolerances_.tolerance);
}

void Alignment::leave_motion(Hypothesis& from) {
  from.passed = steps_.at(from.step + from.joined).item;
  from.step += from.joined + 1;
  from.joined = 0;
  from.left = std::exchange(from.curve, nullptr);
  from.left_progress = std::exchange(from.progress, {});
  from.piece.reset();
}

// R5. From elsewhere: behind the renaming it would be too small to see, and none such is due there.
bool Alignment::leads_to_new_name(const Hypothesis& from, const Motion& motion) {
  Position name = motion.from;
  shift(name, std::get<Renaming>(step_of(from).what).shift);
  if (same_place(motion.from, motion.to(), tolerances_) ||
      !same_place(motion.to(), name, tolerances_)) {
    return false;
  }
  const auto* due = std::get_if<Motion>(&steps_.at(from.step + 1).what);
  return due == nullptr || !stays_at(due->from, *due, tolerances_);
}

bool Alignment::meet_renaming(Hypothesis& from, Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  const auto& renaming = std::get<Renaming>(step.what);
  const bool is_before = tolerances_.compare_blocks ? motion.record.block <= renaming.block
                                                    : leads_to_new_name(from, motion);
  if (is_before) {
    if (is_negligible(from, motion, step.place)) {
      stay(std::move(from), motion, stage);
    } else {
      refute(from, before_renaming(motion, step, tolerances_));
    }
    return false;
  }
  // Without lines, before the renaming or behind it.
  if (!tolerances_.compare_blocks && is_negligible(from, motion, step.place)) {
    stay(from, motion, stage);
  }
  if (!same_place(motion.from, from.at, tolerances_)) {
    leave_undecided(from.step,
                    gap_verdict(GapReason::two_readings,
                                "A motion of the subject spans a renaming of the position."));
    return false;
  }
  from.at = motion.from;  // negligible motions may have been omitted before it
  shift(from.at, renaming.shift);
  shift(from.anchor, renaming.shift);
  motion.from = from.at;
  for (const Axis axis : reference::kAllAxes) {
    if (!motion.record.axes.has(axis)) motion.record.to[axis] = from.at[axis];
  }
  ++from.step;
  return true;
}

bool Alignment::go_on_behind_end(Hypothesis& hypothesis, Verdict departure) {
  if (!is_silent_end(step_of(hypothesis).what)) return false;
  departure = advised(std::move(departure), tolerances_);
  if (departure.kind != VerdictKind::advice) return false;
  if (!hypothesis.instead) hypothesis.instead = std::move(departure);
  ++hypothesis.step;
  return true;
}

// Where no motion is due: at a dwell, an alarm or the end. True: behind the end, or the dwell.
bool Alignment::meet_last(Hypothesis& from, const Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (is_negligible(from, motion, step.place)) {
    stay(from, motion, stage);
    return false;
  }
  if (may_be_none(step.what)) {
    ++from.step;
    return true;
  }
  auto* report = std::get_if<AlarmReport>(&step.what);
  if (report != nullptr && !is_of_earlier_block(motion.record, report->block)) {
    from.after_alarm = motion;
    stay(from, motion, stage);
    return false;
  }
  Verdict verdict = motion_too_many(motion, step, tolerances_);
  if (go_on_behind_end(from, verdict)) return true;
  refute_undue(from, std::move(verdict), late_dwell(step.what));
  return false;
}

}  // namespace gonogo::oracle
