// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rule of the manual that is not checked: what should alarm is run. What the subject then does no
// text says, so that these are held against verdicts and not against a path.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

using reference::Alarm;
using reference::AlarmClass;

// The alarms that one check raises.
struct Check {
  AlarmClass alarm;
  reference::ClauseId clause;
  std::string word;  // that is missing; empty: of any word

  bool raises(const Alarm& one) const {
    return one.alarm == alarm && one.clause == clause && (word.empty() || word == one.word.text());
  }
};

std::string missing_word(const Alarm& alarm) {
  return alarm.alarm == AlarmClass::missing_word ? std::string(alarm.word.text()) : std::string();
}

bool raises_all(const Check& check, const Observation& seen) {
  return !seen.alarms.empty() &&
         std::ranges::all_of(seen.alarms, [&](const Alarm& alarm) { return check.raises(alarm); });
}

// Where another rule is broken as well, the subject may have reported that one.
void add_check(std::string name, const Check& check, Variants& out) {
  Variant variant;
  variant.name = std::move(name);
  variant.holds = [check](const Observation& seen) {
    if (!seen.departs()) return !raises_all(check, seen);
    return seen.verdict.kind == oracle::VerdictKind::fail_alarm_missing && raises_all(check, seen);
  };
  out.push_back(std::move(variant));
}

}  // namespace

void add_alarm_variants(const Observation& departure, Variants& out) {
  if (departure.verdict.kind != oracle::VerdictKind::fail_alarm_missing) return;
  for (const Alarm& alarm : departure.alarms) {
    const std::string id(reference::clause(alarm.clause).id);
    const std::string word = missing_word(alarm);
    add_check(word.empty() ? fmt::format("{} of {} is not checked", name(alarm.alarm), id)
                           : fmt::format("{} does without {}", id, word),
              {alarm.alarm, alarm.clause, word}, out);
    if (!word.empty()) {
      add_check(fmt::format("{} of {} is not checked", name(alarm.alarm), id),
                {alarm.alarm, alarm.clause, {}}, out);
    }
  }
}

}  // namespace gonogo::identify
