// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/alignment.hpp"

#include <algorithm>

#include "oracle/judge/curve_follower.hpp"
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/places.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;
using reference::Renaming;

namespace {

// J-CONST-06.
constexpr std::size_t kMostHypotheses = 128;
constexpr std::size_t kMostPassed = 100'000;
constexpr std::size_t kMostPassedForSmall = 128;

Verdict gap_verdict(std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.message = std::move(message);
  return verdict;
}

bool moves_nothing(const Motion& motion) {
  return agree(motion.from, motion.to(), 0) && !goes_round(motion, 0);
}

// What the hypothesis follows of its step.
const Motion& wanted(const Hypothesis& from, const ReferenceSteps::Step& step) {
  return from.curve ? from.curve->motion() : std::get<Motion>(step.what);
}

}  // namespace

Alignment::Alignment(ReferenceSteps& steps, const Position& start, const JudgeTerms& terms,
                     OpenStepMemory& memory)
    : steps_(steps), terms_(terms), memory_(memory), hypotheses_(1) {
  hypotheses_.front().at = hypotheses_.front().anchor = start;
}

std::size_t Alignment::first_step() const {
  std::size_t first = hypotheses_.front().step;
  for (const Hypothesis& each : hypotheses_) first = std::min(first, each.step);
  return first;
}

bool Alignment::take_motion(const Record& record, std::size_t number) {
  farthest_.reset();
  Stage stage;
  stage.branches = hypotheses_.size() > 1;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    Motion motion = motion_from(from.at, record, number);
    if (record.kind == RecordKind::arc3) motion = straightened(std::move(motion));
    if (!terms_.compare_blocks) motion.record.block = 0;  // J-CMP-10
    walk(std::move(from), std::move(motion), stage);
  }
  return finish(std::move(stage.reached));
}

bool Alignment::take_dwell(const Record& record, std::size_t number) {
  if (!settle()) return false;
  farthest_.reset();
  std::vector<Hypothesis> reached;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    if (meet_dwell(from, record, number)) keep(std::move(from), reached);
  }
  return finish(std::move(reached));
}

bool Alignment::settle() {
  if (std::ranges::none_of(hypotheses_, [](const auto& each) { return each.waiting.has_value(); })) {
    return true;
  }
  farthest_.reset();
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

// A hypothesis that is given up for a doubt may be right, until all others are past its step.
bool Alignment::finish(std::vector<Hypothesis> reached) {
  if (reached.size() > kMostHypotheses) {
    doubt(reached.front().step, gap_verdict("The motions may be meant in too many ways."));
    reached.clear();
  }
  hypotheses_ = std::move(reached);
  if (hypotheses_.empty()) return false;
  if (gap_ && first_step() > gap_step_) gap_.reset();
  return true;
}

void Alignment::doubt(std::size_t step, Verdict gap) {
  if (gap_) return;
  gap_ = std::move(gap);
  gap_step_ = step;
}

void Alignment::refute(Refutation refutation) {
  if (refutation.answer.departure == Departure::undecided) {
    return doubt(refutation.from.step, gap_verdict(std::move(refutation.answer.reason)));
  }
  if (refutation.verdict && refutation.verdict->kind == VerdictKind::oracle_gap) {
    return doubt(refutation.from.step, *std::move(refutation.verdict));
  }
  const bool is_farther = !farthest_ || refutation.from.step > farthest_->from.step;
  if (is_farther) farthest_ = std::move(refutation);
}

void Alignment::refute(Hypothesis from, const Motion& motion, Verdict verdict) {
  refute(Refutation{std::move(from), motion, {}, std::move(verdict)});
}

// Two that have come equally far are one.
void Alignment::keep(Hypothesis hypothesis, std::vector<Hypothesis>& reached) {
  for (Hypothesis& other : reached) {
    if (other.step != hypothesis.step || other.open || hypothesis.open) continue;
    if (other.is_fresh() != hypothesis.is_fresh() || other.joined != hypothesis.joined) continue;
    if (!other.is_fresh() && !goes_on_alike(other.progress, hypothesis.progress)) continue;
    other.exact = other.exact || hypothesis.exact;
    other.rounded = other.rounded || hypothesis.rounded;
    if (!hypothesis.advice) other.advice.reset();
    return;
  }
  reached.push_back(std::move(hypothesis));
}

// J-CMP-03: the motion leads nowhere.
void Alignment::stay(Hypothesis from, const Motion& motion, Stage& stage) {
  from.at = motion.to();
  keep(std::move(from), stage.reached);
}

void Alignment::walk(Hypothesis from, Motion motion, Stage& stage) {
  const bool is_small = stays_at(from.at, motion, terms_);
  for (std::size_t passed = 0;; ++passed) {
    if (stage.branches && from.is_fresh() && !stage.seen.insert(from.step).second) return;
    if (is_small && passed > kMostPassedForSmall) return;
    if (passed > kMostPassed) {
      return doubt(from.step, gap_verdict("More than 100,000 motions in a row are too small to see."));
    }
    // A way that cannot be told is given up; what was found before it stands.
    const std::size_t here = from.step;
    try {
      if (!meet(from, motion, stage)) return;
    } catch (const exact::Undecided& undecided) {
      return doubt(here, undecided_verdict(undecided));
    }
  }
}

bool Alignment::meet(Hypothesis& from, Motion& motion, Stage& stage) {
  const ReferenceStep& what = step_of(from).what;
  if (from.after_alarm) {
    stay(std::move(from), motion, stage);
    return false;
  }
  if (std::holds_alternative<Motion>(what)) return meet_motion(from, motion, stage);
  if (std::holds_alternative<Renaming>(what)) return meet_renaming(from, motion, stage);
  if (auto* outside = std::get_if<NotCovered>(&what)) {
    meet_outside(std::move(from), motion, *outside, stage);
  } else if (std::holds_alternative<Record>(what) || std::holds_alternative<AlarmReport>(what)) {
    meet_last(std::move(from), motion, stage);
  } else {
    meet_open_step(std::move(from), std::move(motion), stage);
  }
  return false;
}

void Alignment::meet_outside(Hypothesis from, const Motion& motion, const NotCovered& outside,
                             Stage& stage) {
  if (leads_nowhere(from, motion, step_of(from).place)) return stay(std::move(from), motion, stage);
  doubt(from.step, not_covered_verdict(outside));
}

// J-CMP-03: it keeps to where the reference stands, and to where the subject's last motion that led
// anywhere ended.
bool Alignment::leads_nowhere(const Hypothesis& from, const Motion& motion,
                              const Position& place) const {
  return stays_at(place, motion, terms_) && stays_at(from.anchor, motion, terms_);
}

bool Alignment::can_pass(const Hypothesis& from, const Motion& want) const {
  return same_place(from.at, want.to(), terms_) && !goes_round(want, terms_.tolerance);
}

void Alignment::leave_motion(Hypothesis& from) {
  from.passed = steps_.at(from.step + from.joined).item;
  from.step += from.joined + 1;
  from.joined = 0;
  from.curve.reset();
  from.progress = {};
  from.piece.reset();
}

bool Alignment::meet_motion(Hypothesis& from, const Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (from.is_fresh() && is_same_motion(motion, wanted(from, step))) {
    leave_motion(from);
    from.at = from.anchor = motion.to();
    keep(std::move(from), stage.reached);
    return false;
  }
  const std::size_t before = stage.reached.size();
  const Hypothesis as_it_was = from;
  if (!from.curve) from.curve = steps_.curve_of(step);
  CurveAnswer answer = from.curve->follow(from.progress, motion);
  if (answer.departs()) extend(from, motion, answer);
  // J-CMP-03. What may lead nowhere is no piece of a line.
  const bool is_arc = is_round(from.curve->motion().record.kind);
  const bool departs = answer.departs();
  const bool is_between_pieces =
      !as_it_was.is_fresh() && departs && stays_at(as_it_was.anchor, motion, terms_);
  const bool is_nil =
      is_between_pieces ||
      ((as_it_was.is_fresh() || is_arc) && leads_nowhere(as_it_was, motion, step.place));
  const bool is_done = std::ranges::any_of(answer.ways, [](const auto& way) { return way.done; });
  if (is_done || (!departs && (is_arc || !is_nil))) {
    if (take_ways(from, motion, std::move(answer), stage)) return false;
    if (is_done) take_longer_end(from, motion, stage);
  }
  if (is_nil && !is_done) stay(as_it_was, motion, stage);
  // Of an earlier block it passes nothing of this one.
  const Motion& want = wanted(as_it_was, step);
  const bool is_earlier = terms_.compare_blocks && motion.record.block < want.record.block;
  if (!is_earlier && can_pass(as_it_was, want)) {
    from = as_it_was;
    leave_motion(from);
    return true;
  }
  if (stage.reached.size() == before && departs) depart(from, motion, std::move(answer), stage);
  return false;
}

// J-CMP-04: joins steps that go on as the motion does, as far as it goes.
bool Alignment::extend(Hypothesis& from, const Motion& motion, CurveAnswer& answer) {
  Hypothesis longer = from;
  while (longer.curve->goes_beyond(longer.progress, motion)) {
    const auto* next = std::get_if<Motion>(&steps_.at(longer.step + longer.joined + 1).what);
    if (next == nullptr) return false;
    ++longer.joined;
    if (moves_nothing(*next)) continue;
    Motion both = longer.curve->motion();
    if (!join(both, *next)) return false;
    longer.curve = std::make_shared<Curve>(std::move(both), terms_);
    CurveAnswer further = longer.curve->follow(longer.progress, motion);
    if (further.departs()) continue;
    from = std::move(longer);
    answer = std::move(further);
    return true;
  }
  return false;
}

// True where it is the end of the step to the last digit: then it is nothing else.
bool Alignment::take_ways(const Hypothesis& from, const Motion& motion, CurveAnswer answer,
                          Stage& stage) {
  const Motion& want = from.curve->motion();
  // Chords that are granted are bounded by the arc.
  const bool is_chord = is_round(want.record.kind) && motion.record.kind == RecordKind::feed;
  if (is_chord) ++forgiven_.records;
  bool is_exact = false;
  for (CurveWay& way : answer.ways) {
    Hypothesis next = from;
    next.at = next.anchor = motion.to();
    if (way.done) {
      const Grade grade = grade_of(motion, want, terms_);
      next.exact = next.exact && grade.exact;
      next.rounded = next.rounded && grade.rounded;
      is_exact = is_exact || grade.exact;
      leave_motion(next);
    } else {
      next.progress = std::move(way.progress);
      next.piece = motion;
    }
    keep(std::move(next), stage.reached);
  }
  return is_exact;
}

// A motion that ends a step may as well end the next one, which goes on from it by less than can be
// seen.
void Alignment::take_longer_end(const Hypothesis& from, const Motion& motion, Stage& stage) {
  const auto* next = std::get_if<Motion>(&steps_.at(from.step + from.joined + 1).what);
  if (next == nullptr || !same_place(next->to(), motion.to(), terms_)) return;
  Motion both = from.curve->motion();
  if (!join(both, *next)) return;
  Hypothesis longer = from;
  longer.curve = std::make_shared<Curve>(std::move(both), terms_);
  ++longer.joined;
  CurveAnswer answer = longer.curve->follow(longer.progress, motion);
  if (answer.departs() || take_ways(longer, motion, std::move(answer), stage)) return;
  take_longer_end(longer, motion, stage);
}

void Alignment::depart(const Hypothesis& from, const Motion& motion, CurveAnswer answer,
                       Stage& stage) {
  if (leads_outside(from, motion)) return;
  if (leads_into_open_step(from, motion, stage)) return;
  if (takes_coarse_centre(from, motion, answer, stage)) return;
  refute(Refutation{from, motion, std::move(answer), std::nullopt});
}

// Without line numbers a motion may be joined to those of a block that is not covered: then its end
// says nothing.
bool Alignment::leads_outside(const Hypothesis& from, const Motion& motion) {
  if (terms_.compare_blocks) return false;
  Hypothesis longer = from;
  while (longer.curve->goes_beyond(longer.progress, motion)) {
    const std::size_t next = longer.step + longer.joined + 1;
    const ReferenceStep& what = steps_.at(next).what;
    if (auto* outside = std::get_if<NotCovered>(&what)) {
      doubt(next, not_covered_verdict(*outside));
      return true;
    }
    Motion both = longer.curve->motion();
    if (!std::holds_alternative<Motion>(what) || !join(both, std::get<Motion>(what))) return false;
    longer.curve = std::make_shared<Curve>(std::move(both), terms_);
    ++longer.joined;
  }
  return false;
}

// A motion that leads to an open path and on into it: from there on its rest.
bool Alignment::leads_into_open_step(const Hypothesis& from, const Motion& motion, Stage& stage) {
  const Motion& want = from.curve->motion();
  if (!from.curve->goes_beyond(from.progress, motion)) return false;
  Hypothesis beyond = from;
  leave_motion(beyond);
  const ReferenceSteps::Step& next = steps_.at(beyond.step);
  if (!make_open_step(next, terms_, memory_) || block_of(next.what) != want.record.block) {
    return false;
  }
  begin_open_step(beyond);
  Motion rest = motion;
  for (const Axis axis : reference::kLinearAxes) {
    if (moved_axes(motion, 0).has(axis)) rest.from[axis] = want.to()[axis];
  }
  if (!beyond.open->may_begin_within(rest)) return false;
  beyond.at = beyond.anchor = rest.from;
  meet_open_step(std::move(beyond), std::move(rest), stage);
  return true;
}

// J-ALM-07. The centre that a control works out itself, within twice the tolerance of the right
// one: what follows is judged, for the arc ends where it should.
bool Alignment::takes_coarse_centre(const Hypothesis& from, const Motion& motion,
                                    const CurveAnswer& answer, Stage& stage) {
  std::optional<Verdict> advice =
      coarse_centre_advice(answer, motion, from.curve->motion(), terms_);
  if (!advice) return false;
  Hypothesis next = from;
  if (!next.advice) next.advice = std::move(advice);
  next.at = next.anchor = motion.to();
  leave_motion(next);
  keep(std::move(next), stage.reached);
  return true;
}

bool Alignment::meet_renaming(Hypothesis& from, Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  const auto& renaming = std::get<Renaming>(step.what);
  if (terms_.compare_blocks && motion.record.block <= renaming.block) {
    if (leads_nowhere(from, motion, step.place)) {
      stay(std::move(from), motion, stage);
    } else {
      refute(from, motion, before_renaming(motion, step.what));
    }
    return false;
  }
  if (!agree(motion.from, from.at, 0)) {
    doubt(from.step, gap_verdict("A motion of the subject spans a renaming of the position."));
    return false;
  }
  shift(from.at, renaming.shift);
  shift(from.anchor, renaming.shift);
  motion.from = from.at;
  for (const Axis axis : reference::kAllAxes) {
    if (!motion.record.axes.has(axis)) motion.record.to[axis] = from.at[axis];
  }
  ++from.step;
  return true;
}

// Where no motion is due: at a dwell, an alarm or the end.
void Alignment::meet_last(Hypothesis from, const Motion& motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (leads_nowhere(from, motion, step.place)) return stay(std::move(from), motion, stage);
  auto* report = std::get_if<AlarmReport>(&step.what);
  const bool is_earlier =
      report != nullptr && terms_.compare_blocks && motion.record.block < report->block;
  if (report != nullptr && !is_earlier) {
    from.after_alarm = motion;
    return stay(std::move(from), motion, stage);
  }
  refute(from, motion, motion_too_many(motion, from.step, steps_, terms_));
}

void Alignment::begin_open_step(Hypothesis& from) {
  from.open = make_open_step(step_of(from), terms_, memory_);
}

void Alignment::meet_open_step(Hypothesis from, Motion motion, Stage& stage) {
  const ReferenceSteps::Step& step = step_of(from);
  if (terms_.compare_blocks && motion.record.block > block_of(step.what)) {
    return meet_behind_open_step(std::move(from), std::move(motion), stage);
  }
  if (from.waiting && join(*from.waiting, motion)) {
    from.at = from.anchor = motion.to();
    return keep(std::move(from), stage.reached);
  }
  const bool is_begun = from.open != nullptr;
  if (!is_begun) begin_open_step(from);
  const bool is_earlier = terms_.compare_blocks && motion.record.block < block_of(step.what);
  const bool is_small = motion.record.kind != RecordKind::arc &&
                        stays_at(from.anchor, motion, terms_) && !from.open->sees(motion);
  const bool is_before = (is_earlier || from.open->is_before(motion)) &&
                         stays_at(step.place, motion, terms_);
  if (is_small || is_before) {
    if (!is_begun) from.open.reset();
    return stay(std::move(from), motion, stage);
  }
  if (from.waiting) {
    std::vector<Hypothesis> beyond;
    if (!take_waiting(from, beyond)) {
      for (Hypothesis& each : beyond) walk(std::move(each), motion, stage);
      return;
    }
  }
  from.at = from.anchor = motion.to();
  from.waiting = std::move(motion);
  keep(std::move(from), stage.reached);
}

// With a motion of a later block the path has ended where the subject stands.
void Alignment::meet_behind_open_step(Hypothesis from, Motion motion, Stage& stage) {
  std::vector<Hypothesis> reached;
  if (!from.waiting || take_waiting(from, reached)) {
    const Passing passing = pass(from);
    if (!passing.passed) {
      const bool is_nil = motion.record.kind != RecordKind::arc &&
                          stays_at(from.anchor, motion, terms_) &&
                          !from.open->is_judged_when_left();
      if (is_nil) return stay(std::move(from), motion, stage);
      if (passing.why_not) refute(from, motion, *passing.why_not);
      return;
    }
    reached.push_back(std::move(from));
  }
  for (Hypothesis& each : reached) walk(std::move(each), motion, stage);
}

bool Alignment::take_waiting(Hypothesis& from, std::vector<Hypothesis>& reached) {
  Motion motion = *std::exchange(from.waiting, std::nullopt);
  // A flat `arc3` is an arc by another name.
  if (motion.record.kind == RecordKind::arc3) motion = as_arc(motion).value_or(motion);
  OpenStepAnswer answer = from.open->take(motion);
  if (answer.is_decided()) {
    refute(std::move(from), motion, std::move(answer.verdict));
    return false;
  }
  const bool is_ended = answer.kind == OpenStepAnswer::Kind::ended;
  // J-CMP-09: a motion counts where an open step has taken it, or its first part.
  if (!is_ended || !agree(answer.here, motion.from, terms_.tolerance)) ++from.property_motions;
  if (!is_ended) {
    if (answer.cost == OpenStepAnswer::Cost::free) ++forgiven_.records;
    if (answer.cost == OpenStepAnswer::Cost::level_cut) ++forgiven_.level_cuts;
    return true;
  }
  if (!leave_open_step(from, answer.here)) return false;
  motion.from = answer.here;
  Stage stage;
  walk(std::move(from), std::move(motion), stage);
  reached = std::move(stage.reached);
  return false;
}

bool Alignment::leave_open_step(Hypothesis& from, const Position& here) {
  const OpenStep::Exit exit = from.open->exit(here);
  if (!steps_.go_on_from(from.step, exit.at, exit.moves_machine)) {
    doubt(from.step, gap_verdict("The motions of an open path may be meant in several ways."));
    return false;
  }
  from.open.reset();
  from.waiting.reset();
  from.at = from.anchor = here;
  ++from.step;
  return true;
}

Alignment::Passing Alignment::pass(Hypothesis& from) {
  const ReferenceSteps::Step& step = step_of(from);
  if (std::holds_alternative<Motion>(step.what)) {
    if (!can_pass(from, wanted(from, step))) return {};
    leave_motion(from);
    return {true};
  }
  if (auto* renaming = std::get_if<Renaming>(&step.what)) {
    shift(from.at, renaming->shift);
    shift(from.anchor, renaming->shift);
    ++from.step;
    return {true};
  }
  OpenStep* open = open_step_of(from);
  if (open == nullptr) return {};
  if (std::optional<Verdict> why_not = open->end(from.at)) return {false, std::move(why_not)};
  return {leave_open_step(from, from.at)};
}

OpenStep* Alignment::open_step_of(Hypothesis& from) {
  if (!from.open) begin_open_step(from);
  return from.open.get();
}

void Alignment::skip(Hypothesis& from) {
  from.step += from.joined + 1;
  from.joined = 0;
  from.curve.reset();
  from.piece.reset();
  from.open.reset();
}

// J-CMP-06.
bool Alignment::meet_dwell(Hypothesis& from, const Record& record, std::size_t number) {
  if (from.after_alarm) return true;
  Passing passing{true};
  for (std::size_t passed = 0; passing.passed; ++passed) {
    if (passed > kMostPassed) {
      doubt(from.step, gap_verdict("More than 100,000 motions in a row are too small to see."));
      return false;
    }
    const ReferenceStep& what = step_of(from).what;
    if (auto* outside = std::get_if<NotCovered>(&what)) {
      doubt(from.step, not_covered_verdict(*outside));
      return false;
    }
    if (std::holds_alternative<AlarmReport>(what)) {
      from.after_alarm = motion_from(from.at, record, number);
      return true;
    }
    if (is_dwell_due(what, record, terms_)) {
      ++from.step;
      return true;
    }
    passing = pass(from);
  }
  if (passing.why_not && from.open->is_judged_when_left()) {
    refute(Refutation{from, std::nullopt, {}, std::move(passing.why_not)});
    return false;
  }
  Verdict verdict = wrong_dwell(record, number, from, steps_);
  refute(Refutation{from, std::nullopt, {}, std::move(verdict)});
  return false;
}

}  // namespace gonogo::oracle
