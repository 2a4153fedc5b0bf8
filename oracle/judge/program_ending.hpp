// SPDX-License-Identifier: GPL-3.0-or-later
//
// What ProgramJudge's files on the subject's end share: program_end.cpp, program_alarm.cpp and
// alarm_comparison.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "oracle/judge/program_judge.hpp"
#include "oracle/steps/reference_steps.hpp"

namespace gonogo::oracle {

struct ProgramJudge::Ending {
  Hypothesis from;
  std::optional<Verdict> verdict = {};  // nothing: GO
  // Which M functions are judged first, of the first `m_functions` due: before an alarm all but
  // those that its block names; where the subject runs on (R7), those of earlier blocks.
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

// The answer to an alarm of the reference.
Verdict alarm_verdict(VerdictKind kind, const reference::AlarmReport& report, std::string message);

// R7: to run on is the other answer to each rule that is an alarm. The reference ends there.
Verdict ran_on(Verdict missing, const Tolerances& tolerances);

bool is_record_end(const ReferenceStep& step);

}  // namespace gonogo::oracle
