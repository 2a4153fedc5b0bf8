// SPDX-License-Identifier: GPL-3.0-or-later
// How G110 and G111 are entered, kept and left (GSK-G110-02, 14, 15; GSK-MOD-*).
#include <gtest/gtest.h>

#include <algorithm>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

constexpr const char* kEntry = "G110 X0 Z0 Y-1 I3 L3 Q5 D2 F100\n";

Outcome after_entry(const std::string& rest) {
  return run(kEntry + rest, kRadiusProfile);
}

// The records of line `block`.
std::string of_block(const Outcome& outcome, std::size_t block) {
  std::string text;
  for (std::size_t i = 0; i < outcome.records.size(); ++i) {
    if (outcome.blocks[i] == block && outcome.records[i][0] != 'e') {
      text += outcome.records[i] + "\n";
    }
  }
  return text;
}

TEST(GskPocketMode, ModalWordsMillTheNextPocket) {
  EXPECT_EQ(of_block(after_entry("X10 Z20 Y-1\n"), 2),
            "rapid x=10 z=20\nfeed y=-1 f=100\nfeed z=21 f=100\n"
            "arc18 c=20,10 rot=-1 x=10 z=21 f=100\nrapid y=0\nrapid x=10 z=20\n");
}

TEST(GskPocketMode, BlockThatLacksAnAxisMovesNothing) {
  EXPECT_EQ(of_block(after_entry("X10 Z20\nY-5\nX1 Y-5 C7\n"), 2), "");
  EXPECT_EQ(after_entry("X10 Z20\nY-5\nX1 Y-5 C7\n").motions(), after_entry("").motions());
}

TEST(GskPocketMode, BlockThatMillsNothingTakesWordsIn) {
  // I4 reaches the next pocket: I - D = 2.
  EXPECT_EQ(of_block(after_entry("I4 F50 M35\nX0 Z0 Y-1\n"), 3),
            "feed y=-1 f=50\nfeed z=2 f=50\narc18 c=0,0 rot=-1 x=0 z=2 f=50\nrapid y=0\n"
            "rapid x=0 z=0\n");
  EXPECT_EQ(of_block(after_entry("I4 F50 M35\n"), 2), "m 35\n");
}

TEST(GskPocketMode, ClampRunsBeforeTheMotion) {
  EXPECT_EQ(of_block(after_entry("X9 Z9 Y-1 M35\n"), 2).substr(0, 20), "m 35\nrapid x=9 z=9\nf");
}

TEST(GskPocketMode, RPlaneAndClearanceHoldForTheirBlock) {
  const Outcome outcome =
      run("G110 X0 Z0 Y-9 R-2 P1 I3 L3 Q5 D2 F100\nX9 Z9 Y-9\n", kRadiusProfile);
  // No R: from Y0 to -5 to -9; no P: the rapid goes back to -5.
  EXPECT_EQ(of_block(outcome, 2),
            "rapid x=9 z=9\nfeed y=-5 f=100\nfeed z=10 f=100\n"
            "arc18 c=9,9 rot=-1 x=9 z=10 f=100\nrapid y=0\nrapid x=9 z=9\nrapid y=-5\n"
            "feed y=-9 f=100\nfeed z=10 f=100\narc18 c=9,9 rot=-1 x=9 z=10 f=100\nrapid y=0\n"
            "rapid x=9 z=9\n");
}

TEST(GskPocketMode, ChangeOfSenseKeepsTheModalWords) {
  EXPECT_NE(of_block(after_entry("G111 X0 Z0 Y-1\n"), 2).find("rot=1"), std::string::npos);
}

TEST(GskPocketMode, CodeWrittenAgainIsNoEntry) {
  EXPECT_EQ(after_entry("G110 X9 Z9 Y-1\n").answer, GONOGO_OK);
}

TEST(GskPocketMode, LeavingForgetsTheModalWords) {
  for (const char* leave : {"G00", "G01", "G94", "G80"}) {
    const Outcome outcome = after_entry(std::string(leave) + "\nG110 X9 Z9 Y-1\n");
    EXPECT_EQ(outcome.alarm, "missing-word") << leave;
    EXPECT_EQ(outcome.alarm_block, 3u);
  }
}

TEST(GskPocketMode, MotionCodeEndsTheMode) {
  EXPECT_EQ(of_block(after_entry("G00 X5 Y6 Z7\n"), 2), "rapid x=5 y=6 z=7\n");
  EXPECT_EQ(of_block(after_entry("G01 X5 Y6 Z7\n"), 2), "feed x=5 y=6 z=7 f=100\n");
}

TEST(GskPocketMode, G80MovesAsG00InItsOwnBlockAndAfter) {
  const Outcome outcome =
      run("G01 F50\n" + std::string(kEntry) + "G80 X5 Y6 Z7\nX8\n", kRadiusProfile);
  EXPECT_EQ(of_block(outcome, 3), "rapid x=5 y=6 z=7\n");
  EXPECT_EQ(of_block(outcome, 4), "rapid x=8\n");
}

TEST(GskPocketMode, InitialPlaneStaysThroughTheMode) {
  const Outcome outcome =
      run("G0 Y50\nG110 X0 Z0 Y40 R-5 I3 L3 Q9 D2 F100\nX9 Z9 Y40 R-2\n", kRadiusProfile);
  EXPECT_EQ(of_block(outcome, 3).substr(0, 26), "rapid x=9 z=9\nrapid y=48\nf");
  EXPECT_EQ(outcome.records.back(), "end x=9 y=50 z=9 a=0 c=0");
}

TEST(GskPocketMode, PlaneCodeTakesTheNewAxisAsInitialPlane) {
  // After the G18 pocket at Z20 the depth axis of G17 is Z: it comes back to Z20.
  const Outcome outcome = run("G110 X0 Z20 Y-1 I3 L3 Q5 D2 F100\nG17\nX0 Y0 W-3\n", kRadiusProfile);
  const std::string second = of_block(outcome, 3);
  EXPECT_EQ(second.substr(0, 15), "feed z=17 f=100");
  EXPECT_EQ(outcome.records.back(), "end x=0 y=0 z=20 a=0 c=0");
}

TEST(GskPocketMode, LengthsSurviveAChangeOfUnits) {
  EXPECT_EQ(of_block(after_entry("G20\nX1 Z0 Y-0.1\n"), 3),
            "rapid x=25.4 z=0\nfeed y=-2.54 f=100\nfeed z=1 f=100\n"
            "arc18 c=0,25.4 rot=-1 x=25.4 z=1 f=100\nrapid y=0\nrapid x=25.4 z=0\n");
}

TEST(GskPocketMode, NonModalCodesKeepTheMode) {
  const Outcome outcome = after_entry("G04 X1.5\nG28 Y0\nX9 Z9 Y-1\n");
  EXPECT_EQ(of_block(outcome, 2), "dwell 1.5\n");
  EXPECT_EQ(of_block(outcome, 4).substr(0, 13), "rapid x=9 z=9");
}

// The tool is at the R plane, Y-5; R-7 counts from Y0.
TEST(GskPocketMode, ThePlaneWrittenAgainLeavesTheInitialPlane) {
  const Outcome outcome = run("G110 X0 Z0 V-5 R-5 I3 L3 Q9 D2 F100\nG18 X0 Z0 V-5 R-7\n",
                              R"({"x_diameter":false,"readings":{"gsk.pocket.end":"r-plane"}})");
  EXPECT_EQ(of_block(outcome, 2).substr(0, 32), "rapid y=-7\nfeed y=-12 f=100\nfeed");
}

TEST(GskPocketMode, RenamingCarriesTheInitialPlaneAlong) {
  // Y0 becomes Y100: the pocket starts from and returns to Y100.
  const Outcome outcome = after_entry("G50 Y100\nX9 Z9 V-1 R-3\n");
  EXPECT_EQ(of_block(outcome, 3).substr(0, 25), "rapid x=9 z=9\nrapid y=97\n");
  EXPECT_EQ(outcome.records.back(), "end x=9 y=100 z=9 a=0 c=0");
}

TEST(GskPocketMode, RenamingCannotCarryTheInitialPlaneOutOfReach) {
  const std::string away = "G50 Y3900000000\nG28 Y0\n";
  EXPECT_EQ(run("G110 I3 L3 Q5 D2\n" + away).answer, GONOGO_OK);
  EXPECT_EQ(run("G110 I3 L3 Q5 D2\n" + away + away).alarm, "value-out-of-range");
}

TEST(GskPocketMode, PocketsAndHelicesAreTwoModes) {
  // I D of G110 are no words of G112, nor the other way round.
  EXPECT_EQ(after_entry("G112 X9 Z9 Y-1 I3\n").alarm, "missing-word");
  EXPECT_EQ(after_entry("G112 X9 Z9 Y-1 D2\n").alarm, "missing-word");
  EXPECT_EQ(after_entry("G112 I3 D2\nG110 X9 Z9 Y-1 L1 Q1\n").alarm, "missing-word");
  EXPECT_EQ(after_entry("G114\nG110 X9 Z9 Y-1\n").alarm, "missing-word");
}

TEST(GskPocketMode, G94WordsOutliveTheMode) {
  // G94 written again: X10, Z-5 and R-1 are kept, from A (0, 0): B is at Z-6.
  const Outcome outcome =
      run("G00 X40 Z0\nG94 X20 Z-5 R-1 F100\n" + std::string(kEntry) + "G94 X10\n", kRadiusProfile);
  EXPECT_EQ(of_block(outcome, 4), "rapid z=-6\nfeed x=10 z=-5 f=100\nfeed z=0 f=100\nrapid x=0\n");
}

TEST(GskPocketMode, G94WordsDoNotOutliveAnotherMotionCode) {
  const Outcome outcome =
      run("G00 X40 Z0\nG94 X20 Z-5 R-1 F100\n" + std::string(kEntry) + "G01\nG94 X10\n",
          kRadiusProfile);
  EXPECT_EQ(of_block(outcome, 5), "feed x=10 z=0 f=100\nrapid x=0\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
