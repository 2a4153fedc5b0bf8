// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/verdict_ranking.hpp"

#include <fmt/format.h>

namespace gonogo::oracle {

// R9.
bool outranks(const SampledVerdict& one, const SampledVerdict& other) {
  const auto rank = [](const SampledVerdict& said) {
    switch (decision(said.verdict.kind)) {
      case Decision::go:
        return 3;
      case Decision::undecided:
        return 2;
      case Decision::neither:
        return 1;
      case Decision::no_go:
        return 0;
    }
    return 0;
  };
  if (rank(one) != rank(other)) return rank(one) > rank(other);
  if (rank(one) == 3) return one.verdict.kind < other.verdict.kind;
  if (rank(one) > 1) return false;
  if (one.block != other.block) return one.block > other.block;
  if (one.progress != other.progress) return one.progress > other.progress;
  // Where one alternative alarms and another has no fault, the former describes an alarm.
  const auto is_far_from = [](const SampledVerdict& said) {
    switch (said.verdict.kind) {
      case VerdictKind::fail_alarm_missing:
      case VerdictKind::fail_alarm_late:
        return 2;
      case VerdictKind::fail_alarm_spurious:
        return 1;
      default:
        return 0;
    }
  };
  return is_far_from(one) < is_far_from(other);
}

// J-READ-01.
void name_readings(const std::string& told_under, Verdict& verdict) {
  const bool departs =
      decision(verdict.kind) == Decision::no_go || verdict.kind == VerdictKind::advice;
  if (!departs || told_under.empty()) return;
  verdict.told_under = told_under;
  verdict.message +=
      fmt::format("{}That is as {} has it.", verdict.message.empty() ? "" : " ", told_under);
}

bool runs_on(const Verdict& said) {
  return said.kind == VerdictKind::advice && (said.departure == VerdictKind::fail_alarm_missing ||
                                              said.departure == VerdictKind::fail_alarm_late);
}

namespace {

// It comes behind the alarm, or in its block and at no alarm.
bool shows_how_to_run_on(const Verdict& departure, const Verdict& best) {
  if (departure.block == 0 || departure.block > best.block) return true;
  return departure.block == best.block && rule_of(departure) != RelationRule::alarm;
}

}  // namespace

const SampledVerdict* shown_way_to_run_on(const SampledVerdict& best,
                                          std::span<const SampledVerdict> departures) {
  if (!runs_on(best.verdict)) return nullptr;
  const SampledVerdict* shown = nullptr;
  for (const SampledVerdict& departure : departures) {
    if (!shows_how_to_run_on(departure.verdict, best.verdict)) continue;
    if (shown == nullptr || outranks(departure, *shown)) shown = &departure;
  }
  return shown;
}

}  // namespace gonogo::oracle
