// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/verdict.hpp"

#include <algorithm>
#include <array>

namespace gonogo::oracle {
namespace {

constexpr std::array<std::string_view, 28> kNames = {"pass-exact",
                                                     "pass-rounded",
                                                     "pass-tolerance",
                                                     "pass-properties",
                                                     "xfail",
                                                     "skip",
                                                     "advice",
                                                     "fail.geometry",
                                                     "fail.order",
                                                     "fail.feed",
                                                     "fail.region",
                                                     "fail.reading",
                                                     "fail.overrun",
                                                     "fail.alarm-missing",
                                                     "fail.alarm-spurious",
                                                     "fail.alarm-class",
                                                     "fail.alarm-late",
                                                     "fail.declaration",
                                                     "state-leak",
                                                     "crash",
                                                     "timeout",
                                                     "out-of-memory",
                                                     "protocol",
                                                     "unmapped-alarm",
                                                     "xpass",
                                                     "oracle-gap",
                                                     "oracle-error",
                                                     ""};

constexpr std::array<std::string_view, 9> kRules = {"",   "R1", "R2", "R3", "R4",
                                                    "R5", "R6", "R7", "R8"};

// The rule that a kind is the name of.
RelationRule rule_of_kind(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fail_geometry:
      return RelationRule::place;
    case VerdictKind::fail_feed:
      return RelationRule::label;
    case VerdictKind::fail_order:
    case VerdictKind::fail_overrun:
      return RelationRule::event;
    case VerdictKind::fail_region:
      return RelationRule::free_step;
    case VerdictKind::fail_alarm_missing:
    case VerdictKind::fail_alarm_spurious:
    case VerdictKind::fail_alarm_class:
    case VerdictKind::fail_alarm_late:
    case VerdictKind::unmapped_alarm:
      return RelationRule::alarm;
    default:
      return RelationRule::none;
  }
}

}  // namespace

std::string_view name(VerdictKind kind) {
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<VerdictKind> verdict_kind(std::string_view name) {
  for (std::size_t i = 0; !kNames[i].empty(); ++i) {
    if (kNames[i] == name) return static_cast<VerdictKind>(i);
  }
  return std::nullopt;
}

Decision decision(VerdictKind kind) {
  if (kind < VerdictKind::xfail) return Decision::go;
  if (kind <= VerdictKind::advice) return Decision::neither;
  return kind < VerdictKind::oracle_gap ? Decision::no_go : Decision::undecided;
}

std::span<const std::string_view> verdict_names() {
  return std::span(kNames).first(kNames.size() - 1);
}

std::string_view name(RelationRule rule) {
  return kRules[static_cast<std::size_t>(rule)];
}

std::string rule_text(std::string_view name) {
  constexpr std::array<std::string_view, 9> kTitles = {
      "", "correspondence", "place", "label", "traverse", "event", "alarm", "silence", "free step"};
  std::string text(name);
  const auto place = static_cast<std::size_t>(std::ranges::find(kRules, name) - kRules.begin());
  if (name.empty() || place == kRules.size()) return text;
  return text.append(" (").append(kTitles[place]).append(")");
}

RelationRule rule_of(const Verdict& verdict) {
  if (verdict.kind == VerdictKind::advice) return RelationRule::silence;
  const bool is_known = verdict.kind == VerdictKind::xfail && verdict.departure;
  const VerdictKind kind = is_known ? *verdict.departure : verdict.kind;
  if (decision(kind) != Decision::no_go) return RelationRule::none;
  return verdict.rule != RelationRule::none ? verdict.rule : rule_of_kind(kind);
}

Verdict gap_verdict(GapReason reason, std::string message) {
  Verdict verdict;
  verdict.kind = VerdictKind::oracle_gap;
  verdict.gap = reason;
  verdict.message = std::move(message);
  return verdict;
}

}  // namespace gonogo::oracle
