// SPDX-License-Identifier: GPL-3.0-or-later
// G90. X words are diameters unless a test says otherwise: X120 is x=60.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(GskG90, MirrorsG94) {
  // A (120, 3), B (110, 3), C (110, -30), D (120, -30): X moves first, then the cut along Z.
  const Outcome outcome = run("G0 X120 Z3\nG18 G90 X110 Z-30 F200\nX100\n");
  EXPECT_EQ(outcome.motions(),
            "rapid x=60 z=3\n"
            "rapid x=55\nfeed x=55 z=-30 f=200\nfeed x=60 f=200\nrapid z=3\n"
            "rapid x=50\nfeed x=50 z=-30 f=200\nfeed x=60 f=200\nrapid z=3\n");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{1, 2, 2, 2, 2, 3, 3, 3, 3, 3}));
}

TEST(GskG90, TaperOfTheMakersExampleHasNoTravelInX) {
  // A (120, -30), C (120, -44): B_x = 60 - 7.5 = 52.5; C to D has no length. Last B (60, -30).
  const Outcome outcome =
      run("G0 X120 Z-30\nG90 X120 Z-44 R-7.5 F150\nZ-56 R-15\nZ-68 R-22.5\nZ-80 R-30\nM30\n");
  std::string expected;
  const char* passes[][2] = {{"52.5", "-44"}, {"45", "-56"}, {"37.5", "-68"}, {"30", "-80"}};
  for (const auto& [b, c] : passes) {
    expected += std::string("rapid x=") + b + "\nfeed x=60 z=" + c + " f=150\nrapid z=-30\n";
  }
  EXPECT_EQ(after_first(outcome), expected + "m 30\n");
}

TEST(GskG90, IncrementsCountFromTheStart) {
  // U-20 is 10: C (40, -10); R-1: B (39, 0).
  EXPECT_EQ(after_first(run("G0 X100\nG90 U-20 W-10 R-1 F9\n")),
            "rapid x=39\nfeed x=40 z=-10 f=9\nfeed x=50 f=9\nrapid z=0\n");
}

TEST(GskG90, TaperLimitTakesTheTravelInXByItsRadius) {
  // U-20 is 10: R against it may be 10.
  EXPECT_EQ(run("G0 X100\nG90 U-20 W-9 R10 F9\n").answer, GONOGO_OK);
  const Outcome outcome = run("G0 X100\nG90 U-20 W-9 R10.001 F9\n");
  EXPECT_EQ(outcome.alarm, "taper-limit");
  EXPECT_EQ(outcome.alarm_word, 'R');
  EXPECT_EQ(outcome.motions(), "rapid x=50\n");
  EXPECT_EQ(run("G0 X100\nG90 U-20 W-9 R-999 F9\n").answer, GONOGO_OK);
}

TEST(GskG90, OtherPlanes) {
  // G17: p = X, q = Y; G19: p = Y, q = Z.
  EXPECT_EQ(run("G17 G90 U-20 V-4 R-1 F9\n").motions(),
            "rapid y=-5\nfeed x=-10 y=-4 f=9\nfeed y=0 f=9\nrapid x=0\n");
  EXPECT_EQ(run("G19 G90 V-4 W-6 R-1 F9\n").motions(),
            "rapid z=-7\nfeed y=-4 z=-6 f=9\nfeed z=0 f=9\nrapid y=0\n");
}

TEST(GskG90, WordOffThePlaneAlarms) {
  for (const char* word : {"Y5", "V5", "C30", "H30"}) {
    EXPECT_EQ(run(std::string("G90 X-8 Z-9 F5 ") + word + "\n").alarm, "axis-not-in-plane") << word;
  }
}

TEST(GskG90, AnotherCycleOfItsGroupClearsTheRetainedWords) {
  // After G94 nothing is left of Z-9 and R-1: Z is zero travel, B = A.
  const Outcome outcome = run("G90 X-8 Z-9 R-1 F5\nG94 X-6\n");
  EXPECT_EQ(joined({outcome.records.begin() + 4, outcome.records.end() - 1}),
            "feed x=-3 z=0 f=5\nrapid x=0\n");
}

TEST(GskG90, DwellKeepsTheRetainedWordsAndG28ClearsThem) {
  EXPECT_EQ(run("G90 X-8 Z-9 R-1 F5\nG04 P1\nX-6\n").records[5], "rapid x=-4");
  EXPECT_EQ(run("G90 X-8 Z-9 R-1 F5\nG28\nX-6\n").records[4], "rapid x=-3");
}

TEST(GskG90, EndsWithG80) {
  EXPECT_EQ(run("G90 X-8 Z-9 F5\nG80 X4\n").records[4], "rapid x=2");
}

TEST(GskG90, NeedsAFeed) {
  EXPECT_EQ(run("G90 X-8 Z-9\n").alarm, "feed-missing");
}

}  // namespace
}  // namespace gonogo::expanders::testing
