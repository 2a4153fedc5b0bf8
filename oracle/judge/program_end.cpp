// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for the subject's end: complete, too early, or not at all; with an alarm, in
// program_alarm.cpp. Each hypothesis comes to an ending of its own, and the best of them counts.
#include <fmt/format.h>

#include <map>

#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/program_ending.hpp"
#include "oracle/steps/m_functions.hpp"
#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

namespace {

VerdictKind kind_of(RunEnd::Kind kind) {
  switch (kind) {
    case RunEnd::Kind::skip:
    case RunEnd::Kind::refused:
      return VerdictKind::skip;
    case RunEnd::Kind::crash:
    case RunEnd::Kind::error:
      return VerdictKind::crash;
    case RunEnd::Kind::timeout:
      return VerdictKind::timeout;
    case RunEnd::Kind::out_of_memory:
      return VerdictKind::out_of_memory;
    default:
      return VerdictKind::protocol;
  }
}

}  // namespace

bool is_record_end(const ReferenceStep& step) {
  const auto* record = std::get_if<Record>(&step);
  return record != nullptr && record->kind == RecordKind::end;
}

Verdict ProgramJudge::finish(const RunEnd& end) {
  Hypothesis passed;
  try {
    leave_step();
    if (!verdict_ && !alignment_.settle()) decide_departure();
    const bool is_whole = end.kind == RunEnd::Kind::ok || end.kind == RunEnd::Kind::alarm;
    if (!verdict_ && !is_whole) {
      Verdict verdict;
      verdict.kind = kind_of(end.kind);
      verdict.feature = end.feature;
      verdict.message = end.message;
      decide(std::move(verdict));
    }
    if (!verdict_ && end.kind == RunEnd::Kind::alarm) decide(alarm_outside(end.alarm));
    if (!verdict_) {
      std::optional<Ending> best;
      for (Hypothesis& from : alignment_.hypotheses()) {
        Ending ending = end_of(std::move(from), end);
        const bool is_better =
            !best || ending.rank() < best->rank() ||
            (ending.rank() == best->rank() && ending.verdict && ending.from.step > best->from.step);
        if (is_better) best = std::move(ending);
      }
      passed = best->from;
      alignment_.hypotheses().assign(1, passed);  // a session may ask again
      settle(*std::move(best));
    }
    explain_departure();
  } catch (const exact::Undecided& undecided) {
    decide(undecided_verdict(undecided));
  }
  if (verdict_) return *verdict_;
  if (passed.instead) return *passed.instead;
  Verdict verdict;
  // J-CMP-09.
  verdict.property_motions = passed.property_motions;
  if (!passed.coordinates.empty()) verdict.coordinates = passed.coordinates;
  verdict.kind = passed.property_motions > 0 ? VerdictKind::pass_properties
                 : passed.exact              ? VerdictKind::pass_exact
                 : passed.rounded            ? VerdictKind::pass_rounded
                                             : VerdictKind::pass_tolerance;
  return verdict;
}

ProgramJudge::Ending ProgramJudge::end_of(Hypothesis from, const RunEnd& end) {
  try {
    return end.kind == RunEnd::Kind::ok ? ok_end(from) : alarm_end(from, end.alarm);
  } catch (const exact::Undecided& undecided) {
    return {std::move(from), undecided_verdict(undecided)};
  }
}

// M functions are decided first; then what the ending says.
void ProgramJudge::settle(Ending ending) {
  decide(m_functions_before_alarm(ending));
  if (ending.verdict) {
    departed_at_ = ending.item != 0 ? ending.item : reference_.at(ending.from.step).item;
    name_line(*ending.verdict, ending.from.step);
    departed_block_ = ending.verdict->block;
  }
  decide(std::move(ending.verdict));
}

// R6. Those of earlier blocks, and those of a cycle, must have come as motion must. No text says
// whether those come that the alarming block names, each as often as it is named. A control that
// checks at load need not pass any.
std::optional<Verdict> ProgramJudge::m_functions_before_alarm(const Ending& ending) const {
  using MFunctions = Ending::MFunctions;
  if (ending.judges == MFunctions::none) return std::nullopt;
  const bool before_alarm = ending.judges == MFunctions::before_alarm;
  const std::string words = reference_.failed_words();
  const auto named = [&](const Record& record) { return times_named(words, record.m); };
  std::map<std::int32_t, std::size_t> came;
  for (const SubjectMFunction& got : m_functions_of_alarm_) {
    const bool is_of_block = !tolerances_.compare_blocks || got.record.block == ending.block;
    // Where the subject runs on a loop may lead back to earlier blocks.
    const bool is_free =
        before_alarm ? is_of_block && ++came[got.record.m] <= named(got.record)
                     : is_of_block || got.record.block > ending.block || !reference_.is_in_order();
    if (!is_free) return m_function_too_many(got.record, got.number, wanted_at(ending.from.step));
  }
  if (ending.at_load) return std::nullopt;
  for (const DueMFunction& due : reference_.waiting(ending.m_functions)) {
    const bool is_due = before_alarm ? due.record.block != ending.block || named(due.record) == 0
                                     : due.record.block < ending.block;
    if (!is_due) continue;
    Verdict missing = m_function_missing(due.record, {}, records_);
    if (before_alarm) missing.message = "The alarm comes before this M function.";
    return missing;
  }
  return std::nullopt;
}

// R5.
std::optional<Verdict> ProgramJudge::compare_end(const Record& end) const {
  if (!end_record_) return std::nullopt;
  for (Axis axis : reference::kAllAxes) {
    if (!end_record_->axes.has(axis)) continue;
    if (agree(end_record_->to[axis], end.to[axis], tolerances_.tolerance)) continue;
    Verdict verdict;
    verdict.kind = VerdictKind::fail_geometry;
    verdict.record = records_ - 1;
    verdict.want = record_text(end);
    verdict.got = record_text(*end_record_);
    if (reference::is_linear(axis)) {
      verdict.message = fmt::format("The end position differs on axis {}.", letter(axis));
      set_deviation(verdict, abs(end_record_->to[axis] - end.to[axis]));
    } else {
      verdict.message = "The end position differs.";
      tell_degrees(verdict, axis, end_record_->to, end.to);
    }
    return verdict;
  }
  return std::nullopt;
}

ProgramJudge::Ending ProgramJudge::open_end(const Hypothesis& from, Verdict why_not) const {
  if (!from.open->is_judged_when_left() && why_not.got.empty()) {
    why_not.record = records_;
    // R5: of a path that is known, the end comes at another place.
    if (why_not.rule == RelationRule::none) why_not.rule = RelationRule::event;
  }
  return {from, std::move(why_not)};
}

// What is behind the only hypothesis is not looked at again.
void ProgramJudge::forget_behind(const Hypothesis& from, bool leaves_out_m_functions) {
  if (alignment_.hypotheses().size() != 1) return;
  if (leaves_out_m_functions) reference_.leave_out_m_functions();
  reference_.forget_before(from.step);
}

ProgramJudge::Ending ProgramJudge::ok_end(Hypothesis& from) {
  while (true) {
    forget_behind(from, false);
    const std::size_t m_functions = reference_.at(from.step).m_functions;
    const ReferenceStep& step = reference_.at(from.step).what;
    if (const DueMFunction* due = alignment_.overdue(from)) {
      return {from, m_function_missing(due->record, "end", records_)};
    }
    if (auto* outside = std::get_if<NotCovered>(&step)) {
      return {from, not_covered_verdict(*outside)};
    }
    if (is_record_end(step)) {
      return {from, compare_end(std::get<Record>(step))};
    }
    if (auto* report = std::get_if<AlarmReport>(&step)) {
      Verdict verdict =
          alarm_verdict(VerdictKind::fail_alarm_missing, *report,
                        fmt::format("The alarm is missing: {}", best_supported(*report).message));
      if (from.after_alarm) {
        verdict.record = from.after_alarm->number;
        verdict.got = record_text(from.after_alarm->record);
      }
      verdict = ran_on(std::move(verdict), tolerances_);
      if (verdict.kind != VerdictKind::advice) return {from, std::move(verdict)};
      return {from, std::move(verdict), Ending::MFunctions::of_earlier, m_functions, report->block};
    }
    Alignment::Passing passing = alignment_.pass(from);
    if (passing.why_not) return open_end(from, *std::move(passing.why_not));
    if (!passing.passed) return {from, ends_early(from, step, records_, "end", tolerances_)};
  }
}

}  // namespace gonogo::oracle
