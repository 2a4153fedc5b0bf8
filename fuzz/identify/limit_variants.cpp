// SPDX-License-Identifier: GPL-3.0-or-later
//
// A limit that is compared with < for <=, or the other way round: to the reference the word is
// beside its value by less than any tolerance, so that only what lies on a limit comes out another
// way.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>

#include "fuzz/identify/variant.hpp"

namespace gonogo::identify {
namespace {

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
  bool keeps_zero;
};
constexpr std::array<Move, 4> kMoves = {{
    {"a trifle larger", [](const Number& value) { return value * (1 + trifle()); }, true},
    {"a trifle smaller", [](const Number& value) { return value * (1 - trifle()); }, true},
    {"a trifle farther on", [](const Number& value) { return value + trifle(); }, false},
    {"a trifle farther back", [](const Number& value) { return value - trifle(); }, false},
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
bool alarms_otherwise(const Observation& seen, const std::string& program) {
  const auto before = run_reference(seen.profile, seen.program);
  const auto after = run_reference(seen.profile, program);
  return before && after &&
         (before->end.kind != after->end.kind ||
          before->end.alarm.block != after->end.alarm.block ||
          before->end.alarm.alarm_class != after->end.alarm.alarm_class);
}

// One word, and how it is moved off the limits that it lies on.
struct Limit {
  std::string address;
  Motions motions;
  const Move* move;

  // Nothing: no alarm hangs on it.
  std::optional<std::string> moved_off(const Observation& seen) const {
    auto text = moved(ProgramText(seen.profile, seen.program), address, motions, *move);
    return text && alarms_otherwise(seen, *text) ? std::move(text) : std::nullopt;
  }
  std::string name() const {
    return fmt::format("{}{} on a limit counts as {}, < for <= or the other way round", address,
                       motions.empty() ? "" : " of " + names_of(motions), move->name);
  }
};

// What a subject does that runs on beyond a limit may be no path of the reference: a pass as deep
// as the one before it. A zero lies on the limit of a rule that may not be checked at all.
bool runs_on(const Limit& limit, const Observation& seen) {
  if (seen.verdict.kind != oracle::VerdictKind::fail_alarm_missing) return false;
  if (!limit.move->keeps_zero) return false;
  const auto text = limit.moved_off(seen);
  const auto after = text ? run_reference(seen.profile, *text) : std::nullopt;
  return after && after->end.alarm.block != seen.alarm;
}

void add_limits(const Observation& departure, const std::string& address, const Motions& motions,
                Variants& out) {
  for (const Move& move : kMoves) {
    const Limit limit{address, motions, &move};
    if (!limit.moved_off(departure)) continue;
    Variant variant;
    variant.name = limit.name();
    variant.apply = [limit](const Observation& seen) {
      return with_program(seen, limit.moved_off(seen));
    };
    variant.holds = [limit](const Observation& seen) { return runs_on(limit, seen); };
    out.push_back(std::move(variant));
  }
}

// The words that its alarms name go first.
std::vector<std::string> words_in_order(const Observation& departure) {
  const auto is_named = [&](const std::string& address) {
    return std::ranges::any_of(departure.alarms, [&](const reference::Alarm& alarm) {
      return alarm.word.text() == address;
    });
  };
  const auto addresses = addresses_in(ProgramText(departure.profile, departure.program));
  std::vector<std::string> words;
  std::ranges::copy_if(addresses, std::back_inserter(words), is_named);
  std::ranges::copy_if(addresses, std::back_inserter(words), std::not_fn(is_named));
  return words;
}

}  // namespace

void add_limit_variants(const Observation& departure, Variants& out) {
  using oracle::VerdictKind;
  const VerdictKind kind = departure.verdict.kind;
  if (kind != VerdictKind::fail_alarm_missing && kind != VerdictKind::fail_alarm_spurious) return;
  for (const std::string& address : words_in_order(departure)) {
    add_limits(departure, address, {}, out);
    for (const Motions& motions : motions_concerned(departure)) {
      add_limits(departure, address, motions, out);
    }
  }
}

}  // namespace gonogo::identify
