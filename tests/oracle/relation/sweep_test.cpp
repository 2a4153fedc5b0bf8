// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge held to the definition: on what the corpus expects, and on traces with one thing
// changed. GONOGO_TRIALS says how many.
#include <gtest/gtest.h>

#include <algorithm>

#include "changes.hpp"
#include "comparison.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::relation {
namespace {

using reference::Record;
using reference::RecordKind;

// A case under one combination of its readings, with the trace that the corpus expects.
struct Specimen {
  std::string id;
  std::string program;
  reference::Profile profile;
  Trace right;
};

constexpr std::size_t kMostRecords = 40;
// A curve takes the definition a hundred times as long as a line: one case in so many.
constexpr std::size_t kRoundCases = 48;
// The definition looks at each combination of open readings: they are left open in one case of so
// many, and in none with curves.
constexpr std::size_t kOpenCases = 16;

const exact::Number kLeastRing = exact::Number(1) / 100;  // mm

bool is_round(const Record& record) {
  return record.kind == RecordKind::arc || record.kind == RecordKind::arc3;
}

// A pocket of inches takes the definition hours, and so do a hundred thousand turns. A ring of an
// increment takes it minutes: the tool covers all of the level from each place of the ring.
bool is_long(const Record& record) {
  constexpr std::int32_t kMostTurns = 20;
  if (record.kind != RecordKind::arc) return false;
  const auto axes = reference::axes_of(record.plane);
  const exact::Number p = abs(record.to[axes.p] - record.centre[0]);
  const exact::Number q = abs(record.to[axes.q] - record.centre[1]);
  const bool is_point = p < kLeastRing && q < kLeastRing;
  return p > 100 || is_point || record.rot > kMostTurns || record.rot < -kMostTurns;
}

std::vector<Specimen> specimens() {
  std::vector<Specimen> all;
  std::size_t round = 0;
  oracle::Corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus")
      .for_each([&](const oracle::Case& test) {
        for (const oracle::Expectation& expected : test.expect) {
          if (expected.not_covered || expected.records.size() > kMostRecords) continue;
          if (std::ranges::any_of(expected.records, is_long)) continue;
          const bool has_curves = std::ranges::any_of(expected.records, is_round);
          if (has_curves && round++ % kRoundCases != 0) continue;
          Specimen specimen{test.id, test.program, test.profile, {expected.records, {}}};
          for (const auto& [name, value] : expected.when) {
            set_reading(specimen.profile, name, value);
            specimen.id += " " + name + "=" + value;
          }
          if (!expected.alarms.empty()) {
            specimen.right.end.kind = oracle::RunEnd::Kind::alarm;
            specimen.right.end.alarm.block = expected.alarms.front().block;
            specimen.right.end.alarm.alarm_class = name(expected.alarms.front().alarm);
          }
          if (has_curves || all.size() % kOpenCases != 0) {
            specimen.profile.readings = specimen.profile.readings.shown();
          }
          all.push_back(std::move(specimen));
        }
      });
  return all;
}

void compare(Comparison& comparison, const Specimen& specimen, std::string_view change,
             const oracle::Tolerances& tolerances, const Trace& trace) {
  comparison.compare({specimen.id, specimen.program, specimen.profile, tolerances}, change,
                     trace.records, trace.end);
}

TEST(DefinitionSweep, WhatTheCorpusExpectsIsRight) {
  Comparison comparison;
  const std::vector<Specimen> all = specimens();
  const auto wanted = static_cast<std::size_t>(trial_count(2'500));
  const std::size_t step = std::max<std::size_t>(1, all.size() / wanted);
  for (std::size_t i = 0; i < all.size(); i += step) {
    compare(comparison, all[i], "right", tolerances_for(all[i].profile, true, true), all[i].right);
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

TEST(DefinitionSweep, TheJudgeSaysTheSameOfChangedTraces) {
  Comparison comparison;
  const std::vector<Specimen> all = specimens();
  const long wanted = trial_count(20'000);
  Chance chance(trial_seed());
  for (long done = 0; done < wanted;) {
    const Specimen& specimen = chance.one_of(all);
    const Change& change = chance.one_of(changes());
    const oracle::Tolerances tolerances =
        tolerances_for(specimen.profile, !chance.once_in(4), !chance.once_in(8));
    Trace trace = specimen.right;
    if (!change.apply(trace.records, tolerances.tolerance, chance)) continue;
    compare(comparison, specimen, change.name, tolerances, trace);
    ++done;
  }
  comparison.print();
  EXPECT_EQ(comparison.differences(), 0);
}

}  // namespace
}  // namespace gonogo::relation
