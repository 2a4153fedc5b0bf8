// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for the subject's end: complete, too early, with an alarm, or not at all.
// Each hypothesis comes to an ending of its own, and the best of them counts.
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "oracle/judge/advice.hpp"
#include "oracle/judge/changed_program.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/unreadable_block.hpp"
#include "oracle/motion/places.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

struct ProgramJudge::Ending {
  Hypothesis from;
  std::optional<Verdict> verdict = {};  // nothing: GO
  // What of the M functions goes before it, of so many that are due by then: all but those of the
  // block that alarms; but those behind it, too, which are not judged (R7).
  enum class MFunctions { none, before_alarm, of_earlier } judges = MFunctions::none;
  std::size_t m_functions = 0;
  std::uint64_t block = 0;  // that alarms
  bool at_load = false;
  std::size_t item = 0;  // of the reference, where it departs; 0: that of the hypothesis

  // The less the better: a pass by its grade, a gap, an advice, a departure (R9).
  int rank() const {
    if (!verdict && !from.instead) return from.exact ? 0 : from.rounded ? 1 : 2;
    switch (decision((verdict ? *verdict : *from.instead).kind)) {
      case Decision::undecided:
        return 3;
      case Decision::neither:
        return 4;
      default:
        return 5;
    }
  }
};

// A subject's alarm, how the hypothesis stood when it came, and the first step that it leaves
// undone, with how the hypothesis stood there.
struct ProgramJudge::Alarming {
  const SubjectAlarm& alarm;
  bool at_load = false;
  std::size_t at = 1;  // the item of the first step that is not done
  bool is_begun = false;
  struct Unfinished {
    Hypothesis from;
    ReferenceSteps::Step step;
  };
  std::optional<Unfinished> unfinished = {};
};

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

Verdict alarm_verdict(VerdictKind kind, const AlarmReport& report, std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.block = report.block;
  const reference::Alarm& told = best_supported(report);  // J-ALM-01
  verdict.clause = told.clause;
  verdict.word = told.word;
  verdict.want = alarms_text(report);
  verdict.message = std::move(message);
  return verdict;
}

// The answer to an alarm for which the reference has none.
Verdict alarm_verdict(VerdictKind kind, const SubjectAlarm& alarm, std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.block = alarm.block;
  verdict.word = alarm.word;
  verdict.got = alarm_text(alarm);
  verdict.message = std::move(message);
  return verdict;
}

// R7: to run on is the other answer to each rule that is an alarm. The reference ends there.
Verdict ran_on(Verdict missing, const Tolerances& tolerances) {
  missing = advised(std::move(missing), tolerances);
  if (missing.kind == VerdictKind::advice) {
    missing.message += " What the subject does after it is not judged.";
  }
  return missing;
}

bool is_record_end(const ReferenceStep& step) {
  const auto* record = std::get_if<Record>(&step);
  return record != nullptr && record->kind == RecordKind::end;
}

}  // namespace

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
    decide_undecided(undecided);
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
  }
  decide(std::move(ending.verdict));
}

// R6. Those of earlier blocks, and those of a cycle, must have come as motion must; of those that
// the block that alarms names no text says whether they do, each as often as it is named. A control
// that checks at load need not pass any.
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
    if (is_due) return m_function_missing(due.record, {}, records_);
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
  if (!from.open->is_judged_when_left()) why_not.record = records_;
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
    if (!passing.passed) return {from, ends_early(from, step, records_, "end")};
  }
}

NoAlarmReason ProgramJudge::why_no_alarm(const Alarming& alarming) const {
  AlarmPlace place;
  if (tolerances_.compare_blocks) place.block = alarming.alarm.block;
  place.at = alarming.at;
  place.is_begun = alarming.is_begun;
  if (alarming.unfinished) place.undone = alarming.unfinished->step.item;
  return reason_for_no_alarm(profile_, program_, place, alarming.alarm.alarm_class);
}

// R6, and R7 where the alarm is the other answer to a rule that no text states.
Verdict ProgramJudge::spurious_alarm(const Alarming& alarming, std::string message) const {
  Verdict verdict =
      alarm_verdict(VerdictKind::fail_alarm_spurious, alarming.alarm, std::move(message));
  const NoAlarmReason reason = why_no_alarm(alarming);
  verdict.clause = reason.clause;
  if (reason.answer == NoAlarmReason::Answer::other)
    return advised(std::move(verdict), tolerances_);
  if (reason.answer == NoAlarmReason::Answer::late) {
    verdict.kind = VerdictKind::fail_alarm_late;
    verdict.message = "Motion of the block that alarms, or of a later one, was put out before.";
  }
  return verdict;
}

// An alarm of a class that the block does not admit. Another answer: to a rule by which the block
// runs on without its faults (R7), or which unstated one it answers (R7).
Verdict ProgramJudge::other_class(const Alarming& alarming, const AlarmReport& report) const {
  const auto message = [](const reference::Alarm& alarm) {
    return fmt::format("The alarm is of another class. {}", alarm.message);
  };
  Verdict verdict =
      alarm_verdict(VerdictKind::fail_alarm_class, report, message(best_supported(report)));
  verdict.got = alarm_text(alarming.alarm);
  const auto named = std::ranges::find_if(report.alarms, [&](const reference::Alarm& alarm) {
    return reference::is_silent(alarm.clause) &&
           reference::share_a_name(reference::clause(alarm.clause).other_names,
                                   alarming.alarm.alarm_class);
  });
  const NoAlarmReason reason = why_no_alarm(alarming);
  if (named != report.alarms.end()) {
    verdict.clause = named->clause;
    verdict.word = named->word;
    verdict.message = message(*named);
  } else if (reason.answer == NoAlarmReason::Answer::other) {
    verdict.clause = reason.clause;
  } else {
    return verdict;
  }
  return advised(std::move(verdict), tolerances_);
}

// R6. Nothing where the subject's alarm is one that the reference's admits.
std::optional<Verdict> ProgramJudge::compare_alarm(const Hypothesis& from, const Alarming& alarming,
                                                   const AlarmReport& report) const {
  const SubjectAlarm& alarm = alarming.alarm;
  auto verdict = [&](VerdictKind kind, std::string message) {
    Verdict result = alarm_verdict(kind, report, std::move(message));
    result.got = alarm_text(alarm);
    return result;
  };
  const bool may_be_later =
      tolerances_.compare_blocks ? alarm.block > report.block : from.after_alarm.has_value();
  if (may_be_later && !tolerances_.strict && reference::is_silent(best_supported(report).clause) &&
      alarms_without(profile_, program_, report, alarm)) {
    return ran_on(verdict(VerdictKind::fail_alarm_missing, "The alarm is missing."), tolerances_);
  }
  if (from.after_alarm) {
    const bool moves = is_motion(from.after_alarm->record.kind);
    Verdict late = alarm_verdict(VerdictKind::fail_alarm_late, report,
                                 fmt::format("A {} was put out in or after the block that alarms.",
                                             moves ? "motion" : "dwell"));
    late.record = from.after_alarm->number;
    late.got = record_text(from.after_alarm->record);
    return late;
  }
  if (tolerances_.compare_blocks && alarm.block != report.block) {
    if (alarm.block < report.block) {
      Verdict early = spurious_alarm(alarming, "The alarm comes in a block before the right one.");
      early.want = alarms_text(report);
      return early;
    }
    return verdict(VerdictKind::fail_alarm_late, "The alarm comes in a block after the right one.");
  }
  if (alarm.alarm_class.empty()) {
    return verdict(
        VerdictKind::unmapped_alarm,
        fmt::format("The subject's alarm \"{}\" has no class; its alarm map must give one.",
                    alarm.native));
  }
  if (admits(report, alarm.alarm_class) ||
      has_alarm_before_fault(profile_, program_, report, alarm.alarm_class)) {
    return std::nullopt;
  }
  return other_class(alarming, report);
}

// An alarm outside the program.
std::optional<Verdict> ProgramJudge::alarm_outside(const SubjectAlarm& alarm) const {
  if (end_record_) {
    return alarm_verdict(VerdictKind::fail_overrun, alarm,
                         "An alarm follows the end of the trace.");
  }
  if (!alarm.before_program) return std::nullopt;
  return alarm_verdict(VerdictKind::fail_alarm_spurious, alarm,
                       "The alarm comes before the program, in a line that leads to its start.");
}

// At the reference's alarm or its end. R7: what departs in motion, or in M functions, before
// an alarm that no text states goes first.
ProgramJudge::Ending ProgramJudge::at_alarm(Hypothesis& from, const Alarming& alarming) {
  using MFunctions = Ending::MFunctions;
  const auto& unfinished = alarming.unfinished;
  const ReferenceSteps::Step& here = reference_.at(from.step);
  const auto* report = std::get_if<AlarmReport>(&here.what);
  std::optional<Verdict> departure =
      report != nullptr
          ? compare_alarm(from, alarming, *report)
          : spurious_alarm(alarming, "The subject alarms, and the program has no fault.");
  if (report == nullptr && unfinished && tolerances_.compare_blocks &&
      departure->kind == VerdictKind::fail_alarm_spurious) {
    const auto behind = own_alarm();
    if (behind && behind->block > alarming.alarm.block) {
      departure->message = "The alarm comes in a block before the right one.";
      departure->want = alarms_text(*behind);
    }
  }
  if (departure && departure->want.empty() && unfinished) {
    departure->want = step_text(unfinished->step.what);
  }
  const bool is_early = report == nullptr || (tolerances_.compare_blocks && departure &&
                                              alarming.alarm.block < report->block);
  // Without line numbers the block that the subject names says nothing.
  const std::uint64_t alarmed = tolerances_.compare_blocks ? alarming.alarm.block : 0;
  const std::uint64_t block = is_early ? alarmed : report->block;
  const std::size_t item = unfinished ? unfinished->step.item : 0;
  if (departure && departure->kind != VerdictKind::advice) {
    return {from, std::move(departure), MFunctions::none, 0, 0, false, item};
  }
  if (unfinished && (!departure || block_of(unfinished->step.what) < block)) {
    Verdict verdict =
        ends_early(unfinished->from, unfinished->step.what, records_, alarm_text(alarming.alarm));
    return {unfinished->from, std::move(verdict), MFunctions::none, 0, 0, false, item};
  }
  // Past what is undone no M function has been come to.
  const std::size_t due = unfinished ? unfinished->step.m_functions : here.m_functions;
  if (!departure) return {from, {}, MFunctions::before_alarm, due, block, alarming.at_load};
  return {from, std::move(departure), alarming.at_load ? MFunctions::none : MFunctions::of_earlier,
          due, block};
}

bool ProgramJudge::is_left_at_alarm(Hypothesis& from) {
  OpenStep* open = alignment_.open_step_of(from);
  if (open == nullptr) return false;
  return !open->is_judged_when_left() || open->is_judged_at_alarm(from.at);
}

// R7: an alarm behind an end that no text states, which is no answer to where it stands.
bool ProgramJudge::is_alarm_behind_end(Hypothesis& from, const Alarming& alarming) {
  if (!is_silent_end(reference_.at(from.step).what) || alarming.unfinished) return false;
  Verdict verdict = spurious_alarm(alarming, "The subject goes on behind the end of the program.");
  if (verdict.kind == VerdictKind::advice) return false;
  verdict.clause = clause_of(reference_.at(from.step).what);
  return alignment_.go_on_behind_end(from, std::move(verdict));
}

// Whether a step is due behind the block of the subject's alarm, before which others are undone:
// then no alarm of the program makes it right.
bool ProgramJudge::is_behind_alarm(const Alarming& alarming, const ReferenceStep& step) const {
  if (!alarming.unfinished || !tolerances_.compare_blocks) return false;
  const std::uint64_t alarmed = alarming.alarm.block;
  const std::uint64_t block = block_of(step);
  return block_of(alarming.unfinished->step.what) >= alarmed && block != 0 && block != alarmed;
}

// The program's own alarm, which is told of a subject's that comes before it.
std::optional<AlarmReport> ProgramJudge::own_alarm() const try {
  const auto as_it_is = [](const grammar::Line& line) { return std::optional(line.text); };
  return alarm_of(profile_, program_, as_it_is, kMostItems);
} catch (const exact::Undecided&) {
  return std::nullopt;
}

std::optional<ProgramJudge::Ending> ProgramJudge::excused_at(Hypothesis from,
                                                             const Alarming& alarming) {
  Ending ending = at_alarm(from, alarming);
  const bool is_excused = ending.verdict && ending.verdict->kind == VerdictKind::advice;
  return is_excused ? std::optional(std::move(ending)) : std::nullopt;
}

ProgramJudge::Ending ProgramJudge::alarm_end(Hypothesis& from, const SubjectAlarm& alarm) {
  // A controller that checks at load has put out nothing.
  const bool at_load = profile_.alarm_timing == reference::AlarmTiming::program && !has_acted_;
  Alarming alarming{alarm, at_load, reference_.at(from.step).item, !from.is_fresh()};
  auto& unfinished = alarming.unfinished;
  bool may_be_earlier = !at_load && tolerances_.compare_blocks;
  std::optional<Ending> earlier;
  const auto best = [&](Ending ending) {
    const bool is_go = !ending.verdict || ending.verdict->kind == VerdictKind::advice;
    return is_go || !earlier ? std::move(ending) : *std::move(earlier);
  };
  for (std::size_t passed = 0; passed < kMostItems; ++passed) {
    if (!earlier) forget_behind(from, at_load || unfinished);
    const ReferenceSteps::Step& here = reference_.at(from.step);
    const ReferenceStep& step = here.what;
    auto* const outside = std::get_if<NotCovered>(&step);
    if (outside != nullptr && (at_load || !unfinished)) {
      return {from, not_covered_verdict(*outside)};
    }
    const bool is_close = std::holds_alternative<AlarmReport>(step) || is_record_end(step);
    if (is_close && is_alarm_behind_end(from, alarming)) continue;
    if (is_close || outside != nullptr || is_behind_alarm(alarming, step)) {
      return best(at_alarm(from, alarming));
    }
    auto* motion = std::get_if<Motion>(&step);
    const bool may_pass = motion != nullptr ? !unfinished
                                            : std::holds_alternative<reference::Renaming>(step) ||
                                                  (!at_load && is_left_at_alarm(from));
    if (may_pass) {
      const bool may_alarm_here =
          may_be_earlier && motion != nullptr && motion->record.block == alarm.block;
      std::optional<Hypothesis> stands;
      if (may_alarm_here) stands = from;
      const Alarming alarming_here{alarm, false, here.item, !from.is_fresh()};
      Alignment::Passing passing = alignment_.pass(from);
      // R7: before a motion too small to see, to whose block a loop leads back.
      if (passing.passed && stands) {
        may_be_earlier = false;
        earlier = excused_at(*std::move(stands), alarming_here);
      }
      if (passing.passed) continue;
      if (passing.why_not && from.open->is_judged_when_left()) {
        return open_end(from, *std::move(passing.why_not));
      }
    }
    // Past motion that is missing, only the alarm of the program is of interest.
    if (!at_load && !unfinished) {
      const bool is_of_block =
          motion != nullptr && (!tolerances_.compare_blocks || alarm.block == motion->record.block);
      if (is_of_block && hangs_on_rounding(*motion, tolerances_.tolerance)) {
        return {from, gap_verdict(GapReason::rounding, kPointsNearlyInLine)};
      }
      unfinished.emplace(Alarming::Unfinished{from, here});
    }
    alignment_.skip(from);
  }
  if (unfinished) return best(at_alarm(from, alarming));
  throw exact::Undecided("the program goes on for too long behind the alarm");
}

}  // namespace gonogo::oracle
