// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/program_judge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "oracle/judge/mismatch.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

ProgramJudge::ProgramJudge(const reference::Profile& profile, const ProgramText& program,
                           const Tolerances& tolerances, const AssignmentSet* watched,
                           Forking forking)
    : profile_(profile),
      tolerances_(tolerances),
      program_(program),
      reference_(profile_, program_, tolerances_, watched, forking),
      alignment_(reference_, profile_.initial.at, tolerances_, memory_),
      budget_(profile_, program),
      step_progress_(tolerances_.tolerance) {}

void ProgramJudge::decide(std::optional<Verdict> verdict) {
  if (!verdict_) verdict_ = std::move(verdict);
}

// For people; empty: it is not known.
std::string ProgramJudge::wanted_at(std::size_t number) const {
  const ReferenceSteps::Step* const step = reference_.known(number);
  return step == nullptr ? std::string() : step_text(step->what);
}

// For people: records without lines keep the step from having one.
void ProgramJudge::name_line(Verdict& verdict, std::size_t number) const {
  if (verdict.block != 0 || decision(verdict.kind) != Decision::no_go || verdict.want.empty())
    return;
  const ReferenceSteps::Step* const step = reference_.known(number);
  if (step == nullptr || step_text(step->what) != verdict.want) return;
  verdict.block = verdict.kind == VerdictKind::fail_overrun ? step->left_block : step->block;
}

void ProgramJudge::decide_departure() {
  if (alignment_.gap()) return decide(alignment_.gap());
  Refutation& refutation = alignment_.refutation();
  const ReferenceSteps::Step& due = reference_.at(refutation.from.step);
  departed_at_ = due.item;
  departed_block_ = due.block;
  std::optional<Verdict> known = known_verdict(refutation, tolerances_);
  is_unexplained_ = !known;
  if (known) {
    name_line(*known, refutation.from.step);
  } else {
    // All that is said where an enclosure's width keeps the rest open.
    const bool is_feed = refutation.answer.departure == Departure::feed;
    known.emplace().kind = is_feed ? VerdictKind::fail_feed : VerdictKind::fail_geometry;
    known->message = refutation.answer.reason;
    known->clause = refutation.from.curve->motion().record.clause;
    known->record = refutation.motion->number;
  }
  decide(std::move(known));
  if (verdict_->kind != VerdictKind::fail_geometry) return;
  surplus_ = surplus_of(refutation, reference_, tolerances_);
  other_order_ = std::move(refutation.other_order);
}

// It takes longer than to find the departure, and of most forks nobody asks.
void ProgramJudge::explain_departure() {
  if (!std::exchange(is_unexplained_, false)) return;
  const Refutation& refutation = alignment_.refutation();
  verdict_ = explain(refutation, reference_, tolerances_);
  name_line(*verdict_, refutation.from.step);
}

bool ProgramJudge::record(const Record& record) {
  if (verdict_) {
    if (other_order_.shows) look_for_order(record);
    return !is_decided();
  }
  ++records_;
  try {
    if (!budget_.allows(records_, reference_.items_and_passes())) {
      decide_too_many(record);
    } else if (!equal_record(record)) {
      take_record(record);
    }
  } catch (const exact::Undecided& undecided) {
    decide(undecided_verdict(undecided));
  }
  return !is_decided();
}

void ProgramJudge::look_for_order(const Record& record) try {
  if (other_order_.shows(record)) {
    const std::uint64_t block = verdict_->block;
    if (other_order_.verdict) verdict_ = std::move(other_order_.verdict);
    if (verdict_->block == 0) verdict_->block = block;
    verdict_->kind = VerdictKind::fail_order;
    verdict_->message = other_order_.message;
    other_order_ = {};
  } else if (++looked_at_ == kLookAhead) {
    other_order_ = {};
  }
} catch (const exact::Undecided&) {  // whether this one shows it stays open
}

void ProgramJudge::decide_too_many(const Record& record) {
  Verdict verdict = verdict_on(
      VerdictKind::fail_overrun, record, records_ - 1,
      fmt::format("The subject sent {} records: of those that make no progress more than ten times "
                  "the records of the reference and 1,000.",
                  records_));
  verdict.rule = RelationRule::correspondence;
  const auto& followed = alignment_.hypotheses();
  if (!followed.empty()) verdict.want = wanted_at(followed.front().step);
  decide(std::move(verdict));
}

// R1, R5.
void ProgramJudge::take_record(const Record& record) {
  if (end_record_) {
    return decide(verdict_on(VerdictKind::fail_overrun, record, records_ - 1,
                             "A record follows the end of the trace."));
  }
  switch (record.kind) {
    case RecordKind::m:
      if (tolerances_.compare_m && has_line(record)) take_m_function(record);
      return;
    case RecordKind::dwell:
      if (record.seconds.sign() != 0 && has_line(record)) take_dwell(record);
      return;
    case RecordKind::end:
      end_record_ = record;
      return;
    default:
      if (has_line(record)) take_motion(record);
  }
}

// R3.
bool ProgramJudge::has_line(const Record& record) {
  if (!tolerances_.compare_blocks || record.block != 0) return true;
  decide(verdict_on(VerdictKind::protocol, record, records_ - 1,
                    "The subject declares the feature `blocks`, but this record has no `b`."));
  return false;
}

void ProgramJudge::take_motion(const Record& record) {
  if (budget_.runs_low(records_, reference_.items_and_passes())) {
    ++idle_;
    if (makes_progress()) budget_.forgive(std::exchange(idle_, 0));
  }
  has_acted_ = true;
  if (!alignment_.take_motion(record, records_ - 1)) return decide_departure();
  const Forgiven forgiven = alignment_.take_forgiven();
  budget_.forgive(forgiven.records);
  budget_.count_level_cuts(forgiven.level_cuts);
  forget_passed();
}

// Equal motions between two of them do not come this far: it is for each record that goes the whole
// way to forget, or a program of motions and dwells in turn would be kept whole.
void ProgramJudge::forget_passed() {
  if (verdict_) return;  // there may be no hypothesis left
  reference_.forget_before(alignment_.first_step());
}

// R5.
void ProgramJudge::take_m_function(const Record& record) {
  has_acted_ = true;
  switch (alignment_.take_m_function(record, records_ - 1)) {
    case Alignment::MFunction::taken:
      return forget_passed();
    case Alignment::MFunction::of_alarm:
      return m_functions_of_alarm_.push_back({record, records_ - 1});
    case Alignment::MFunction::departs:
      return decide_departure();
  }
}

void ProgramJudge::take_dwell(const Record& record) {
  has_acted_ = true;
  if (!alignment_.take_dwell(record, records_ - 1)) decide_departure();
  forget_passed();
}

// J-CYC-02: whether the records so far came nearer to the end of the reference's straight motion,
// farther round its arc, or to a place where the tool has not been on an arc or a free step. By the
// way that is least far, for it never goes back to a step before.
bool ProgramJudge::makes_progress() {
  const Hypothesis& last =
      *std::ranges::min_element(alignment_.hypotheses(), {}, &Hypothesis::step);
  const ReferenceSteps::Step& step = reference_.at(last.step);
  step_progress_.enter(step.item);
  if (const auto* alone = std::get_if<Motion>(&step.what)) {
    const Motion& want = last.curve ? last.curve->motion() : *alone;
    if (!is_round(want.record.kind)) {
      return step_progress_.comes_nearer(last.at, want.to(), last.joined);
    }
    if (want.record.kind == RecordKind::arc) {
      const double radius = estimate_length(from_centre(want.record, last.at));
      if (step_progress_.goes_round(last.progress.arc, radius)) return true;
    }
  } else if (const auto* level = std::get_if<reference::PocketLevel>(&step.what)) {
    if (!is_in_pocket(last.at, *level)) return false;
  } else if (!is_free_step(step.what)) {
    return false;
  }
  return step_progress_.is_new_place(last.at);
}

}  // namespace gonogo::oracle
