// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's filter before everything that it does with motions. While the subject's records
// are the reference's own, and none is so small that it could be dropped or could be joined to the
// one before, both sides would be dropped, joined and found equal all the same: it is enough to
// compare the records. The first that is anything else goes the whole way, and so does the motion
// before it.
#include "oracle/judge/plain_line.hpp"
#include "oracle/judge/program_judge.hpp"

namespace gonogo::oracle {

bool ProgramJudge::line(std::string_view line) {
  if (!in_step_ || verdict_) return false;
  try {
    if (!plain_ahead() || !is_line_of(in_step_->next, line)) return false;
    ++records_;
    // Whoever reads a line reads no clause.
    go_on(in_step_->next.axes, reference::kNoClause);
  } catch (const exact::Undecided& undecided) {
    ++records_;
    decide_undecided(undecided);
  }
  return true;
}

bool ProgramJudge::equal_record(const Record& record) {
  if (!terms_.compare_blocks || !terms_.skip_equal) return false;
  if (in_step_) {
    if (!plain_ahead() || !in_step_->next.is(record)) {
      leave_step(records_ - 2);
      return false;
    }
  } else if (!fall_into_step(record)) {
    return false;
  }
  go_on(record.axes, record.clause);
  return true;
}

// The reference's next record, where both sides would keep it and join it to nothing.
bool ProgramJudge::plain_ahead() {
  InStep& step = *in_step_;
  if (step.ahead == nullptr) {
    step.ahead = reference_.next_item();
    const auto* record = step.ahead == nullptr ? nullptr : std::get_if<Record>(step.ahead);
    step.is_plain = record != nullptr && step.next.take(*record, step.last.to) &&
                    step.next.stays_apart(step.last, terms_);
  }
  return step.is_plain;
}

// The two sides have come to the same motion, which waits to be joined on either, and the record is
// what the reference has behind it.
bool ProgramJudge::fall_into_step(const Record& record) {
  if (!pending_ || match_ || after_alarm_ || end_record_ || !want_m_.empty() || !got_m_.empty()) {
    return false;
  }
  const Motion* ahead = reference_.beyond_same(*pending_);
  if (ahead == nullptr || !is_same_point(position_, pending_->to()) ||
      !is_same_point(anchor_, position_)) {
    return false;
  }
  InStep step;
  if (!step.last.take(*pending_) || !step.next.take(*ahead) ||
      !step.next.stays_apart(step.last, terms_) || !step.next.is(record)) {
    return false;
  }
  pending_.reset();
  in_step_ = step;
  return true;
}

void ProgramJudge::go_on(AxisSet axes, reference::ClauseId clause) {
  InStep& step = *in_step_;
  std::swap(step.last, step.next);
  step.axes = axes;
  step.clause = clause;
  step.ahead = nullptr;
  motion_block_ = step.last.block;
  if (step.last.kind != RecordKind::rapid) cut_block_ = step.last.block;
}

// Puts both sides where they would stand with the last motion waiting to be joined. `number`: its
// place in the subject's trace.
void ProgramJudge::leave_step(std::size_t number) {
  if (!in_step_) return;
  Motion last = in_step_->last.motion(number);
  const reference::Item* ahead = in_step_->ahead;
  reference_.go_on_behind(in_step_->last, ahead);
  last.record.axes = in_step_->axes;
  last.record.clause = in_step_->clause;
  position_ = anchor_ = last.to();
  pending_ = std::move(last);
  in_step_.reset();
}

}  // namespace gonogo::oracle
