// SPDX-License-Identifier: GPL-3.0-or-later
//
// A limit that is compared with < for <=, or the other way round: to the reference the word is
// beside its value by less than any tolerance, so that only what lies on a limit comes out another
// way.
#include <fmt/format.h>

#include <array>
#include <set>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

using reference::Number;

// By which a word is moved off a limit.
const Number& trifle() {
  static const Number kTrifle = Number(1) / 1'000'000'000'000;
  return kTrifle;
}

// A larger number lies near the end of what an address may hold, which is a limit of its own.
constexpr int kLargest = 9'000;

// A limit is one of the value or of its size.
struct Move {
  std::string_view name;
  Number (*value)(const Number&);
};
constexpr std::array<Move, 4> kMoves = {{
    {"a trifle larger", [](const Number& value) { return value * (1 + trifle()); }},
    {"a trifle smaller", [](const Number& value) { return value * (1 - trifle()); }},
    {"a trifle farther on", [](const Number& value) { return value + trifle(); }},
    {"a trifle farther back", [](const Number& value) { return value - trifle(); }},
}};

std::optional<std::string> moved(const ProgramText& program, const std::string& address,
                                 const Motions& motions, const Move& move) {
  return edited(
      program, [&](const TextBlock& block, const TextWord& word) -> std::optional<std::string> {
        const bool is_meant = name_of(word) == address && block.code_of(word).empty() &&
                              (motions.empty() || motions.contains(block.modes.code_name()));
        const auto value = is_meant ? exact_value_of(word) : std::nullopt;
        if (!value || abs(*value) > kLargest) return std::nullopt;
        return with_value(word, move.value(*value));
      });
}

// Whether the reference alarms elsewhere, or no more, or only now.
bool alarms_otherwise(const Observation& departure, const std::string& program) {
  const auto before = run_reference(departure.profile, departure.program);
  const auto after = run_reference(departure.profile, program);
  return before && after &&
         (before->end.kind != after->end.kind ||
          before->end.alarm.block != after->end.alarm.block ||
          before->end.alarm.alarm_class != after->end.alarm.alarm_class);
}

void add_limits(const Observation& departure, const std::string& address, const Motions& motions,
                Variants& out) {
  const std::string of = motions.empty() ? "" : " of " + names_of(motions);
  for (const Move& move : kMoves) {
    const ProgramText program(departure.profile, departure.program);
    const auto text = moved(program, address, motions, move);
    if (!text || !alarms_otherwise(departure, *text)) continue;
    out.push_back({fmt::format("{}{} on a limit counts as {}, < for <= or the other way round",
                               address, of, move.name),
                   [=, &move](const Observation& seen) -> std::optional<ChangedRun> {
                     const ProgramText asked(seen.profile, seen.program);
                     auto other = moved(asked, address, motions, move);
                     if (!other) return std::nullopt;
                     return ChangedRun{std::move(*other), seen.profile, seen.outcome, std::nullopt};
                   }});
  }
}

}  // namespace

void add_limit_variants(const Observation& departure, Variants& out) {
  using oracle::VerdictKind;
  const VerdictKind kind = departure.verdict.kind;
  if (kind != VerdictKind::fail_alarm_missing && kind != VerdictKind::fail_alarm_spurious) return;
  const ProgramText program(departure.profile, departure.program);
  for (const std::string& address : addresses_in(program)) {
    add_limits(departure, address, {}, out);
    for (const Motions& motions : motions_concerned(departure)) {
      add_limits(departure, address, motions, out);
    }
  }
}

}  // namespace gonogo::identify
