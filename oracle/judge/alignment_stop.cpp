// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alignment's part for what comes between motions: dwells and the M functions of a cycle.
#include "oracle/judge/alignment.hpp"

#include "oracle/judge/m_functions.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/step_text.hpp"

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

// J-CMP-05. One way to read the motions at which it is due is enough: the others are given up.
Alignment::MFunction Alignment::take_m_function(const Record& record, std::size_t number,
                                                std::size_t settled) {
  farthest_.reset();
  const auto is_due = [&](const Record& due) {
    return due.m == record.m && (!terms_.compare_blocks || due.block == record.block);
  };
  std::vector<Hypothesis> reached;
  std::vector<Hypothesis> before;
  std::vector<Hypothesis> elsewhere;
  for (const Hypothesis& from : hypotheses_) {
    Hypothesis at = from;
    const MFunctionDue due = reach_m_function(at, settled);
    const ReferenceSteps::Step& step = step_of(at);
    if (due == MFunctionDue::here && is_due(std::get<Record>(step.what))) {
      ++at.step;
      keep(std::move(at), reached);
    } else if (due == MFunctionDue::here) {
      refute(
          Refutation{std::move(at),
                     std::nullopt,
                     {},
                     m_function_missing(std::get<Record>(step.what), record_text(record), number)});
    } else {
      if (due == MFunctionDue::free_before && is_due(step.m_functions.front())) {
        keep(std::move(at), before);
      }
      elsewhere.push_back(from);
    }
  }
  if (reached.empty() && !elsewhere.empty()) {
    hypotheses_ = std::move(before.empty() ? elsewhere : before);
    return MFunction::free;
  }
  return finish(std::move(reached)) ? MFunction::taken : MFunction::departs;
}

// Past motions too small to see, to the M function of a cycle, or to those before it that may stand
// anywhere and have not been told. None: no M function of a cycle is due.
Alignment::MFunctionDue Alignment::reach_m_function(Hypothesis& from, std::size_t settled) {
  std::optional<Hypothesis> before;
  for (std::size_t passed = 0; passed < kMostPassedForSmall; ++passed) {
    const ReferenceSteps::Step& step = step_of(from);
    const bool is_open = from.step >= settled && !step.m_functions.empty();
    if (is_open && !before) before = from;
    if (placed_m_function(step.what) != nullptr) {
      if (!before) return MFunctionDue::here;
      from = *std::move(before);
      return MFunctionDue::free_before;
    }
    if (!std::holds_alternative<Motion>(step.what) || !pass(from).passed) break;
  }
  return MFunctionDue::none;
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
    const auto* report = std::get_if<AlarmReport>(&what);
    const bool is_earlier = report != nullptr && terms_.compare_blocks && steps_.is_in_order() &&
                            record.block < report->block;
    if (report != nullptr && !is_earlier) {
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
  Verdict verdict = wrong_dwell(record, number, from, steps_, terms_);
  if (go_on_behind_end(from, verdict)) return meet_dwell(from, record, number);
  refute(Refutation{from, std::nullopt, {}, std::move(verdict)});
  return false;
}

}  // namespace gonogo::oracle
