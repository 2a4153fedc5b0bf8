// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-RUN-11: holes in samples, and what their rhythm does not show.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>

#include "capture/sample_rhythm.hpp"
#include "tests/capture/sampling.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

using Rows = std::vector<SampledMachine::Row>;

constexpr double kInterval = 0.02;

// Samples of rest (0 to 1 s), a traverse (to 2 s), a cut (to 4 s), a cut that ends at rest (to 6 s;
// then 1 s). G00 goes 10 mm at 10 mm/s, the cuts 20 mm and 20 mm.
const SampledCase kWay{"G17 G00 X20 Y0\nG01 X60 F600\nY20\n"};

Rows way(double interval = kInterval) {
  SampledMachine machine(interval);
  machine.stand(1).line({10, 0, 0}, 600).line({30, 0, 0}, 600).line({30, 20, 0}, 600).stand(1);
  return machine.rows();
}

Rows without(const Rows& rows, const std::function<bool(double)>& missing) {
  Rows left;
  for (const auto& row : rows) {
    if (!missing(row.time)) left.push_back(row);
  }
  return left;
}

// Each time off by up to the part of an interval, either way; the places are those of the new
// times.
Rows jittered(double part) {
  SampledMachine machine(0.0005);
  machine.stand(1).line({10, 0, 0}, 600).line({30, 0, 0}, 600).line({30, 20, 0}, 600).stand(1);
  const Rows fine = machine.rows();
  std::mt19937 random(39);
  Rows rows{fine.front()};
  for (double due = kInterval; due < fine.back().time; due += kInterval) {
    constexpr double kHalf = 2147483647.5;
    const double off = (static_cast<double>(random()) / kHalf - 1) * part * kInterval;
    const auto at = static_cast<std::size_t>((due + off) / 0.0005);
    if (fine[at].time > rows.back().time) rows.push_back(fine[at]);
  }
  rows.push_back(fine.back());
  return rows;
}

void expect_hole(const Rows& rows, const std::string& times) {
  const Verdict verdict = judge_samples(kWay, csv_of(rows));
  EXPECT_EQ(verdict.kind, VerdictKind::oracle_gap) << times << ": " << verdict.message;
  EXPECT_EQ(verdict.gap, GapReason::samples_hole) << times;
  EXPECT_TRUE(has(verdict.message, times));
}

// J-RUN-11
TEST(SampleHoles, AHoleIsAGapWhereverItLies) {
  for (const double begin : {0.2, 1.2, 2.4, 3.8, 5.8, 6.2}) {  // rest, traverse, cut, corner, end
    const Rows rows =
        without(way(), [&](double time) { return time > begin && time < begin + 0.7; });
    const Verdict verdict = judge_samples(kWay, csv_of(rows));
    EXPECT_EQ(verdict.gap, GapReason::samples_hole) << begin << ": " << verdict.message;
  }
}

TEST(SampleHoles, OneSampleThatIsMissingIsAHoleOfAnEvenRhythm) {
  expect_hole(without(way(), [](double time) { return time > 2.49 && time < 2.51; }),
              "2.48 s to 2.52 s (line 2)");
}

TEST(SampleHoles, ManyHolesAreFoundAndTheFirstOnesNamed) {
  // The last seven tenths of each second: what is left is 16 samples a second and a hole.
  expect_hole(without(way(), [](double time) { return time - std::floor(time) > 0.31; }),
              "0.3 s to 1 s");
  // More holes than intervals between them: of each fifth of a second two or three samples are
  // left.
  expect_hole(without(way(), [](double time) { return time * 5 - std::floor(time * 5) > 0.23; }),
              "34 holes");
}

// The tool plunges by 30 mm and comes back in a hole behind the traverse.
TEST(SampleHoles, WhatTheMachineDoesInAHoleIsNoGoOnlyWhereSamplesShowIt) {
  SampledMachine machine(kInterval);
  machine.stand(1).line({10, 0, 0}, 600).line({10, 0, -30}, 6000).line({10, 0, 0}, 6000);
  machine.line({30, 0, 0}, 600).line({30, 20, 0}, 600).stand(1);
  const Rows all = machine.rows();
  EXPECT_EQ(judge_samples(kWay, csv_of(all)).kind, VerdictKind::fail_geometry);
  expect_hole(without(all, [](double time) { return time > 2.01 && time < 2.59; }), "2 s to 2.6 s");
}

TEST(SampleHoles, JitterIsNoHoleAndAHoleAmongItIs) {
  for (const double part : {0.1, 0.25, 0.5}) {
    const Rows rows = jittered(part);
    const Verdict verdict = judge_samples(kWay, csv_of(rows));
    EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << part << ": " << verdict.message;
    const Verdict hole = judge_samples(
        kWay, csv_of(without(rows, [](double time) { return time > 2.4 && time < 2.6; })));
    EXPECT_EQ(hole.gap, GapReason::samples_hole) << part << ": " << hole.message;
  }
}

// Intervals of 20, 30 and 40 ms in turn, and times to the hundredth of a second at 62.5 samples a
// second: 10 and 20 ms.
TEST(SampleHoles, ALogWithoutAConstantRateHasTheRhythmThatItMostlyHas) {
  std::size_t number = 0;
  const Rows fine = way(0.01);
  Rows uneven;
  for (std::size_t i = 0; i < fine.size(); i += 2 + number++ % 3) uneven.push_back(fine[i]);
  uneven.push_back(fine.back());
  EXPECT_EQ(judge_samples(kWay, csv_of(uneven)).kind, VerdictKind::pass_tolerance);
  EXPECT_EQ(judge_samples(
                kWay, csv_of(without(uneven, [](double time) { return time > 3 && time < 3.2; })))
                .gap,
            GapReason::samples_hole);
}

// Out and back by 30 mm in 0.06 s, between samples of 0.1 s: GO, and the case says so.
TEST(SampleHoles, WhatTheRhythmDoesNotShowStandsInTheCase) {
  SampledMachine machine(0.1);
  machine.stand(1).line({10, 0, 0}, 600).line({30, 0, 0}, 600).line({30, 20, 0}, 600).stand(1);
  const Verdict verdict = judge_samples(kWay, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  ASSERT_NE(verdict.sampled, nullptr);
  EXPECT_EQ(verdict.sampled->longest, "0.1");
  EXPECT_EQ(verdict.sampled->unseen, "50");  // 1,000 mm/s for half of it
  EXPECT_TRUE(has(verdict.message, "50 mm away from the path and back"));
}

// What leads to the start is not the program's.
TEST(SampleHoles, AHoleInTheApproachIsNone) {
  SampledMachine machine(kInterval, {-20, 0, 0});
  machine.line({0, 0, 0}, 600).stand(1).line({10, 0, 0}, 600).line({30, 0, 0}, 600);
  machine.line({30, 20, 0}, 600).stand(1);
  SampledCase exported = kWay;
  exported.header_lines = 3;
  const Rows all = machine.rows();
  const auto missing = [&](double from, double to) {
    return csv_of(without(all, [=](double time) { return time > from && time < to; }));
  };
  EXPECT_EQ(judge_samples(exported, missing(0.5, 1.1)).kind, VerdictKind::pass_tolerance);
  EXPECT_EQ(judge_samples(exported, missing(1.5, 2.3)).gap, GapReason::samples_hole);
}

TEST(SampleHoles, ASampleWithoutATimeIsAHole) {
  const auto lacking = [](const std::string& time) {
    std::string csv = csv_of(way());
    const std::size_t at = csv.find("\n" + time + ",");
    EXPECT_NE(at, std::string::npos) << time;
    return judge_samples(kWay, csv.erase(at + 1, time.size()));
  };
  for (const char* time : {"0.000000", "0.500000", "2.500000", "7.000000"}) {
    const Verdict verdict = lacking(time);
    EXPECT_EQ(verdict.gap, GapReason::samples_hole) << time << ": " << verdict.message;
  }
  EXPECT_THROW(judge_samples(kWay, "t,x,y,z\n0,0,0,0\n0,1,0,0\n"), SampleFault);
}

TEST(SampleRhythm, LimitIsThatOfTheQuarterAndTheMedian) {
  SampleRhythm even;
  for (int i = 0; i <= 8; ++i) even.add(0.02 * i);
  EXPECT_NEAR(even.limit(0), 0.03, 1e-6);
  EXPECT_NEAR(even.limit(0.005), 0.04, 1e-6);
  // 1, 2, 3, 4: the quarter is 1, the median 2: 1.5 + 4 * (2 - 1), at most 4.
  SampleRhythm uneven;
  for (const int time : {0, 1, 3, 6, 10}) uneven.add(time);
  EXPECT_NEAR(uneven.limit(0), 4, 1e-6);
  EXPECT_EQ(SampleRhythm().limit(0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace gonogo::oracle
