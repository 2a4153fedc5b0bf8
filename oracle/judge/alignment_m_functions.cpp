// SPDX-License-Identifier: GPL-3.0-or-later
//
// Alignment's part for M functions, which are events of one order with motions and dwells
// (R5). The block of one is that of the steps round it, so that this holds without line
// numbers, too.
#include <algorithm>
#include <utility>

#include "oracle/judge/alignment.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/motion/progress.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

namespace {

// Whether the M function may come behind this step, which the reference has behind it.
bool may_come_behind(const DueMFunction& due, const ReferenceSteps::Step& step) {
  if (due.is_fixed || step.block != due.record.block) return false;
  const bool waits = cuts(step.what) || dwell_of(step.what) != nullptr;
  return !waits || !starts_something(due.record);
}

}  // namespace

bool Alignment::is_told(const DueMFunction& due, const Record& record) const {
  return due.record.m == record.m &&
         (!tolerances_.compare_blocks || due.record.block == record.block);
}

// R5. The M functions of both sides are partners in order; those of one block have no order among
// themselves. So the subject's next one is the reference's next, whichever way its motions are
// read. Only whether it may come where the subject stands depends on that.
Alignment::MFunction Alignment::take_m_function(const Record& record, std::size_t number) {
  if (!settle()) return MFunction::departs;
  farthest_.reset();
  bool is_taken = false;
  std::vector<Hypothesis> reached;
  for (Hypothesis& from : std::exchange(hypotheses_, {})) {
    const MFunction met = meet_m_function(from, record, number);
    is_taken = is_taken || met == MFunction::taken;
    if (met != MFunction::departs) keep(std::move(from), reached);
  }
  if (!finish(std::move(reached))) return MFunction::departs;
  if (is_taken) steps_.take_m_function();
  return is_taken ? MFunction::taken : MFunction::of_alarm;
}

// Where it is due, or was omitted and may come behind, or may come early; past what the subject
// need not show.
Alignment::MFunction Alignment::meet_m_function(Hypothesis& from, const Record& record,
                                                std::size_t number) {
  if (from.after_alarm) return MFunction::of_alarm;
  Passing passing{true};
  for (std::size_t passed = 0; passing.passed; ++passed) {
    if (passes_too_many(from, passed)) return MFunction::departs;
    const ReferenceSteps::Step& step = steps_.at(from.step + from.joined);
    const auto waiting = steps_.waiting(step.m_functions);
    if (!waiting.empty()) {
      if (!is_told(waiting.front(), record)) {
        if (comes_beside(from, record)) return MFunction::taken;
        break;
      }
      if (!is_within(from, waiting.front())) return MFunction::taken;
    } else if (std::holds_alternative<AlarmReport>(step.what)) {
      return MFunction::of_alarm;
    } else if (auto* outside = std::get_if<NotCovered>(&step.what)) {
      leave_undecided(from.step, not_covered_verdict(*outside));
      return MFunction::departs;
    } else if (may_come_early(from, record)) {
      return MFunction::taken;
    }
    passing = pass(from);
  }
  if (may_be_of_alarm(from, record)) return MFunction::of_alarm;
  if (passing.why_not && from.open->is_judged_when_left()) {
    refute(std::move(from), *std::move(passing.why_not));
  } else {
    refute_m_function(std::move(from), record, number);
  }
  return MFunction::departs;
}

void Alignment::refute_m_function(Hypothesis from, const Record& record, std::size_t number) {
  const bool is_later = is_due_later(from, record);
  const auto waiting = steps_.waiting(steps_.at(from.step + from.joined).m_functions);
  if (waiting.empty()) {
    if (is_later) return refute_early(std::move(from), record, number);
    std::string due = step_text(step_of(from).what);
    return refute(std::move(from), m_function_too_many(record, number, std::move(due)));
  }
  const DueMFunction& due = waiting.front();
  if (is_told(due, record)) {
    refute(std::move(from), m_function_within(due.record, record, number));
  } else if (is_later) {
    refute_missing(std::move(from), due, record_text(record), number);
  } else {
    refute(std::move(from), other_m_function(due.record, record, number));
  }
}

// J-CMP-12: where the M function is due behind a cut that the subject has left unfinished, the cut
// is short, or goes on behind it; behind a motion that has not begun, this is missing, or comes
// behind it.
void Alignment::refute_early(Hypothesis from, const Record& record, std::size_t number) {
  const ReferenceSteps::Step& step = step_of(from);
  Verdict early = m_function_too_early(record, number, step_text(step.what));
  const auto behind = steps_.waiting(step_behind(from).m_functions);
  const bool is_next = !behind.empty() && is_told(behind.front(), record);
  if (OtherOrder late = late_dwell(step.what); late.shows) {
    Verdict verdict = m_function_for_dwell(step.what, record, number);
    return refute(std::move(from), std::move(verdict), std::move(late));
  }
  if (!std::holds_alternative<Motion>(step.what) || (from.piece && !is_next)) {
    return refute(std::move(from), std::move(early));
  }
  const std::shared_ptr<const Curve> curve = from.curve ? from.curve : steps_.curve_of(step);
  OtherOrder goes_on = {[from, curve, number](const Record& next) {
                          const Motion motion = motion_from(from.at, next, number);
                          return is_motion(next.kind) &&
                                 !curve->follow(from.progress, motion).departs();
                        },
                        kComesEarly};
  Verdict verdict = ends_early(from, step.what, number, record_text(record), tolerances_);
  if (!from.piece) {
    verdict.message = "This motion is missing: an M function behind it comes.";
    goes_on.verdict = std::move(early);
  }
  refute(std::move(from), std::move(verdict), std::move(goes_on));
}

void Alignment::refute_missing(Hypothesis from, const DueMFunction& due, std::string got,
                               std::size_t number) {
  OtherOrder comes_later = {[this, due](const Record& record) {
                              return record.kind == RecordKind::m && is_told(due, record);
                            },
                            "An M function comes later than it is due."};
  refute(std::move(from), m_function_missing(due.record, std::move(got), number),
         std::move(comes_later));
}

const DueMFunction* Alignment::overdue_at(std::size_t number) {
  const ReferenceSteps::Step& step = steps_.at(number);
  for (const DueMFunction& due : steps_.waiting(step.m_functions)) {
    if (!may_come_behind(due, step)) return &due;
  }
  return nullptr;
}

// A new name of the position shows in no record, and an alarm has rules of its own (R6).
const DueMFunction* Alignment::overdue(const Hypothesis& from) {
  const ReferenceStep& what = step_of(from).what;
  const bool is_ignored = !from.is_fresh() || from.after_alarm ||
                          std::holds_alternative<reference::Renaming>(what) ||
                          std::holds_alternative<AlarmReport>(what);
  return is_ignored ? nullptr : overdue_at(from.step);
}

// Whether the motion does not belong behind the due M function: it is of an earlier block, or,
// without lines, does not lead towards the end of the next motion.
bool Alignment::is_undue(const Motion& motion, const ReferenceSteps::Step& step) const try {
  if (tolerances_.compare_blocks) return is_of_earlier_block(motion.record, step.block);
  const auto* const next = std::get_if<Motion>(&step.what);
  return next != nullptr && steps_.curve_of(step)->follow({}, motion).departs() &&
         !comes_nearer(motion, next->to(), tolerances_.tolerance);
} catch (const exact::Undecided&) {
  return false;
}

bool Alignment::waits_for_m_function(Hypothesis& from, const Motion& motion, Stage& stage) {
  const DueMFunction* due = overdue(from);
  if (due == nullptr) return false;
  const ReferenceSteps::Step& step = step_of(from);
  // What moves in a block that is not covered is not known.
  const bool is_known = !std::holds_alternative<reference::NotCovered>(step.what);
  if (is_negligible(from, motion, step.place)) {
    stay(std::move(from), motion, stage);
  } else if (is_known && is_end(step.what)) {
    refute_undue(std::move(from), motion_too_many(motion, step, tolerances_));
  } else if (is_known && is_undue(motion, step)) {
    refute(std::move(from), motion_for_m_function(*due, motion, step, tolerances_));
  } else {
    refute_missing(std::move(from), *due, record_text(motion.record), motion.number);
  }
  return true;
}

// Whether an M function that is not at its place stands between the motions of a cycle, or stops
// something before the rest of a cut. A block that cuts and also moves otherwise is a cycle. What
// closes a clamp may come once the tool is in place.
bool Alignment::is_within(const Hypothesis& from, const DueMFunction& due) {
  const ReferenceSteps::Step& here = step_of(from);
  const std::uint64_t block = due.record.block;
  const bool is_at_place = from.is_fresh() && from.step == due.step;
  if (is_at_place || here.block != block || due.record.before_cut) return false;
  if (here.cut_block == block) return true;
  if (!from.is_fresh() && cuts(here.what)) return true;
  const std::size_t next = from.is_fresh() ? from.step : from.step + from.joined + 1;
  for (std::size_t number = next;; ++number) {
    const ReferenceSteps::Step& step = steps_.at(number);
    if (step.block != block || is_end(step.what)) return false;
    if (cuts(step.what)) return true;
  }
}

// Whether it is another M function of the block of the due one, and may come here as well; then it
// becomes the due one.
bool Alignment::comes_beside(const Hypothesis& from, const Record& record) {
  std::optional<std::uint64_t> block;
  for (std::size_t number = from.step + from.joined;; ++number) {
    const ReferenceSteps::Step& step = steps_.at(number);
    const auto waiting = steps_.waiting(step.m_functions);
    for (std::size_t place = 0; place < waiting.size(); ++place) {
      const DueMFunction& due = waiting[place];
      if (due.is_fixed || due.record.block != block.value_or(due.record.block)) return false;
      block = due.record.block;
      if (!is_told(due, record)) continue;
      if (is_within(from, due)) return false;
      steps_.bring_forward(place);
      return true;
    }
    if (step.block != block || is_end(step.what) || cuts(step.what)) return false;
  }
}

// One that stands behind the motions of its block, none of which cuts, may come before them.
bool Alignment::may_come_early(const Hypothesis& from, const Record& record) {
  const std::uint64_t block = step_of(from).block;
  if (step_of(from).cut_block == block) return false;
  for (std::size_t number = from.step;; ++number) {
    const ReferenceSteps::Step& step = steps_.at(number);
    if (const auto waiting = steps_.waiting(step.m_functions); !waiting.empty()) {
      const DueMFunction& due = waiting.front();
      return !due.is_fixed && due.record.block == block && is_told(due, record);
    }
    if (step.block != block || is_end(step.what) || cuts(step.what)) return false;
  }
}

// R6: of a block that alarms, with what a reading has moved of it.
bool Alignment::may_be_of_alarm(const Hypothesis& from, const Record& record) {
  const std::uint64_t block = step_of(from).block;
  if (tolerances_.compare_blocks && record.block != block) return false;
  for (std::size_t number = from.step; number < from.step + kLookAhead; ++number) {
    const ReferenceSteps::Step& step = steps_.at(number);
    if (step.block != block) return false;
    if (!is_end(step.what)) continue;
    // R5: those of earlier blocks come before.
    const auto waiting = steps_.waiting(step.m_functions);
    return std::holds_alternative<AlarmReport>(step.what) &&
           std::ranges::all_of(waiting,
                               [&](const DueMFunction& due) { return due.record.block == block; });
  }
  return false;
}

bool Alignment::is_due_later(const Hypothesis& from, const Record& record) {
  std::size_t number = from.step;
  while (number < from.step + kLookAhead && !is_end(steps_.at(number).what)) ++number;
  return std::ranges::any_of(steps_.waiting(),
                             [&](const DueMFunction& due) { return is_told(due, record); });
}

}  // namespace gonogo::oracle
