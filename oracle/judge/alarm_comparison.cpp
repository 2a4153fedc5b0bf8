// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for an alarm of the subject against what the program says where it comes (R6,
// R7), and which rule another answer would be of.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/judge/changed_program.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/program_ending.hpp"
#include "oracle/records/text.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause.hpp"
#include "reference/nearest_word.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;

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

Verdict ran_on(Verdict missing, const Tolerances& tolerances) {
  missing = advised(std::move(missing), tolerances);
  if (missing.kind == VerdictKind::advice) {
    missing.message += " What the subject does after it is not judged.";
  }
  return missing;
}

namespace {

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

}  // namespace

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

namespace {

// " There is no alarm class \"feed-mising\". Did you mean feed-missing?"; empty: the gauge knows
// all of those that the alarm names.
std::string no_such_class(std::string_view classes) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < reference::kAlarmClasses; ++i) {
    known.emplace_back(name(static_cast<reference::AlarmClass>(i)));
  }
  for (std::size_t begin = 0; begin < classes.size();) {
    const std::size_t end = std::min(classes.find(' ', begin), classes.size());
    const std::string one(classes.substr(begin, end - begin));
    begin = end + 1;
    if (one.empty() || reference::alarm_class(one)) continue;
    const std::string near = reference::nearest_word(one, known);
    return fmt::format(" There is no alarm class \"{}\".{}", visible(one),
                       near.empty() ? "" : fmt::format(" Did you mean {}?", near));
  }
  return {};
}

}  // namespace

// An alarm of a class that the block does not admit. Another answer: to a rule by which the block
// runs on without its faults (R7), or which unstated one it answers (R7).
Verdict ProgramJudge::other_class(const Alarming& alarming, const AlarmReport& report) const {
  const auto message = [&](const reference::Alarm& alarm) {
    return fmt::format("The alarm is of another class. {}{}", alarm.message,
                       no_such_class(alarming.alarm.alarm_class));
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

// R3, as of a record.
std::optional<Verdict> ProgramJudge::alarm_without_line(const SubjectAlarm& alarm) const {
  if (!tolerances_.compare_blocks || alarm.block != 0) return std::nullopt;
  return alarm_verdict(VerdictKind::protocol, alarm,
                       "The subject declares the feature `blocks`, but its alarm has no `b`.");
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
  const bool is_later = tolerances_.compare_blocks && alarm.block > report.block;
  if (from.after_alarm || is_later) {
    Verdict late =
        verdict(VerdictKind::fail_alarm_late, "The alarm comes in a block after the right one.");
    if (from.after_alarm) {
      const bool moves = is_motion(from.after_alarm->record.kind);
      late.message = fmt::format("A {} was put out in or after the block that alarms.",
                                 moves ? "motion" : "dwell");
      late.record = from.after_alarm->number;
      late.got = record_text(from.after_alarm->record);
    }
    const bool runs_on = (is_later || !tolerances_.compare_blocks) && !tolerances_.strict &&
                         reference::is_silent(best_supported(report).clause) &&
                         alarms_without(profile_, program_, report, alarm);
    return runs_on ? ran_on(std::move(late), tolerances_) : late;
  }
  if (auto lacking = alarm_without_line(alarm)) return lacking;
  if (tolerances_.compare_blocks && alarm.block < report.block) {
    Verdict early = spurious_alarm(alarming, "The alarm comes in a block before the right one.");
    early.want = alarms_text(report);
    return early;
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

}  // namespace gonogo::oracle
