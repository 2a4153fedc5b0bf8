// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of one program under one combination of readings: the subject's records come in, the
// reference runs in parallel, the first departure decides.
#pragma once

#include <optional>
#include <string_view>

#include "oracle/judge/alignment.hpp"
#include "oracle/judge/no_alarm_reason.hpp"
#include "oracle/judge/surplus.hpp"
#include "oracle/motion/plain_motion.hpp"
#include "oracle/motion/progress.hpp"
#include "oracle/open/free_step_memory.hpp"
#include "oracle/records/verdict.hpp"
#include "oracle/steps/program_input.hpp"
#include "oracle/steps/record_budget.hpp"

namespace gonogo::oracle {

class ProgramJudge {
 public:
  // `watched`: the assignments from which the readings of `profile` are taken; null: only these
  // readings count. Everything must outlive the judge.
  ProgramJudge(const reference::Profile& profile, const ProgramText& program,
               const Tolerances& tolerances, const AssignmentSet* watched = nullptr,
               Forking forking = Forking::when_different);
  ProgramJudge(const ProgramJudge&) = delete;
  // The subject's next record. False when nothing it can still send changes the answer.
  bool record(const Record& record);
  // The next record as a line of JSON. True: the reference writes its own record so, and nothing
  // more has to be looked at. Else call `record`.
  bool line(std::string_view line);
  // The subject's end; the verdict.
  Verdict finish(const RunEnd& end);
  // The verdict, once it is decided; a departure from a curve is not explained yet.
  const Verdict& decided() const { return *verdict_; }

  // How far the comparison came, in items of the reference.
  std::size_t progress() const { return departed_at_.value_or(reference_.items()); }
  // The block of what was due where it departed.
  std::uint64_t departed_block() const {
    return departed_at_ ? departed_block_ : (verdict_ ? verdict_->block : 0);
  }
  // Whether nothing that is still to come changes the answer.
  bool is_decided() const { return verdict_.has_value() && !other_order_.shows; }
  // Where it has departed by a motion that may be one too many of an earlier block.
  const std::optional<Surplus>& surplus() const { return surplus_; }
  // The readings that its reference has asked for so far.
  const reference::ReadingsInUse& readings() const { return reference_.readings(); }
  // The alternatives that say something else than its reference so far.
  WatchedReference& watched() { return reference_.watched(); }
  // Whether the record or line that came last is item number `progress` of the reference, as it
  // would be for any subject.
  bool is_in_step() const { return in_step_ && !reference_.was_moved(); }

 private:
  struct SubjectMFunction {
    Record record;
    std::size_t number;
  };

  // Unless it is decided; nothing decides nothing.
  void decide(std::optional<Verdict> verdict);
  void decide_too_many(const Record& record);
  // No hypothesis is left.
  void decide_departure();
  void explain_departure();
  std::string wanted_at(std::size_t number) const;
  void name_line(Verdict& verdict, std::size_t number) const;
  // J-CMP-12: whether a later record shows that what departs is out of order.
  void look_for_order(const Record& record);

  void take_record(const Record& record);
  // Whether it has a line, where the subject declares lines; else that is the verdict.
  bool has_line(const Record& record);
  void take_motion(const Record& record);
  void take_m_function(const Record& record);
  void take_dwell(const Record& record);
  bool makes_progress();
  // Drops the steps that nothing looks back at.
  void forget_passed();

  // While the records of both sides are the same, in equal_steps.cpp. True when that was all.
  bool equal_record(const Record& record);
  bool fall_into_step();
  bool plain_ahead();
  void go_on();
  void leave_step();

  // The end of the subject, in program_end.cpp, program_alarm.cpp and alarm_comparison.cpp.
  struct Ending;
  Ending end_of(Hypothesis from, const RunEnd& end);
  void forget_behind(const Hypothesis& from, bool leaves_out_m_functions);
  Ending ok_end(Hypothesis& from);
  Ending alarm_end(Hypothesis& from, const SubjectAlarm& alarm);
  Ending open_end(const Hypothesis& from, Verdict why_not) const;
  struct Alarming;
  Ending at_alarm(Hypothesis& from, const Alarming& alarming);
  std::optional<Ending> excused_at(Hypothesis from, const Alarming& alarming);
  std::optional<Verdict> compare_alarm(const Hypothesis& from, const Alarming& alarming,
                                       const reference::AlarmReport& report) const;
  std::optional<Verdict> alarm_without_line(const SubjectAlarm& alarm) const;
  Verdict other_class(const Alarming& alarming, const reference::AlarmReport& report) const;
  Verdict spurious_alarm(const Alarming& alarming, std::string message) const;
  NoAlarmReason why_no_alarm(const Alarming& alarming) const;
  bool is_alarm_behind_end(Hypothesis& from, const Alarming& alarming);
  bool is_behind_alarm(const Alarming& alarming, const ReferenceStep& step) const;
  std::optional<reference::AlarmReport> own_alarm() const;
  std::optional<Verdict> alarm_outside(const SubjectAlarm& alarm) const;
  // Whether an open path is looked at where the subject alarms.
  bool is_left_at_alarm(Hypothesis& from);
  std::optional<Verdict> m_functions_before_alarm(const Ending& ending) const;
  std::optional<Verdict> compare_end(const Record& end) const;
  void settle(Ending ending);

  const reference::Profile& profile_;
  const Tolerances& tolerances_;
  ProgramText program_;
  ReferenceSteps reference_;
  FreeStepMemory memory_;
  Alignment alignment_;
  RecordBudget budget_;
  StepProgress step_progress_;
  std::size_t idle_ = 0;    // records that were looked at since the last progress
  bool has_acted_ = false;  // the subject has put out an event that is compared
  std::size_t records_ = 0;

  // While the records of both sides are the same; then the hypothesis is behind.
  struct InStep {
    PlainMotion::Place at = {};
    PlainMotion next;
    const reference::Item* ahead =
        nullptr;  // of the reference: `next`, if `is_plain`; null: not asked
    bool is_plain = false;
    std::size_t coordinates = 0;  // that the reference gives
  };
  std::optional<InStep> in_step_;

  std::optional<Verdict> verdict_;
  bool is_unexplained_ = false;             // of the verdict only the decision is known
  OtherOrder other_order_;                  // of the verdict, while it is looked for
  std::size_t looked_at_ = 0;               // records since then
  std::optional<std::size_t> departed_at_;  // in items
  std::uint64_t departed_block_ = 0;
  std::optional<Surplus> surplus_;
  std::vector<SubjectMFunction> m_functions_of_alarm_;  // which may be of the block that alarms
  std::optional<Record> end_record_;                    // the subject's `end`
};

}  // namespace gonogo::oracle
