// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for the subject's end: complete, too early, with an alarm, or not at all.
#include <fmt/format.h>

#include <algorithm>

#include "oracle/judge/advice.hpp"
#include "oracle/judge/alarm_ground.hpp"
#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"
#include "oracle/judge/standing.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;
using reference::PocketLevel;

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
  verdict.clause = firmest(report).clause;  // J-ALM-02
  verdict.word = report.alarms.front().word;
  verdict.want = alarms_text(report);
  verdict.message = std::move(message);
  return verdict;
}

// Of an alarm for which the reference has none.
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

Verdict ProgramJudge::finish(const RunEnd& end) {
  try {
    leave_step(records_ - 1);
    if (!verdict_) flush_pending();
    if (!verdict_) {
      switch (end.kind) {
        case RunEnd::Kind::ok:
          judge_ok_end();
          break;
        case RunEnd::Kind::alarm:
          judge_alarm_end(end.alarm);
          break;
        default:
          judge_other_end(end);
          break;
      }
    }
  } catch (const exact::Undecided& undecided) {
    decide_undecided(undecided);
  }
  if (verdict_) return *verdict_;
  if (advice_) return *advice_;
  Verdict verdict;
  // J-CMP-09.
  verdict.property_motions = property_motions_;
  verdict.kind = property_motions_ > 0 ? VerdictKind::pass_properties
                 : exact_              ? VerdictKind::pass_exact
                 : rounded_            ? VerdictKind::pass_rounded
                                       : VerdictKind::pass_tolerance;
  return verdict;
}

void ProgramJudge::judge_other_end(const RunEnd& end) {
  Verdict verdict;
  verdict.kind = kind_of(end.kind);
  verdict.feature = end.feature;
  verdict.message = end.message;
  decide(std::move(verdict));
}

// The trace stops although the reference goes on with `step`.
void ProgramJudge::ends_early(const ReferenceStep& step, const std::string& got) {
  auto* want = std::get_if<Motion>(&step);
  if (const Motion* piece = piece_before(); piece != nullptr && want != nullptr) {
    return decide(short_of(*want, *piece));
  }
  Verdict verdict;
  verdict.kind = VerdictKind::fail_geometry;
  verdict.got = got;
  verdict.clause = clause_of(step);
  verdict.block = block_of(step);
  verdict.want = step_text(step);
  verdict.witness = point_text(position_, {Axis::x, Axis::y, Axis::z});
  verdict.record = records_;
  verdict.message = "The trace ends before this motion.";
  decide(std::move(verdict));
}

// J-CMP-07.
void ProgramJudge::compare_end(const Record& end) {
  settle_m_functions(true);
  if (verdict_ || !end_record_) return;
  for (Axis axis : reference::kAllAxes) {
    if (!end_record_->axes.has(axis)) continue;
    if (agree(end_record_->to[axis], end.to[axis], terms_.tolerance)) continue;
    Verdict verdict;
    verdict.kind = VerdictKind::fail_geometry;
    verdict.record = records_ - 1;
    verdict.want = record_text(end);
    verdict.got = record_text(*end_record_);
    const Number deviation = abs(end_record_->to[axis] - end.to[axis]);
    verdict.deviation_exact = exact_text(deviation);
    verdict.deviation_mm = millimetres_text(deviation);
    verdict.message = fmt::format("The end position differs on axis {}.", letter(axis));
    decide(std::move(verdict));
    return;
  }
}

void ProgramJudge::judge_ok_end() {
  while (!verdict_) {
    const ReferenceStep& step = reference_.current();
    if (auto* report = std::get_if<AlarmReport>(&step)) {
      Verdict verdict =
          alarm_verdict(VerdictKind::fail_alarm_missing, *report,
                        fmt::format("The alarm is missing: {}", report->alarms.front().message));
      if (is_advice(verdict, terms_)) {
        // J-ALM-04: the reference ends here, and what the subject goes on to do has no measure.
        verdict.message += " What the subject does after it is not judged.";
        settle_m_functions_of_earlier(report->block);
      }
      if (after_alarm_) {
        verdict.record = after_alarm_->number;
        verdict.got = record_text(after_alarm_->record);
      }
      decide(std::move(verdict));
    } else if (auto* outside = std::get_if<NotCovered>(&step)) {
      decide_not_covered(*outside);
    } else if (auto* level = std::get_if<PocketLevel>(&step)) {
      finish_level(*level, position_);
    } else if (end_open_path(position_)) {
      continue;
    } else if (std::optional<Verdict> unfinished = unfinished_open_path()) {
      decide(*std::move(unfinished));
    } else if (auto* renaming = std::get_if<reference::Renaming>(&step)) {
      rename(*renaming);
    } else if (auto* record = std::get_if<Record>(&step)) {
      if (placed_m_function(step) != nullptr) {
        m_function_is_due(*record, nullptr, records_);
      } else if (record->kind == RecordKind::m) {
        take_m_functions();
      } else if (record->kind == RecordKind::end) {
        compare_end(*record);
        return;
      } else {
        ends_early(step, "end");
      }
    } else if (reached(std::get<Motion>(step), position_)) {
      match_.reset();
      reference_.advance();
    } else {
      ends_early(step, "end");
    }
  }
}

bool ProgramJudge::is_of_block(const SubjectAlarm& alarm, const Motion& motion) const {
  return !terms_.compare_blocks || alarm.block == motion.record.block;
}

// The clause under which the program is right where the subject alarms: a rule that no text states,
// if the block runs on by one (J-ALM-05), else that of its first record (J-ALM-06).
Verdict ProgramJudge::spurious_alarm(const SubjectAlarm& alarm,
                                     const std::optional<Unfinished>& unfinished,
                                     std::string message) {
  Verdict verdict = alarm_verdict(VerdictKind::fail_alarm_spurious, alarm, std::move(message));
  AlarmPlace place;
  if (terms_.compare_blocks) place.block = alarm.block;
  place.behind = reference_.passed();
  if (unfinished) {
    // Of motions that are joined it may have made the first.
    auto* motion = std::get_if<Motion>(&unfinished->step);
    const bool is_begun = motion == nullptr || !same_place(position_, motion->from, terms_);
    place.before = is_begun ? unfinished->items + 1 : motion->number;
  }
  verdict.clause = clause_of_right(profile_, program_, place);
  return verdict;
}

// J-ALM-04: what departs in motion, or in M functions, before an alarm that no text states goes
// first.
void ProgramJudge::conclude_alarm(std::optional<Verdict> departure, const SubjectAlarm& alarm,
                                  std::uint64_t block, const std::optional<Unfinished>& unfinished,
                                  bool at_load) {
  if (departure && !is_advice(*departure, terms_)) return decide(*std::move(departure));
  const bool is_before = unfinished && (!departure || block_of(unfinished->step) < block);
  if (is_before) return ends_early(unfinished->step, alarm_text(alarm));
  if (!departure) return settle_m_functions_before(block, at_load);
  if (!at_load) settle_m_functions_of_earlier(block);
  decide(*std::move(departure));
}

// J-CMP-08. Nothing where the subject's alarm is one that the reference's admits.
std::optional<Verdict> ProgramJudge::compare_alarm(const SubjectAlarm& alarm,
                                                   const AlarmReport& report,
                                                   const std::optional<Unfinished>& unfinished) {
  auto verdict = [&](VerdictKind kind, std::string message) {
    Verdict result = alarm_verdict(kind, report, std::move(message));
    result.got = alarm_text(alarm);
    return result;
  };
  if (after_alarm_) {
    Verdict late = alarm_verdict(VerdictKind::fail_alarm_late, report,
                                 "Motion was put out in or after the block that alarms.");
    late.record = after_alarm_->number;
    late.got = record_text(after_alarm_->record);
    return late;
  }
  if (terms_.compare_blocks && alarm.block != report.block) {
    if (alarm.block < report.block) {
      Verdict early =
          spurious_alarm(alarm, unfinished, "The alarm comes in a block before the right one.");
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
  const bool admissible = std::ranges::any_of(report.alarms, [&](const reference::Alarm& want) {
    return reference::name(want.alarm) == alarm.alarm_class;
  });
  if (admissible) return std::nullopt;
  return verdict(VerdictKind::fail_alarm_class,
                 fmt::format("The alarm is of another class. {}", report.alarms.front().message));
}

// An alarm outside the program.
void ProgramJudge::refuse_alarm_outside(const SubjectAlarm& alarm) {
  if (end_record_) {
    decide(
        alarm_verdict(VerdictKind::fail_overrun, alarm, "An alarm follows the end of the trace."));
  } else if (alarm.before_program) {
    decide(alarm_verdict(VerdictKind::fail_alarm_spurious, alarm,
                         "The alarm comes before the program, in a line that leads to its start."));
  }
}

void ProgramJudge::judge_alarm_end(const SubjectAlarm& alarm) {
  refuse_alarm_outside(alarm);
  // A controller that checks at load may alarm with no motion at all.
  const bool at_load = profile_.alarm_timing == reference::AlarmTiming::program && !moved_;
  std::optional<Unfinished> unfinished;
  while (!verdict_) {
    const ReferenceStep& step = reference_.current();
    if (auto* report = std::get_if<AlarmReport>(&step)) {
      const AlarmReport right = *report;
      std::optional<Verdict> departure = compare_alarm(alarm, right, unfinished);
      const bool is_early = departure && departure->kind == VerdictKind::fail_alarm_spurious;
      const std::uint64_t block = is_early ? alarm.block : right.block;
      return conclude_alarm(std::move(departure), alarm, block, unfinished, at_load);
    }
    if (auto* outside = std::get_if<NotCovered>(&step)) {
      decide_not_covered(*outside);
      return;
    }
    auto* level = std::get_if<PocketLevel>(&step);
    if (level != nullptr && !at_load && (!level_motions_.empty() || needs_no_motion(*level))) {
      finish_level(*level, position_);
      continue;
    }
    if (!at_load && end_open_path(position_)) continue;
    auto* record = std::get_if<Record>(&step);
    if (record != nullptr && record->kind == RecordKind::end) {
      Verdict departure =
          spurious_alarm(alarm, unfinished, "The subject alarms, and the program has no fault.");
      return conclude_alarm(std::move(departure), alarm, alarm.block, unfinished, at_load);
    }
    if (auto* renaming = std::get_if<reference::Renaming>(&step)) {
      rename(*renaming);
      continue;
    }
    auto* motion = std::get_if<Motion>(&step);
    if (motion != nullptr && !unfinished && reached(*motion, position_)) {
      match_.reset();
      reference_.advance();
      continue;
    }
    // Past motion that is missing, only the alarm of the program is of interest.
    if (at_load || unfinished) {
      if (at_load && is_m_function(step)) want_m_.push_back(*record);
      reference_.advance();
    } else if (is_m_function(step) && placed_m_function(step) == nullptr) {
      take_m_functions();
    } else if (motion != nullptr && is_of_block(alarm, *motion) &&
               hangs_on_rounding(*motion, terms_.tolerance)) {
      decide_gap(kPointsNearlyInLine);
    } else {
      unfinished = Unfinished{step, reference_.items()};
      reference_.advance();
    }
  }
}

}  // namespace gonogo::oracle
