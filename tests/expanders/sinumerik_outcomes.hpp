// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of what the expanders of SINUMERIK make of a program.
#pragma once

#include <string>
#include <string_view>

#include "harness.hpp"

namespace gonogo::expanders::testing {

/// For sinumerik840d: the motions, and the class of the alarm.
inline std::string motions_and_alarm(std::string_view program, std::string_view profile = "{}") {
  const Outcome outcome = run_sinumerik(program, profile);
  return outcome.motions() + outcome.alarm;
}

/// For sinumerik840d: the last motion; the class of the alarm and the note where there is none.
inline std::string last_motion_or_alarm(std::string_view program, std::string_view profile = "{}") {
  const Outcome outcome = run_sinumerik(program, profile);
  if (!outcome.alarm.empty() || outcome.records.size() < 2) return outcome.alarm + outcome.note;
  return outcome.records[outcome.records.size() - 2];
}

/// For sinumerik802s: the class of the alarm and its block; "" without one.
inline std::string alarm_and_block(std::string_view program, std::string_view profile = "{}") {
  const Outcome outcome = run_sinumerik802s(program, profile);
  return outcome.alarms == 0 ? "" : outcome.alarm + " " + std::to_string(outcome.alarm_block);
}

}  // namespace gonogo::expanders::testing
