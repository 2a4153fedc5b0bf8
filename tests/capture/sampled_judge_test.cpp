// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expected motions by hand. GSK, diameters: X100 is x 50, X60 is x 30. G94 X60 Z-5 from (50, 5):
// traverse to z -5, cut to x 30, cut to z 5, traverse to x 50.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/capture/sampling.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

SampledMachine box_start() {
  SampledMachine machine;
  machine.line({50, 0, 5}, kRapid);
  return machine;
}

// A pass of G94 from and back to (50, 5).
void pass(SampledMachine& machine, double depth, double feed = kFeed, double acceleration = 0) {
  machine.line({50, 0, depth}, kRapid).line({30, 0, depth}, feed, acceleration);
  machine.line({30, 0, 5}, feed, acceleration).line({50, 0, 5}, kRapid);
}

const SampledCase kBox{"G00 X100 Z5\nG94 X60 Z-5 F1200\n"};
const SampledCase kPasses{"G00 X100 Z5\nG94 X60 Z-1 F1200\nZ-2\nZ-3\n"};

TEST(SampledJudge, TheBoxOfG94IsGo) {
  SampledMachine machine = box_start();
  pass(machine, -5);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  EXPECT_TRUE(has(verdict.message, "bounded only"));
}

TEST(SampledJudge, RampsOfTheSpeedAreGo) {
  SampledMachine machine = box_start();
  pass(machine, -5, kFeed, 500);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
}

// The whole cut to x 30 runs 0.003 too deep: z -5.003, off by 0.003 where 0.001 is allowed.
TEST(SampledJudge, ACutOffThePathIsNoGoWithItsExactDeviation) {
  SampledMachine machine = box_start();
  machine.line({50, 0, -5.003}, kRapid).line({30, 0, -5.003}, kFeed);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.block, 2U);
  EXPECT_EQ(verdict.deviation_exact, "0.003");
  EXPECT_TRUE(has(verdict.witness, "\"z\":\"-5.003\""));
}

TEST(SampledJudge, SwappedPassesAreOutOfOrder) {
  SampledMachine machine = box_start();
  pass(machine, -1);
  pass(machine, -3);
  pass(machine, -2);
  const Verdict verdict = judge_samples(kPasses, machine.csv());
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
  EXPECT_EQ(verdict.block, 3U) << verdict.message;
}

TEST(SampledJudge, AMissingLastPassIsNoGo) {
  SampledMachine machine = box_start();
  pass(machine, -1);
  pass(machine, -2);
  const Verdict verdict = judge_samples(kPasses, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_EQ(verdict.block, 4U) << verdict.message;
}

TEST(SampledJudge, AMissingMiddlePassIsNoGo) {
  SampledMachine machine = box_start();
  pass(machine, -1);
  pass(machine, -3);
  const Verdict verdict = judge_samples(kPasses, machine.csv());
  EXPECT_EQ(decision(verdict.kind), Decision::no_go) << verdict.message;
  EXPECT_EQ(verdict.block, 3U) << verdict.message;
}

// x 30.3 instead of 30 at 20 mm/s and 4 ms: 0.08 mm an interval do not explain 0.3.
TEST(SampledJudge, ACornerThatIsCutShortIsNoGo) {
  SampledMachine machine = box_start();
  machine.line({50, 0, -5}, kRapid).line({30.3, 0, -5}, kFeed).line({30, 0, -4.9}, kFeed);
  machine.line({30, 0, 5}, kFeed).line({50, 0, 5}, kRapid);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
}

TEST(SampledJudge, GoingBackAlongACutIsNoGo) {
  SampledMachine machine = box_start();
  machine.line({50, 0, -5}, kRapid).line({40, 0, -5}, kFeed).line({41, 0, -5}, kFeed);
  machine.line({30, 0, -5}, kFeed).line({30, 0, 5}, kFeed).line({50, 0, 5}, kRapid);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
  EXPECT_TRUE(has(verdict.message, "goes back"));
}

// Backlash of 0.002 in x after the turn of the axis: the last traverse ends at 49.998.
TEST(SampledJudge, BacklashWithinTheToleranceIsGo) {
  SampledMachine machine = box_start();
  machine.line({50, 0, -5}, kRapid).line({30, 0, -5}, kFeed).line({30, 0, 5}, kFeed);
  machine.line({49.998, 0, 5}, kRapid);
  SampledCase granted = kBox;
  granted.tolerance = "0.001";  // with tau 0.001: a tube of 0.002
  EXPECT_EQ(judge_samples(granted, machine.csv()).kind, VerdictKind::pass_tolerance);
  EXPECT_EQ(judge_samples(kBox, machine.csv()).kind, VerdictKind::fail_geometry);
}

TEST(SampledJudge, AFeedWrongByAFifthIsNoGoAndByAFiftiethIsGo) {
  for (const auto& [factor, want] : {std::pair(1.2, VerdictKind::fail_feed),
                                     {0.8, VerdictKind::fail_feed},
                                     {1.02, VerdictKind::pass_tolerance},
                                     {0.98, VerdictKind::pass_tolerance}}) {
    SampledMachine machine = box_start();
    pass(machine, -5, kFeed * factor);
    const Verdict verdict = judge_samples(kBox, machine.csv());
    EXPECT_EQ(verdict.kind, want) << factor << " " << verdict.message;
  }
}

TEST(SampledJudge, AFeedWrongByAFifthIsGoWhenSoMuchWasGranted) {
  SampledMachine machine = box_start();
  pass(machine, -5, kFeed * 1.2);
  SampledCase granted = kBox;
  granted.feed_tolerance = "1/4";
  EXPECT_EQ(judge_samples(granted, machine.csv()).kind, VerdictKind::pass_tolerance);
}

TEST(SampledJudge, ATraverseMayTakeAnyMonotoneWay) {
  SampledMachine machine;
  machine.line({0, 0, 5}, kRapid).line({50, 0, 5}, kRapid);  // one axis after the other
  pass(machine, -5);
  EXPECT_EQ(judge_samples(kBox, machine.csv()).kind, VerdictKind::pass_tolerance);
}

TEST(SampledJudge, ATraverseThatTurnsBackOnAnAxisIsNoGo) {
  SampledMachine machine;
  machine.line({30, 0, 0}, kRapid).line({25, 0, 3}, kRapid).line({50, 0, 5}, kRapid);
  pass(machine, -5);
  EXPECT_EQ(judge_samples(kBox, machine.csv()).kind, VerdictKind::fail_geometry);
}

TEST(SampledJudge, MotionAfterTheEndIsAnOverrun) {
  SampledMachine machine = box_start();
  pass(machine, -5);
  machine.stand(0.02).line({60, 0, 5}, kRapid);
  const Verdict verdict = judge_samples(kBox, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::fail_overrun);
  EXPECT_EQ(verdict.block, 0U) << "it is of no line of the program";
}

TEST(SampledJudge, SamplesThatBeginElsewhereAreNoGo) {
  SampledMachine machine(0.004, {1, 0, 0});
  machine.line({50, 0, 5}, kRapid);
  pass(machine, -5);
  EXPECT_EQ(judge_samples(kBox, machine.csv()).kind, VerdictKind::fail_geometry);
}

// With a header the machine comes from anywhere.
TEST(SampledJudge, TheApproachOfTheHeaderIsNotJudged) {
  SampledMachine machine(0.004, {80, 0, 70});
  machine.line({0, 0, 70}, kRapid).line({0, 0, 0}, kRapid).line({50, 0, 5}, kRapid);
  pass(machine, -5);
  SampledCase led = kBox;
  led.header_lines = 3;
  EXPECT_EQ(judge_samples(led, machine.csv()).kind, VerdictKind::pass_tolerance);
}

// G17: from (10, 0) clockwise about (0, 0) to (0, -10).
const SampledCase kArc{"G17 G00 X20 Y0\nG02 X0 Y-10 I-10 J0 F1200\n"};

TEST(SampledJudge, AnArcIsGo) {
  SampledMachine machine;
  machine.line({10, 0, 0}, kRapid).turn({0, 0, 0}, -90, kFeed).line({0, -10, 0}, kFeed);
  const Verdict verdict = judge_samples(kArc, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
}

TEST(SampledJudge, AnArcCutByItsChordIsNoGo) {
  SampledMachine machine;
  machine.line({10, 0, 0}, kRapid).line({0, -10, 0}, kFeed);
  EXPECT_EQ(judge_samples(kArc, machine.csv()).kind, VerdictKind::fail_geometry);
}

TEST(SampledJudge, AnArcTheOtherWayRoundIsNoGo) {
  SampledMachine machine;
  machine.line({10, 0, 0}, kRapid).turn({0, 0, 0}, 270, kFeed);
  EXPECT_EQ(decision(judge_samples(kArc, machine.csv()).kind), Decision::no_go);
}

TEST(SampledJudge, AFullCircleIsFollowedOnce) {
  const SampledCase circle{"G17 G00 X20 Y0\nG02 X20 Y0 I-10 J0 F1200\n"};
  SampledMachine once;
  once.line({10, 0, 0}, kRapid).turn({0, 0, 0}, -360, kFeed);
  const Verdict verdict = judge_samples(circle, once.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  SampledMachine never;
  never.line({10, 0, 0}, kRapid);
  EXPECT_EQ(decision(judge_samples(circle, never.csv()).kind), Decision::no_go);
  SampledMachine twice;
  twice.line({10, 0, 0}, kRapid).turn({0, 0, 0}, -720, kFeed);
  EXPECT_EQ(decision(judge_samples(circle, twice.csv()).kind), Decision::no_go);
}

// Out and back by 0.05 mm at 1200 mm/min takes 5 ms; sampled every 20 ms nothing of it is seen.
TEST(SampledJudge, AMotionThatNoSampleShowsIsNotCalledGood) {
  const SampledCase spike{"G1 X10 F1200\nX10.05\nX10\nY5\n", "sinumerik840d"};
  SampledMachine machine(0.02);
  machine.line({10, 0, 0}, kFeed).line({10.05, 0, 0}, kFeed).line({10, 0, 0}, kFeed);
  machine.line({10, 5, 0}, kFeed);
  const Verdict verdict = judge_samples(spike, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::oracle_gap) << verdict.message;
  EXPECT_TRUE(has(verdict.message, "Not checked"));
}

// HNC-G74: down by 6, up by 1, three times; a feed per revolution has no bound. Straight down
// without a withdrawal fits the cuts, and nothing shows the withdrawals between them.
TEST(SampledJudge, WithdrawalsThatNoSampleShowsAreNotCalledGood) {
  const SampledCase pecks{"G00 X0 Z2\nG95 G74 Z-16 R1 Q6 F0.12\n", "hnc21t"};
  SampledMachine pecking(0.01);
  pecking.line({0, 0, 2}, kRapid);
  for (const double depth : {-4.0, -10.0}) {
    pecking.line({0, 0, depth}, kFeed).line({0, 0, depth + 1}, kFeed);
  }
  pecking.line({0, 0, -16}, kFeed).line({0, 0, 2}, kRapid);
  const Verdict good = judge_samples(pecks, pecking.csv());
  EXPECT_EQ(good.kind, VerdictKind::pass_tolerance) << good.message;
  SampledMachine straight(0.02);
  straight.line({0, 0, 2}, kRapid).line({0, 0, -16}, kFeed).line({0, 0, 2}, kRapid);
  const Verdict none = judge_samples(pecks, straight.csv());
  EXPECT_EQ(none.kind, VerdictKind::oracle_gap) << none.message;
}

TEST(SampledJudge, AnOpenPathIsNeverASilentPass) {
  const SampledCase pocket{"G17 G00 X40 Y30 Z10\nG110 X20 Y10 W-2 R-1 I6 L4 Q2 D4 F200\n"};
  SampledMachine machine;
  machine.line({20, 30, 10}, kRapid).line({10, 10, 10}, kRapid).line({10, 10, 9}, kRapid);
  machine.line({10, 10, 7}, 200).line({10, 10, 10}, kRapid);
  const Verdict verdict = judge_samples(pocket, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::oracle_gap) << verdict.message;
}

const SampledCase kNoFeed{"G00 X100 Z5\nG94 X60 Z-5\n"};

TEST(SampledJudge, TheRightAlarmIsGo) {
  SampledMachine machine = box_start();
  const std::string csv = machine.csv();
  EXPECT_EQ(judge_samples(kNoFeed, csv + "alarm,feed-missing,2\n").kind,
            VerdictKind::pass_tolerance);
  EXPECT_EQ(judge_samples(kNoFeed, csv).kind, VerdictKind::fail_alarm_missing);
  EXPECT_EQ(judge_samples(kNoFeed, csv + "alarm,syntax,2\n").kind, VerdictKind::fail_alarm_class);
  EXPECT_EQ(judge_samples(kNoFeed, csv + "alarm,PS0011,2\n").kind, VerdictKind::unmapped_alarm);
  EXPECT_EQ(judge_samples(kNoFeed, csv + "alarm,feed-missing,1\n").kind,
            VerdictKind::fail_alarm_spurious);
}

TEST(SampledJudge, MotionPastTheBlockThatAlarmsIsNoGo) {
  SampledMachine machine = box_start();
  machine.stand(0.02).line({50, 0, -5}, kRapid);
  EXPECT_EQ(judge_samples(kNoFeed, machine.csv() + "alarm,feed-missing,2\n").kind,
            VerdictKind::fail_alarm_late);
  EXPECT_EQ(judge_samples(kNoFeed, machine.csv()).kind, VerdictKind::fail_alarm_missing);
}

TEST(SampledJudge, AnAlarmOfAGoodProgramIsSpurious) {
  SampledMachine machine = box_start();
  machine.line({50, 0, -5}, kRapid).line({40, 0, -5}, kFeed);
  EXPECT_EQ(judge_samples(kBox, machine.csv() + "alarm,syntax,2\n").kind,
            VerdictKind::fail_alarm_spurious);
}

// Half a circle of radius 5 about (5, 0, 0), from (0, 0, 0) to (10, 0, 0): by way of (5, 5 y, 5 z).
const SampledCase kSpaceCircle{"F600 S500 M3\nCIP X10 Y0 Z0 I1=5 J1=3 K1=4\n", "sinumerik840d"};
std::string half_circle(double y, double z, double radius = 5, double feed = 600) {
  const double seconds = std::numbers::pi * radius / (feed / 60);
  std::vector<SampledMachine::Row> rows;
  const auto add = [&](double time) {
    const double angle = std::numbers::pi * time / seconds;
    const double aside = radius * std::sin(angle);
    rows.push_back({time, {5 - 5 * std::cos(angle), y * aside, z * aside}});
  };
  for (double time = 0; time < seconds; time += 0.004) add(time);
  add(seconds);
  return csv_of(rows);
}

TEST(SampledJudge, ACircleInSpaceIsFollowed) {
  const Verdict verdict = judge_samples(kSpaceCircle, half_circle(0.6, 0.8));
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
}

TEST(SampledJudge, ACircleInAnotherPlaneOrTheOtherHalfOrOfAnotherRadiusIsNoGo) {
  for (const std::string& csv : {half_circle(0.8, 0.6), half_circle(-0.6, -0.8),
                                 half_circle(0.6, 0.8, 5.01), half_circle(0.6, 0.8, 4.99)}) {
    const Verdict verdict = judge_samples(kSpaceCircle, csv);
    EXPECT_EQ(verdict.kind, VerdictKind::fail_geometry) << verdict.message;
    EXPECT_EQ(verdict.block, 2U);
  }
}

TEST(SampledJudge, AFeedWrongByAFifthOnACircleInSpaceIsNoGo) {
  EXPECT_EQ(judge_samples(kSpaceCircle, half_circle(0.6, 0.8, 5, 720)).kind,
            VerdictKind::fail_feed);
  EXPECT_EQ(judge_samples(kSpaceCircle, half_circle(0.6, 0.8, 5, 588)).kind,
            VerdictKind::pass_tolerance);
}

}  // namespace
}  // namespace gonogo::oracle
