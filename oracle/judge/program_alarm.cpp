// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for an alarm of the subject (R6, R7): the block that alarms, what was due
// before it, and which rule another answer would be of.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/judge/advice.hpp"
#include "oracle/judge/changed_program.hpp"
#include "oracle/judge/mismatch.hpp"
#include "oracle/judge/no_alarm_reason.hpp"
#include "oracle/judge/program_ending.hpp"
#include "oracle/judge/unreadable_block.hpp"
#include "oracle/motion/round_curve.hpp"
#include "oracle/records/text.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/nearest_word.hpp"
#include "reference/silent_end.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;

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

// At the reference's alarm or its end. R7: what departs in motion, or in M functions, before
// an alarm that no text states goes first.
ProgramJudge::Ending ProgramJudge::at_alarm(Hypothesis& from, const Alarming& alarming) {
  using MFunctions = Ending::MFunctions;
  const auto& unfinished = alarming.unfinished;
  const ReferenceSteps::Step& here = reference_.at(from.step);
  const auto* report = std::get_if<AlarmReport>(&here.what);
  std::optional<Verdict> departure = report != nullptr ? compare_alarm(from, alarming, *report)
                                                       : alarm_without_line(alarming.alarm);
  if (report == nullptr && !departure) {
    departure = spurious_alarm(alarming, "The subject alarms, and the program has no fault.");
  }
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
    Verdict verdict = ends_early(unfinished->from, unfinished->step.what, records_,
                                 alarm_text(alarming.alarm), tolerances_);
    if (!unfinished->from.piece) verdict.rule = RelationRule::alarm;  // R6: before what is due
    return {unfinished->from, std::move(verdict), MFunctions::none, 0, 0, false, item};
  }
  // Past what is undone no M function has been come to.
  const std::size_t due = unfinished ? unfinished->step.m_functions : here.m_functions;
  if (!departure) return {from, {}, MFunctions::before_alarm, due, block, alarming.at_load};
  return {from, std::move(departure), alarming.at_load ? MFunctions::none : MFunctions::of_earlier,
          due, block};
}

bool ProgramJudge::is_left_at_alarm(Hypothesis& from) {
  FreeStep* open = alignment_.free_step_of(from);
  if (open == nullptr) return false;
  return !open->is_judged_when_left() || open->is_judged_at_alarm(from.at);
}

// R7: an alarm behind an end that no text states, which is no answer to where it stands.
bool ProgramJudge::is_alarm_behind_end(Hypothesis& from, const Alarming& alarming) {
  if (!is_silent_end(reference_.at(from.step).what) || alarming.unfinished) return false;
  if (alarm_without_line(alarming.alarm)) return false;
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

// The program's own alarm, which the message names where a subject's alarm comes before it.
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
                                                  alignment_.may_be_none(step) ||
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
