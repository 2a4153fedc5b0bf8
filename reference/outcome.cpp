// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/outcome.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace gonogo::reference {
namespace {

// What the trace does not show counts, too, where a verdict depends on it.
bool is_the_same(const Record& a, const Record& b) {
  return a.kind == b.kind && a.feed_mode == b.feed_mode && a.plane == b.plane && a.axes == b.axes &&
         a.rot == b.rot && a.m == b.m && a.before_cut == b.before_cut &&
         a.among_motions == b.among_motions && a.block == b.block &&
         a.centre_clause == b.centre_clause && a.to == b.to && a.feed == b.feed &&
         a.centre == b.centre && a.lead == b.lead && a.start == b.start && a.seconds == b.seconds &&
         a.via_axes == b.via_axes && a.via == b.via && is_silent(a.clause) == is_silent(b.clause);
}

// Which clause of a text it is does not matter; that of an unstated rule says what it excuses.
std::set<std::pair<AlarmClass, ClauseId>> admitted_by(const AlarmReport& report) {
  std::set<std::pair<AlarmClass, ClauseId>> admitted;
  for (const Alarm& alarm : report.alarms) {
    admitted.emplace(alarm.alarm, is_silent(alarm.clause) ? alarm.clause : kNoClause);
  }
  for (const AdmittedClass& one : admitted_classes(report)) {
    if (one.of->alarm != one.alarm) admitted.emplace(one.alarm, kNoClause);
  }
  return admitted;
}

bool is_the_same(const AlarmReport& a, const AlarmReport& b) {
  return a.block == b.block && admitted_by(a) == admitted_by(b);
}

bool is_the_same(const NotCovered& a, const NotCovered& b) {
  return a.block == b.block && a.code == b.code;
}

template <typename Open>
bool is_the_same(const Open& a, const Open& b) {
  return a == b;
}

}  // namespace

std::vector<AdmittedClass> admitted_classes(const AlarmReport& report) {
  std::vector<AdmittedClass> admitted;
  AlarmClasses seen;
  const auto take = [&](AlarmClass alarm, const Alarm& of) {
    if (seen.has(alarm)) return;
    seen.add(alarm);
    admitted.push_back({alarm, &of});
  };
  for (const Alarm& alarm : report.alarms) take(alarm.alarm, alarm);
  for (const Alarm& alarm : report.alarms) {
    for (std::size_t i = 0; i < kAlarmClasses; ++i) {
      const auto other = static_cast<AlarmClass>(i);
      if (alarm.also.has(other)) take(other, alarm);
    }
  }
  return admitted;
}

bool admits(const AlarmReport& report, std::string_view classes) {
  return std::ranges::any_of(admitted_classes(report), [&](const AdmittedClass& one) {
    return has_name(classes, name(one.alarm));
  });
}

bool says_the_same(const Item& a, const Item& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&](const auto& one) { return is_the_same(one, std::get<std::decay_t<decltype(one)>>(b)); },
      a);
}

}  // namespace gonogo::reference
