// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge held to the definition on all that there is: hours, so that no test of every run is
// made of it. GONOGO_TRIALS says how many of each, GONOGO_SEED which, --gtest_filter what,
// GONOGO_ONLY a part of the ids, GONOGO_ROUND that one round trace in so many is taken.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "changes.hpp"
#include "comparison.hpp"
#include "corpus/io/corpus.hpp"
#include "expanders/registry.hpp"
#include "subjects/make_subject.hpp"
#include "tests/oracle/judge/generated_outcomes.hpp"
#include "tests/oracle/mutations/operator.hpp"

namespace gonogo::relation {
namespace {

using reference::Record;

constexpr std::size_t kMostRecords = 300;
constexpr double kMostRadius = 50'000;  // tau

// In how many lines the definition cuts the arcs of a trace, about; each takes it a hundred times
// as long as a line of its own.
double lines_of_arcs(std::span<const Record> records, const reference::Profile& profile) {
  const double tau = mutations::value_of(profile.resolution());
  double lines = 0;
  for (const Record& record : records) {
    if (record.kind == reference::RecordKind::arc3) lines += 1'000;
    if (record.kind != reference::RecordKind::arc) continue;
    const reference::PlaneAxes axes = reference::axes_of(record.plane);
    const double radius = std::hypot(mutations::value_of(record.to[axes.p] - record.centre[0]),
                                     mutations::value_of(record.to[axes.q] - record.centre[1]));
    lines += std::abs(static_cast<double>(record.rot)) * std::sqrt(40 * radius / tau);
    // The cover of a level is decided on a raster all along its border.
    if (radius > kMostRadius * tau) lines = std::numeric_limits<double>::infinity();
  }
  return lines;
}

// As the bench leaves them out (J-PROP-07): a thread to a place so far away has a hundred thousand
// turns under another reading.
bool is_far(std::span<const Record> records) {
  constexpr double kFar = 10'000;  // mm
  return std::ranges::any_of(records, [](const Record& record) {
    return std::ranges::any_of(reference::kLinearAxes, [&](reference::Axis axis) {
      return std::abs(mutations::value_of(record.to[axis])) > kFar;
    });
  });
}

// What takes no longer than a second or so; of what has arcs one in so many.
bool is_short(std::span<const Record> records, const reference::Profile& profile) {
  static const char* const text = std::getenv("GONOGO_ROUND");
  static const long one_in = text == nullptr ? 1 : std::atol(text);
  static long round = 0;
  constexpr double kMostLines = 1'500;
  const double lines = lines_of_arcs(records, profile);
  if (lines > 0 && is_far(records)) return false;
  if (records.size() > kMostRecords || lines > kMostLines) return false;
  return lines == 0 || round++ % one_in == 0;
}

bool is_wanted(std::string_view id) {
  const char* const only = std::getenv("GONOGO_ONLY");
  return only == nullptr || id.find(only) != std::string_view::npos;
}

void print_now_and_then(const Comparison& comparison) {
  constexpr long kOften = 1'000;
  if (comparison.traces() % kOften == 0) comparison.print();
}

const oracle::Corpus& corpus() {
  static const oracle::Corpus all(std::string(GONOGO_SOURCE_DIR) + "/corpus");
  return all;
}

// Calls `visit` with each case under each combination of its readings, and what the corpus expects.
template <typename Visit>
void each_expectation(const Visit& visit) {
  corpus().for_each([&](const oracle::Case& test) {
    if (!is_wanted(test.id)) return;
    for (const oracle::Expectation& expected : test.expect) {
      if (expected.not_covered || !is_short(expected.records, test.profile)) continue;
      reference::Profile profile = test.profile;
      for (const auto& [name, value] : expected.when) set_reading(profile, name, value);
      oracle::RunEnd end;
      if (!expected.alarms.empty()) {
        end.kind = oracle::RunEnd::Kind::alarm;
        end.alarm.block = expected.alarms.front().block;
        end.alarm.alarm_class = name(expected.alarms.front().alarm);
      }
      visit(test, profile, expected.records, end);
    }
  });
}

TEST(WholeSweep, WhatTheCorpusExpects) {
  Comparison comparison;
  each_expectation([&](const oracle::Case& test, const reference::Profile& profile,
                       const std::vector<Record>& records, const oracle::RunEnd& end) {
    const oracle::Tolerances tolerances = tolerances_for(profile, true, true);
    comparison.compare({test.id, test.program, profile, tolerances}, "right", records, end);
    print_now_and_then(comparison);
  });
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

// Each expectation changed in as many ways as come on each.
TEST(WholeSweep, WhatTheCorpusExpectsChanged) {
  Comparison comparison;
  const long wanted = trial_count(200'000);
  Chance chance(trial_seed());
  while (comparison.traces() < wanted) {
    each_expectation([&](const oracle::Case& test, const reference::Profile& profile,
                         const std::vector<Record>& records, const oracle::RunEnd& end) {
      if (comparison.traces() >= wanted || !chance.once_in(4)) return;
      const Change& change = chance.one_of(changes());
      const oracle::Tolerances tolerances =
          tolerances_for(profile, !chance.once_in(4), !chance.once_in(8));
      std::vector<Record> changed = records;
      if (!change.apply(changed, tolerances.tolerance, chance)) return;
      comparison.compare({test.id, test.program, profile, tolerances}, change.name, changed, end);
      print_now_and_then(comparison);
    });
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

// The mutants of the mutation bench.
TEST(WholeSweep, Mutants) {
  Comparison comparison;
  const long wanted = trial_count(66'000);
  Chance chance(trial_seed());
  const mutations::RawCases cases = mutations::cases_of_corpus(GONOGO_SOURCE_DIR "/corpus");
  const std::vector<mutations::Operator> operators = mutations::wrong_operators();
  while (comparison.traces() < wanted) {
    for (const auto& [group, raw_cases] : cases) {
      const mutations::RawCase& raw = chance.one_of(raw_cases);
      if (!is_wanted(raw.id)) continue;
      const auto specimen =
          mutations::make_specimen(raw, chance.one_of(raw.assignments), kMostRecords);
      if (specimen == nullptr || !is_short(specimen->right.records, specimen->profile)) continue;
      for (const mutations::Operator& change : operators) {
        mutations::Edit edit(*specimen, chance);
        if (!change.apply(edit)) continue;
        comparison.compare(
            {specimen->id, specimen->program, specimen->profile, specimen->tolerances}, change.name,
            edit.trace.records, edit.trace.end);
        print_now_and_then(comparison);
      }
    }
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

bool is_answer(const oracle::RunEnd& end) {
  return end.kind == oracle::RunEnd::Kind::ok || end.kind == oracle::RunEnd::Kind::alarm;
}

// What the expander with the fault does with a program; nothing where it is no answer.
void try_fault(const gonogo_subject_v1& table, std::string_view fault, const oracle::Case& test,
               Comparison& comparison) {
  const auto subject = oracle::make_interface_subject(table);
  subject->configure(test.profile);
  std::vector<Record> records;
  const oracle::RunEnd end = subject->run(test.id, test.program, [&](const Record& record) {
    records.push_back(record);
    return records.size() < kMostRecords;
  });
  if (!is_answer(end) || !is_short(records, test.profile)) return;
  const oracle::Tolerances tolerances = make_tolerances(subject->info(), test.profile);
  comparison.compare({test.id, test.program, test.profile, tolerances}, fault, records, end);
  print_now_and_then(comparison);
}

std::string_view expander_of(std::string_view dialect) {
  return generate::generator_of(dialect).expander;
}

TEST(WholeSweep, PlantedFaults) {
  Comparison comparison;
  const long wanted = trial_count(100'000);
  Chance chance(trial_seed());
  while (comparison.traces() < wanted) {
    corpus().for_each([&](const oracle::Case& test) {
      if (comparison.traces() >= wanted || !is_wanted(test.id)) return;
      const std::string_view name = expander_of(test.dialect);
      const std::string_view fault = chance.one_of(expanders::faults(name)).name;
      try_fault(*expanders::find(name, fault), fault, test, comparison);
    });
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

// Generated programs by expanders with faults and without, half of them with a record changed.
TEST(WholeSweep, Generated) {
  Comparison comparison;
  const long wanted = trial_count(500'000);
  Chance chance(trial_seed());
  while (comparison.traces() < wanted) {
    for (const generate::Generator& generator : generate::generators()) {
      if (!is_wanted(generator.dialect)) continue;
      const auto made = oracle::generated_outcome(generator, {}, chance.choices());
      if (!is_answer(made.outcome.end) || !is_short(made.outcome.records, made.program.profile))
        continue;
      comparison.compare(
          {generator.dialect, made.program.text, made.program.profile, made.tolerances},
          "generated", made.outcome.records, made.outcome.end);
      print_now_and_then(comparison);
    }
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

}  // namespace
}  // namespace gonogo::relation
