// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alignment's part for dwells.
#include "oracle/judge/alignment.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/motion/labels.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

bool Alignment::take_dwell(const Record& record, std::size_t number) {
  if (!settle()) return false;
  farthest_.reset();
  std::vector<Hypothesis> reached;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    if (meet_dwell(from, record, number)) keep(std::move(from), reached);
  }
  return finish(std::move(reached));
}

OtherOrder Alignment::late_dwell(const ReferenceStep& due) const {
  if (dwell_of(due) == nullptr) return {};
  return {[due, this](const Record& record) { return is_dwell_due(due, record, tolerances_); },
          "A dwell comes later than it is due."};
}

// R3.
bool Alignment::may_be_none(const ReferenceStep& step) const {
  const Record* dwell = dwell_of(step);
  return dwell != nullptr && may_be_no_dwell(*dwell, tolerances_);
}

// R5.
bool Alignment::meet_dwell(Hypothesis& from, const Record& record, std::size_t number) {
  if (from.after_alarm) return true;
  Passing passing{true};
  for (std::size_t passed = 0; passing.passed; ++passed) {
    if (passes_too_many(from, passed)) return false;
    const ReferenceStep& what = step_of(from).what;
    if (const DueMFunction* due = overdue(from)) {
      refute_missing(from, *due, record_text(record), number);
      return false;
    }
    if (auto* outside = std::get_if<NotCovered>(&what)) {
      leave_undecided(from.step, not_covered_verdict(*outside));
      return false;
    }
    const auto* report = std::get_if<AlarmReport>(&what);
    if (report != nullptr && !is_of_earlier_block(record, report->block)) {
      from.after_alarm = motion_from(from.at, record, number);
      return true;
    }
    if (is_dwell_due(what, record, tolerances_)) {
      ++from.step;
      return true;
    }
    passing = pass(from);
  }
  if (passing.why_not && from.open->is_judged_when_left()) {
    refute(from, *std::move(passing.why_not));
    return false;
  }
  Verdict verdict = wrong_dwell(record, number, from, steps_, tolerances_);
  if (go_on_behind_end(from, verdict)) return meet_dwell(from, record, number);
  refute(from, std::move(verdict));
  return false;
}

}  // namespace gonogo::oracle
