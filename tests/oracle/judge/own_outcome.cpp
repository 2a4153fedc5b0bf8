// SPDX-License-Identifier: GPL-3.0-or-later
#include "own_outcome.hpp"

#include <stdexcept>

namespace gonogo::oracle {

reference::Profile profile_of(std::string_view dialect, ReadingValues readings) {
  auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  profile.readings = profile.readings.shown();
  for (const auto& [name, value] : readings) {
    if (set_reading(profile, name, value)) throw std::runtime_error("no such reading");
  }
  return profile;
}

OwnOutcome own_outcome(std::string_view program, const reference::Profile& profile) {
  OwnOutcome outcome;
  ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  while (const reference::Item* item = expander.next()) {
    if (const auto* record = std::get_if<Record>(item)) {
      outcome.records.push_back(*record);
    } else if (const auto* report = std::get_if<reference::AlarmReport>(item)) {
      outcome.end.kind = RunEnd::Kind::alarm;
      outcome.end.alarm.block = report->block;
      outcome.end.alarm.alarm_class = reference::name(report->alarms.front().alarm);
    } else if (std::holds_alternative<reference::NotCovered>(*item)) {
      throw std::runtime_error("not covered");
    }
  }
  return outcome;
}

Tolerances exact_terms(const reference::Profile& profile, std::string_view resolution) {
  SubjectInfo subject;
  subject.features = {"blocks", "m"};
  if (!resolution.empty()) subject.resolution = Number::parse(resolution);
  return make_tolerances(subject, profile);
}

Verdict judge_own(std::string_view program, const reference::Profile& profile,
                  std::string_view resolution) {
  const OwnOutcome own = own_outcome(program, profile);
  const Tolerances tolerances = exact_terms(profile, resolution);
  return judge_outcome(profile, program, tolerances, own.records, own.end).verdict;
}

}  // namespace gonogo::oracle
