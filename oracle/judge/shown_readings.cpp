// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/shown_readings.hpp"

#include "oracle/judge/judge_session.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {
namespace {

bool ends_in_alarm(const reference::Profile& profile, const ProgramText& program) {
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::judged);
  try {
    while (const reference::Item* item = expander.next()) {
      if (std::holds_alternative<reference::AlarmReport>(*item)) return true;
    }
  } catch (const exact::Undecided&) {
    // It ends there, without an alarm.
  }
  return false;
}

}  // namespace

reference::Profile profile_to_show(const reference::Profile& profile, const ProgramText& program) {
  if (!AssignmentSet(profile).leaves_open() || !ends_in_alarm(profile, program)) return profile;
  const auto different = different_assignments(profile, program);
  if (!different) return profile;
  for (const AssignmentSet& set : *different) {
    reference::Profile assigned = profile;
    assigned.readings = set.taken();
    if (!ends_in_alarm(assigned, program)) return assigned;
  }
  return profile;
}

}  // namespace gonogo::oracle
