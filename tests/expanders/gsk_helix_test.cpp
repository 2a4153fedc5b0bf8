// SPDX-License-Identifier: GPL-3.0-or-later
// G112 and G113, with X as a radius. This machine enters towards -q unless the profile says +p.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

const std::string kManual = "G00 X70 Z70 Y30\nG18\nG112 X70 Z70 Y20 I8 L5 D4 F200\n";

TEST(GskHelix, ManualExampleEntersTowardsMinusQ) {
  // I - D = 4 about (Z70, X70), no R plane; five turns from Y30 to Y20.
  const Outcome outcome = run(kManual, kRadiusProfile);
  EXPECT_EQ(outcome.motions(),
            "rapid x=70 y=30 z=70\n"
            "arc18 c=70,68 rot=-1 x=66 z=70 f=200\n"
            "arc18 c=70,70 rot=-5 x=66 y=20 z=70 f=200\n"
            "arc18 c=70,68 rot=-1 x=70 z=70 f=200\n"
            "rapid y=30\n");
  EXPECT_EQ(outcome.blocks.back(), 3u);
}

TEST(GskHelix, EntrySideOfTheProfile) {
  // Through q = +2 to Z74, back through q = -2.
  EXPECT_EQ(run_with_reading("gsk.helix.entry-side", "+p", kManual).motions(),
            "rapid x=70 y=30 z=70\n"
            "arc18 c=72,70 rot=-1 x=70 z=74 f=200\n"
            "arc18 c=70,70 rot=-5 x=70 y=20 z=74 f=200\n"
            "arc18 c=72,70 rot=-1 x=70 z=70 f=200\n"
            "rapid y=30\n");
}

TEST(GskHelix, G113TurnsTheOtherWay) {
  // R plane Y-1, bottom 9 below it; L omitted: one turn.
  EXPECT_EQ(run("G113 X0 Z0 V-9 R-1 I5 D2 F8\n", kRadiusProfile).motions(),
            "rapid y=-1\narc18 c=0,-1.5 rot=1 x=-3 z=0 f=8\narc18 c=0,0 rot=1 x=-3 y=-10 z=0 f=8\n"
            "arc18 c=0,-1.5 rot=1 x=0 z=0 f=8\nrapid y=0\n");
}

TEST(GskHelix, FlatCircleOfTheProfile) {
  const Outcome outcome = run_with_reading("gsk.helix.flat", "on", "G112 X0 Z0 Y-9 L2 I5 D2 F8\n");
  EXPECT_EQ(outcome.records[1], "arc18 c=0,0 rot=-2 x=-3 y=-9 z=0 f=8");
  EXPECT_EQ(outcome.records[2], "arc18 c=0,0 rot=-1 x=-3 z=0 f=8");
  EXPECT_EQ(outcome.records[3], "arc18 c=0,-1.5 rot=-1 x=0 z=0 f=8");
}

TEST(GskHelix, TurnsHoldForTheirBlock) {
  const std::string program = "G112 X0 Z0 Y-9 L3 I5 D2 F8\nX0 Z0 Y-9\n";
  const std::size_t second = 5;  // the helix of the second block
  EXPECT_EQ(run_with_reading("gsk.helix.L", "per-block", program).records[second],
            "arc18 c=0,0 rot=-1 x=-3 y=-9 z=0 f=8");
  EXPECT_EQ(run_with_reading("gsk.helix.L", "modal", program).records[second],
            "arc18 c=0,0 rot=-3 x=-3 y=-9 z=0 f=8");
}

TEST(GskHelix, TurnsAreAWholeNumberUpTo99999) {
  const auto alarm = [](const std::string& l) {
    return run("G112 X0 Z0 Y-9 I5 D2 F8 L" + l + "\n").alarm;
  };
  EXPECT_EQ(alarm("1"), "");
  EXPECT_EQ(alarm("99999"), "");
  EXPECT_EQ(alarm("2.000"), "");
  EXPECT_EQ(alarm("0"), "value-out-of-range");
  EXPECT_EQ(alarm("-1"), "value-out-of-range");
  EXPECT_EQ(alarm("100000"), "value-out-of-range");
  EXPECT_EQ(alarm("1.5"), "not-an-integer");
  EXPECT_EQ(alarm("1.0000000000001"), "not-an-integer");
  // In every block of the mode, milling or not.
  EXPECT_EQ(run("G112 I5 D2\nL0\n").alarm, "value-out-of-range");
}

TEST(GskHelix, EntryNeedsIAndD) {
  EXPECT_EQ(run("G112 D2\n").alarm, "missing-word");
  EXPECT_EQ(run("G112 I2\n").alarm, "missing-word");
  EXPECT_EQ(run("G112 I2 D2\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G112 I5 D2 F8\nX0 Z0 Y-9\nG113 X0 Z0 Y-9\n").answer, GONOGO_OK);
}

TEST(GskHelix, ToolMustBeSmallerThanThePocket) {
  EXPECT_EQ(run("G112 X0 Z0 Y-9 I4.001 D4 F8\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G112 X0 Z0 Y-9 I4 D4 F8\n").alarm, "tool-too-large");
  EXPECT_EQ(run("G112 X0 Z0 Y-9 I4 D0 F8\n").alarm, "value-out-of-range");
  EXPECT_EQ(run("G112 X0 Z0 Y-9 I0 D0 F8\n").alarm, "value-out-of-range");
}

TEST(GskHelix, RPlaneAndDepthMustAgree) {
  EXPECT_EQ(run("G112 X0 Z0 V-9 R0.001 I5 D4 F8\n").alarm, "direction-conflict");
  EXPECT_EQ(run("G112 X0 Z0 V-9 R-0.001 I5 D4 F8\n").answer, GONOGO_OK);
}

TEST(GskHelix, ZeroDepthPositionsOnlyAndNeedsNoFeed) {
  EXPECT_EQ(run("G112 X1 Z2 V0 R-3 I5 D4\n", kRadiusProfile).motions(),
            "rapid x=1 z=2\nrapid y=-3\nrapid y=0\n");
  EXPECT_EQ(run("G112 X1 Z2 V-1 R-3 I5 D4\n", kRadiusProfile).alarm, "feed-missing");
}

TEST(GskHelix, ReturnsToTheInitialPlaneWhateverEndsPockets) {
  const Outcome outcome =
      run_with_reading("gsk.pocket.end", "r-plane", "G112 X0 Z0 V-9 R-1 I5 D2 F8\n");
  EXPECT_EQ(outcome.records.back(), "end x=0 y=0 z=0 a=0 c=0");
}

TEST(GskHelix, ClampRunsBeforeTheMotion) {
  const Outcome outcome = run("G112 X9 Z9 Y-9 I5 D2 F8 M35\n", kRadiusProfile);
  EXPECT_EQ(outcome.records[0], "m 35");
  EXPECT_EQ(outcome.records[1], "rapid x=9 z=9");
}

TEST(GskHelix, DepthInG19IsADiameter) {
  EXPECT_EQ(run("G19 G112 Y0 Z0 U-20 R-1 I5 L2 D2 F8\n").records[2],
            "arc19 c=0,0 rot=-2 x=-11 y=0 z=-3 f=8");
}

TEST(GskHelix, BlockThatLacksAnAxisMillsNothing) {
  EXPECT_EQ(run("G112 X1 Z1 I5 D2 F8\nM35\n").motions(), "m 35\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
