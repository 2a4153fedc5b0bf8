// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's filter before everything that it does with motions. While the subject's records
// are the reference's own, and none is so small that it could be negligible, each of them is the
// whole of a step by every rule: it is enough to compare the records. The first that is anything
// else goes the whole way.
#include "oracle/judge/program_judge.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

bool ProgramJudge::line(std::string_view line) {
  if (!in_step_ || verdict_) return false;
  try {
    if (!plain_ahead() || !is_line_of(in_step_->next, line)) return false;
    ++records_;
    go_on();
  } catch (const exact::Undecided& undecided) {
    ++records_;
    decide(undecided_verdict(undecided));
  }
  return true;
}

bool ProgramJudge::equal_record(const Record& record) {
  if (!tolerances_.compare_blocks || !tolerances_.skip_equal) return false;
  if (!in_step_ && !fall_into_step()) return false;
  if (!plain_ahead() || !in_step_->next.is(record)) {
    leave_step();
    return false;
  }
  go_on();
  return true;
}

// The two sides stand at one place, with nothing begun or waiting.
bool ProgramJudge::fall_into_step() {
  if (alignment_.hypotheses().size() != 1 || end_record_) return false;
  if (!reference_.waiting().empty()) return false;
  const Hypothesis& only = alignment_.hypotheses().front();
  if (!only.is_fresh() || only.after_alarm || !reference_.is_next(only.step)) return false;
  InStep step;
  if (!is_same_point(only.at, reference_.place()) || !take_place(only.at, step.at)) return false;
  in_step_ = step;
  return true;
}

// The reference's next record, where both sides would keep it.
bool ProgramJudge::plain_ahead() {
  InStep& step = *in_step_;
  if (step.ahead == nullptr) {
    step.ahead = reference_.next_item();
    const auto* record = step.ahead == nullptr ? nullptr : std::get_if<Record>(step.ahead);
    step.is_plain =
        record != nullptr && step.next.take(*record, step.at) && step.next.is_visible(tolerances_);
  }
  return step.is_plain;
}

void ProgramJudge::go_on() {
  has_acted_ = true;
  InStep& step = *in_step_;
  step.coordinates += step.next.coordinates();
  step.at = step.next.to;
  step.ahead = nullptr;
}

void ProgramJudge::leave_step() {
  if (!in_step_) return;
  const Position at = position_of(in_step_->at);
  const reference::Item* ahead = in_step_->ahead;
  Hypothesis& only = alignment_.hypotheses().front();
  only.at = only.anchor = at;
  only.coordinates.take_exact(in_step_->coordinates);
  only.passed = reference_.items() - (ahead == nullptr ? 0 : 1);
  reference_.resume(at, ahead);
  in_step_.reset();
}

}  // namespace gonogo::oracle
