// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why the reference does not alarm where a subject does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "oracle/records/subject_outcome.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

// Where a subject alarms: in a block; without line numbers, between the item of the reference (from
// 1) at which it stands and the first that it leaves undone.
struct AlarmPlace {
  std::uint64_t block = 0;  // 0: not known
  std::size_t at = 1;       // the item of the first step that is not done
  bool is_begun = false;    // some of it is
  std::size_t undone = std::numeric_limits<std::size_t>::max();  // the first that had to be
};

struct NoAlarmReason {
  // The clause under which the program is right there: the rule that no text states, if the alarm
  // is its other answer; else that of the block's first record; else that a block can be read.
  reference::ClauseId clause = reference::kNoClause;
  // R7: how the alarm relates to such a rule.
  enum class Answer { none, other, late } answer = Answer::none;
};

// Runs the reference again, up to that place.
NoAlarmReason reason_for_no_alarm(const reference::Profile& profile, const ProgramText& program,
                                  const AlarmPlace& place, std::string_view alarm_class);

}  // namespace gonogo::oracle
