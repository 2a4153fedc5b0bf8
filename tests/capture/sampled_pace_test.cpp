// SPDX-License-Identifier: GPL-3.0-or-later
//
// Feeds and dwells of samples: what is too slow, and how long a machine stands.
#include <gtest/gtest.h>

#include <functional>

#include "tests/capture/sampling.hpp"
#include "tests/has.hpp"

namespace gonogo::oracle {
namespace {

// The first cut begins where the log does: 200 s at its start are no part of it.
TEST(SampledPace, RestBeforeTheFirstCutIsNoSlowFeed) {
  for (const double feed : {300.0, 240.0}) {
    SampledMachine machine;
    machine.stand(200).line({.x = 10}, feed, 500).stand(1);
    const Verdict verdict =
        judge_samples({.program = "G1 X10 F300\nM2\n", .dialect = "rs274"}, machine.csv());
    EXPECT_EQ(decision(verdict.kind), feed == 300.0 ? Decision::go : Decision::no_go)
        << feed << verdict.message;
  }
}

// F100 over 10 mm: at 18 in its first half and 22 in its second, or at 20 with a stop amid it: no
// stop or ripple makes the rest slow. At 100 with such a stop, or at 92 and 104, it is not slow.
TEST(SampledPace, AFeedThatIsTooLowEverywhereIsNoGoThoughItIsNotSteady) {
  const auto kind = [](const std::function<void(SampledMachine&)>& cut) {
    SampledMachine machine(0.05);
    cut(machine);
    return judge_samples({.program = "G1 X10 F100\nM2\n", .dialect = "rs274"}, machine.csv()).kind;
  };
  const auto halves = [](double first, double second, double rest) {
    return [=](SampledMachine& machine) {
      machine.line({5, 0, 0}, first).stand(rest).line({10, 0, 0}, second);
    };
  };
  EXPECT_EQ(kind(halves(18, 22, 0)), VerdictKind::fail_feed);
  EXPECT_EQ(kind(halves(20, 20, 8)), VerdictKind::fail_feed);
  EXPECT_EQ(kind(halves(100, 100, 2)), VerdictKind::pass_tolerance);
  EXPECT_EQ(kind(halves(92, 104, 0)), VerdictKind::pass_tolerance);
}

// 4 mm at 40 mm/s^2 take 0.63 s and come to 759 mm/min of 1200: it speeds up, and slows down.
TEST(SampledPace, AMotionTooShortForItsFeedIsGoAndItsFeedNotCompared) {
  SampledMachine machine;
  machine.line({4, 0, 0}, kFeed, 40);
  const Verdict verdict =
      judge_samples({.program = "G1 X4 F1200\nM2\n", .dialect = "rs274"}, machine.csv());
  EXPECT_EQ(verdict.kind, VerdictKind::pass_tolerance) << verdict.message;
  EXPECT_TRUE(has(verdict.message, "the feed of 0 of them is bounded only"));
  EXPECT_TRUE(has(verdict.message, "of 1 not compared"));
}

// SINUMERIK: G4 F0.5 stands still for half a second.
TEST(SampledPace, ADwellIsAStandStillOfAtLeastItsTime) {
  SampledCase dwell{"G1 X10 F1200\nG4 F0.5\nG1 X20\n", "sinumerik840d"};
  for (const auto& [seconds, want] : {std::pair(0.5, Decision::go),
                                      {0.7, Decision::go},
                                      {0.4, Decision::no_go},
                                      {0.0, Decision::no_go}}) {
    SampledMachine machine;
    machine.line({10, 0, 0}, kFeed).stand(seconds).line({20, 0, 0}, kFeed);
    const Verdict verdict = judge_samples(dwell, machine.csv());
    EXPECT_EQ(decision(verdict.kind), want) << seconds << " " << verdict.message;
  }
}

// How long the machine stood before the first sample is not known.
TEST(SampledPace, ADwellThatBeginsTheProgramIsCheckedOnlyWhereSamplesShowIt) {
  const SampledCase dwell{"G4 P10\nG1 X1 F600\nM2\n", "rs274"};
  SampledMachine at_once;
  at_once.line({1, 0, 0}, 600);
  const Verdict open = judge_samples(dwell, at_once.csv());
  EXPECT_EQ(open.kind, VerdictKind::oracle_gap) << open.message;
  SampledMachine standing;
  standing.stand(10).line({1, 0, 0}, 600);
  EXPECT_EQ(judge_samples(dwell, standing.csv()).kind, VerdictKind::pass_tolerance);
}

// It stands for 9.6 s, of 10 s. What is granted is granted of feeds.
TEST(SampledPace, TheFeedToleranceShortensNoDwell) {
  const SampledCase dwell{"G1 X1 F600\nG4 P10\nG1 X2\nM2\n", "rs274"};
  const auto kind = [&](double seconds) {
    SampledMachine machine(0.05);
    machine.line({1, 0, 0}, 600).stand(seconds).line({2, 0, 0}, 600);
    return judge_samples(dwell, machine.csv()).kind;
  };
  EXPECT_EQ(decision(kind(9.6)), Decision::no_go);
  EXPECT_EQ(kind(10), VerdictKind::pass_tolerance);
}

// J-RUN-11. 2 s are due, and 10 more may be; before the program and after it any time may pass.
TEST(SampledPace, AStandFarLongerThanItsDwellIsNotCalledGood) {
  const SampledCase dwell{"G0 X10\nG4 P2\nG0 X20\nM2\n", "rs274"};
  const auto judged = [&](double before, double at_dwell, double after) {
    SampledMachine machine(0.05);
    machine.stand(before).line({10, 0, 0}, kRapid).stand(at_dwell).line({20, 0, 0}, kRapid);
    machine.stand(after);
    return judge_samples(dwell, machine.csv());
  };
  EXPECT_EQ(judged(0, 11.5, 0).kind, VerdictKind::pass_tolerance);
  EXPECT_EQ(judged(100, 2, 100).kind, VerdictKind::pass_tolerance);
  const Verdict verdict = judged(0, 20, 0);
  EXPECT_EQ(verdict.gap, GapReason::samples_stand) << verdict.message;
  EXPECT_TRUE(has(verdict.message, "at the dwell of line 2, where 2 s are due"));
}

}  // namespace
}  // namespace gonogo::oracle
