// SPDX-License-Identifier: GPL-3.0-or-later
//
// How modes begin, what they keep and how they end: GSK-MOD-01 to 09, GSK-G110-15.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

const std::string kEntry = "G110 I16 L3 Q50 D4 F800\n";
// A pocket of one layer at the axis, 5 below the initial plane; the depth word of G18 is V.
const std::string kMill = "X0 Z0 V-5";
// What it does from an initial plane of 0, turning clockwise.
const Lines kMilled = {
    "rapid x0 z0", "rapid y0",    "feed y-5 f800", "level d-5 c0,0 R16 r4 L3 -1 f800",
    "rapid y0",    "rapid x0 z0", "rapid y0"};
constexpr std::string_view kAllMissing =
    "alarm b3 missing-word missing-word missing-word missing-word";

TEST(Mode, Mod01TheCodeIsModal) {
  EXPECT_EQ(judged(kEntry + kMill), kMilled);
}

TEST(Mode, Mod01TheCodeWrittenAgainIsNoEntry) {
  EXPECT_EQ(judged(kEntry + "G110 " + kMill), kMilled);
  EXPECT_EQ(judged(kEntry + "G110"), Lines{});
}

TEST(Mode, Mod01G110AndG111AreOneMode) {
  const Lines both = judged(kEntry + "G111 " + kMill);
  ASSERT_EQ(both.size(), 7U);
  EXPECT_EQ(both[3], "level d-5 c0,0 R16 r4 L3 +1 f800");
  EXPECT_EQ(judged(kEntry + "G111 " + kMill, profile_with({{"gsk.pocket.pair", "shared"}})), both);
}

TEST(Mode, ReadingPairEachAsksForILQDAgain) {
  const Profile each = profile_with({{"gsk.pocket.pair", "each"}});
  EXPECT_EQ(ending(kEntry + "G111 " + kMill, each),
            "alarm b2 missing-word missing-word missing-word missing-word");
  EXPECT_EQ(ending(kEntry + "G111", each),
            "alarm b2 missing-word missing-word missing-word missing-word");
  EXPECT_EQ(judged(kEntry + "G111 I16 L3 Q50 D4 " + kMill, each), judged(kEntry + "G111 " + kMill));
  // The same code again asks for nothing.
  EXPECT_EQ(judged(kEntry + "G110 " + kMill, each), kMilled);
}

TEST(Mode, Mod05TheInitialPlaneIsWhereTheModeWasEntered) {
  // Ends at the R plane Y-5; the next R counts from 0 again.
  const Lines two = judged("G110 I16 L3 Q50 D4 F800 X0 Z0 V-5 R-5\nX0 Z0 V-5 R-7",
                           profile_with({{"gsk.pocket.end", "r-plane"}}));
  ASSERT_EQ(two.size(), 12U);
  EXPECT_EQ(two[1], "rapid y-5");
  EXPECT_EQ(two[7], "rapid y-7");
  EXPECT_EQ(two[8], "feed y-12 f800");
}

TEST(Mode, Mod05AnEntryThatMillsNothingSetsTheInitialPlane) {
  EXPECT_EQ(judged("G0 Y50\n" + kEntry + kMill).back(), "rapid y50");
}

TEST(Mode, Mod05AnotherEntryTakesTheNewDepth) {
  const Lines two = judged(kEntry + kMill + "\nG0 Y30\n" + kEntry + kMill);
  ASSERT_EQ(two.size(), 15U);
  EXPECT_EQ(two[7], "rapid y30");
  EXPECT_EQ(two[9], "rapid y30");
  EXPECT_EQ(two.back(), "rapid y30");
}

TEST(Mode, Mod05APlaneCodeTakesTheCoordinateOfTheNewDepthAxis) {
  // G18 at Y50, Z20; then G17: the initial plane is Z20, W-5 the bottom Z15.
  EXPECT_EQ(judged("G0 Y50 Z20\n" + kEntry + "G17 X0 Y0 W-5"),
            (Lines{"rapid y50 z20", "rapid x0 y0", "rapid z20", "feed z15 f800",
                   "level d15 c0,0 R16 r4 L3 -1 f800", "rapid z20", "rapid x0 y0", "rapid z20"}));
}

TEST(Mode, Mod05APlaneCodeOfItsOwnBlockDoesSo) {
  EXPECT_EQ(judged("G0 Y50 Z20\n" + kEntry + "G17\nX0 Y0 W-5"),
            judged("G0 Y50 Z20\n" + kEntry + "G17 X0 Y0 W-5"));
}

// The plane in force has no new depth axis: the tool is at the R plane, and R counts from where the
// mode was entered.
TEST(Mode, Mod05ThePlaneWrittenAgainLeavesTheInitialPlane) {
  const Profile stays = profile_with({{"gsk.pocket.end", "r-plane"}});
  for (const char* between : {"\nG18 ", "\nG18\n"}) {
    const Lines two = judged(
        "G110 I16 L3 Q50 D4 F800 X0 Z0 V-5 R-5" + std::string(between) + "X0 Z0 V-5 R-7", stays);
    ASSERT_EQ(two.size(), 12U);
    EXPECT_EQ(two[7], "rapid y-7") << between;
  }
}

TEST(Mode, Clause15EveryCodeOfGroup01EndsTheMode) {
  for (const char* code : {"G0", "G1", "G94", "G00", "G01"}) {
    // Entered anew: all four are missing.
    const std::string program = kEntry + code + "\nG110 " + kMill;
    EXPECT_EQ(ending(program), kAllMissing) << code;
  }
  for (const char* arc : {"G2", "G3"}) {
    EXPECT_EQ(ending(kEntry + arc + "\nG110 " + kMill), kAllMissing) << arc;
  }
}

TEST(Mode, Clause15G80EndsTheMode) {
  EXPECT_EQ(ending(kEntry + "G80\nG110 " + kMill), kAllMissing);
}

TEST(Mode, Mod06AfterG80AxisWordsAreTraversesInItsOwnBlockToo) {
  EXPECT_EQ(lines(kEntry + "G80 X10\nX20 Z5"), (Lines{"rapid x5", "rapid x10 z5"}));
}

TEST(Mode, Mod06AfterG01AndTheModeG80StillPositions) {
  EXPECT_EQ(lines("G1 F100\n" + kEntry + "G80 X10"), Lines{"rapid x5"});
}

Profile keeping() {
  return profile_with({{"gsk.g80.motion", "kept"}});
}

TEST(Mode, Mod06G80KeepsTheMotionOfBeforeUnderItsReading) {
  EXPECT_EQ(lines("G1 Z-5 F100\nG80\nZ-10", keeping()), (Lines{"feed z-5 f100", "feed z-10 f100"}));
  // In its own block, and behind the mode, whose F is 800.
  EXPECT_EQ(lines("G1 F100\n" + kEntry + "G80 X10\nX20", keeping()),
            (Lines{"feed x5 f800", "feed x10 f800"}));
  EXPECT_EQ(lines(kEntry + "G80 X10", keeping()), Lines{"rapid x5"});
}

TEST(Mode, Mod06G80KeepsTheMotionOfBeforeACuttingCycleUnderItsReading) {
  for (const std::string cycle : {"G90", "G94", "G90\nG94", "G94\nG28 U0"}) {
    EXPECT_EQ(lines("G1 F100\n" + cycle + "\nG80 X10\nX20", keeping()).back(), "feed x10 f100")
        << cycle;
    EXPECT_EQ(lines("G0 F100\n" + cycle + "\nG80 X10\nX20", keeping()).back(), "rapid x10")
        << cycle;
  }
  // Another code of the group, or one beside it, holds.
  EXPECT_EQ(lines("G1 F100\nG94\nG0\nG80 X10", keeping()), Lines{"rapid x5"});
  EXPECT_EQ(lines("G1 F100\nG80 G0 X10", keeping()), Lines{"rapid x5"});
}

TEST(Mode, Mod06AnArcInForceNeedsARadiusBehindG80UnderItsReading) {
  EXPECT_EQ(ending("G2 W10 R5 F100\nG80\nW10", keeping()), "alarm b3 missing-word");
  EXPECT_EQ(lines("G2 W10 R5 F100\nG80\nW10"), (Lines{"arc x0 z10 c5,0 rot-1 f100", "rapid z20"}));
}

TEST(Mode, Mod06WhatG80LeavesIsAskedWhereSomethingElseWasInForce) {
  const Lines asked = {"gsk.g80.motion"};
  EXPECT_EQ(touched_readings("G1 Z-5 F100\nG80\nZ-10"), asked);
  EXPECT_EQ(touched_readings("G1 F100\nG94\nG80\nZ-10"), asked);
  EXPECT_EQ(touched_readings("G0 Z-5\nG80\nZ-10"), Lines{});
  EXPECT_EQ(touched_readings("G1 Z-5 F100\nG80 G0 Z-10"), Lines{});
}

// GSK-MOD-06, GSK-MOD-09, J-ALM-04: they are of one group, or exclude each other.
TEST(Mode, Mod06G80BesideAMillingCycleAdmitsTwoClasses) {
  for (const char* program : {"G80 G112 X1 Y1 W-2 I6 D4 F100", "G112 G80 X1 Y1 W-2 I6 D4 F100",
                              "G110 G112 X1 Y1 W-2 I6 L4 Q2 D4 F100"}) {
    const std::vector<Item> items = expand(program);
    const auto& report = std::get<AlarmReport>(items.back());
    EXPECT_TRUE(admits(report, "duplicate-word")) << program;
    EXPECT_TRUE(admits(report, "conflicting-words")) << program;
    EXPECT_FALSE(admits(report, "missing-word")) << program;
  }
  const std::vector<Item> items = expand("G112 X1 X1 Y1 W-2 I6 D4 F100");
  EXPECT_FALSE(admits(std::get<AlarmReport>(items.back()), "conflicting-words"));
}

TEST(Mode, Mod06G80EndsG94) {
  EXPECT_EQ(lines("G94 F100\nG80 X10\nX20"), (Lines{"rapid x5", "rapid x10"}));
}

TEST(Mode, Mod06G80ClearsWhatG94Retains) {
  const Lines path = lines("G94 X10 Z-5 R-1 F100\nG80\nG94 X20");
  ASSERT_EQ(path.size(), 8U);
  EXPECT_EQ(path[4], "rapid z0");  // no travel, no R
}

TEST(Mode, Mod06ACodeOfGroup01BesideG80Holds) {
  EXPECT_EQ(lines(kEntry + "G80 G1 X10 F100"), Lines{"feed x5 f100"});
}

TEST(Mode, Mod07RetainedWordsOfThePocketAreLengths) {
  // I1 L0.1 Q1 D0.25 in inches; then G21 with a pocket in millimetres, 5 deep.
  EXPECT_EQ(judged("G20 G110 I1 L0.1 Q1 D0.25 F10\nG21 X0 Z0 V-5")[3],
            "level d-5 c0,0 R25.4 r6.35 L2.54 -1 f254");
}

// I1 L0.1 D0.25 are millimetres now.
TEST(Mode, Mod07RetainedWordsOfThePocketAreNumbersUnderTheirReading) {
  const Profile number = profile_with({{"gsk.pocket.retained", "number"}});
  const std::string entry = "G20 G110 I1 L0.1 Q1 D0.25 F10\nG21 X0 Z0 V-5";
  EXPECT_EQ(judged(entry + " Q5", number)[3], "level d-5 c0,0 R1 r0.25 L0.1 -1 f254");
  EXPECT_EQ(judged(entry + " I20 Q5", number)[3], "level d-5 c0,0 R20 r0.25 L0.1 -1 f254");
  const Lines asked = {"gsk.pocket.retained", "gsk.feed-units"};
  EXPECT_EQ(touched_readings("G20 G112 I1 D0.25 F10\nG21"), asked);
  EXPECT_EQ(touched_readings("G20 G112 I1 D0.25 F10\nG21 G00"), Lines{"gsk.feed-units"});
}

TEST(Mode, Mod07RetainedWordsOfG94AreLengths) {
  const Lines path = lines("G20 G94 X2 Z-1 F10\nG21 R-1");
  ASSERT_EQ(path.size(), 8U);
  EXPECT_EQ(Lines(path.begin() + 4, path.end()),
            (Lines{"rapid z-26.4", "feed x25.4 z-25.4 f254", "feed z0 f254", "rapid x0"}));
}

TEST(Mode, Mod07ARetainedWordOfAnAxisOutsideThePlaneWaits) {
  // In G17 X is kept and Z waits; back in G18 both are there.
  EXPECT_EQ(lines("G94 X20 Z-5 F100\nG17 Y3\nG18 R-1"),
            (Lines{"rapid z-5", "feed x10 z-5 f100", "feed z0 f100", "rapid x0", "rapid x10",
                   "feed x10 y3 f100", "feed x0 f100", "rapid y0", "rapid z-6", "feed x10 z-5 f100",
                   "feed z0 f100", "rapid x0"}));
}

TEST(Mode, Mod07ARetainedIncrementIsTakenFromAAgain) {
  EXPECT_EQ(lines("G0 X120 Z10\nG94 U-20 W-30 F100\nR-1"),
            (Lines{"rapid x60 z10", "rapid z-20", "feed x50 z-20 f100", "feed z10 f100",
                   "rapid x60", "rapid z-21", "feed x50 z-20 f100", "feed z10 f100", "rapid x60"}));
}

TEST(Mode, Mod07AFeedIsALengthToo) {
  EXPECT_EQ(lines("G20 F10\nG21 G1 X2"), Lines{"feed x1 f254"});
}

TEST(Mode, Mod08ACodeOfGroup00ClearsNothingOfThePocket) {
  for (const char* code : {"G4 P100", "G28 W0", "G50 X0 Z0"}) {
    const Lines path = judged(kEntry + code + "\n" + kMill);
    ASSERT_GE(path.size(), 7U) << code;
    EXPECT_EQ(Lines(path.end() - 7, path.end()), kMilled) << code;
  }
}

TEST(Mode, Mod08ABlockOfGroup00MillsNothing) {
  EXPECT_EQ(judged(kEntry + "G50 X0 Y0 Z0"), Lines{"rename x0 y0 z0 a0 c0"});
}

TEST(Mode, Mod08RenamingRenamesTheInitialPlane) {
  // The plane at Y50 is called Y0 from there on: V-5 leads to Y-5 and the end is Y0.
  const Lines path = judged("G0 Y50\n" + kEntry + "G50 Y0\n" + kMill);
  ASSERT_EQ(path.size(), 9U);
  EXPECT_EQ(path[1], "rename x0 y-50 z0 a0 c0");
  EXPECT_EQ(Lines(path.begin() + 2, path.end()), kMilled);
}

TEST(Mode, Mod09ACodeOfGroup01AndOneOfThePocketsExcludeEachOther) {
  for (const char* code : {"G0", "G1", "G2", "G3", "G94"}) {
    for (const char* cycle : {"G110", "G111"}) {
      const std::string program = std::string(code) + " " + cycle + " X0 Z0 Y-5 I16 L3 Q5 D4 F800";
      EXPECT_EQ(ending(program), "alarm b1 conflicting-words") << program;
    }
  }
}

TEST(Mode, APlaneCodeHoldsUntilTheNext) {
  EXPECT_EQ(judged("G17\n" + kEntry + "X0 Y0 Z-5")[2], "feed z-5 f800");
  EXPECT_EQ(judged("G17\nG19\n" + kEntry + "Y0 Z0 X-10")[2], "feed x-5 f800");
}

TEST(Mode, TheFeedOfThePocketStaysInForce) {
  EXPECT_EQ(lines(kEntry + "G1 X10"), Lines{"feed x5 f800"});
}

TEST(Mode, AProgramTouchesTheReadingsThatItMeets) {
  const auto touches = [](const char* program, std::string_view name) {
    for (const std::string& touched : touched_readings(program, {}, OpenPaths::judged)) {
      if (touched == name) return true;
    }
    return false;
  };
  EXPECT_FALSE(touches("G0 X1", "gsk.pocket.end"));
  EXPECT_TRUE(touches("G110 X0 Z0 V-1 I16 L3 Q5 D4 F8", "gsk.pocket.end"));
  EXPECT_FALSE(touches("G110 X0 Z0 V-1 I16 L3 Q5 D4 F8", "gsk.x-depth"));
  EXPECT_TRUE(touches("G19 G110 Y0 Z0 U-1 I16 L3 Q5 D4 F8", "gsk.x-depth"));
  EXPECT_FALSE(touches("G110 X0 Z0 V-1 P1 I16 L3 Q5 D4 F8", "gsk.pocket.p-omitted"));
  EXPECT_TRUE(touches("G110 X0 Z0 V-1 I16 L3 Q5 D4 F8", "gsk.pocket.p-omitted"));
  EXPECT_FALSE(touches("G94 X1 F8", "gsk.g94.rewrite"));
  EXPECT_TRUE(touches("G94 X1 R-1 F8\nG94 X2", "gsk.g94.rewrite"));
  EXPECT_FALSE(touches("G94 X1 R-1 F8\nG94 X2 R0", "gsk.g94.rewrite"));
  EXPECT_FALSE(touches("G94 X1 F8\nX2", "gsk.g94.after-00"));
  EXPECT_TRUE(touches("G94 X1 F8\nG50 X0\nX2", "gsk.g94.after-00"));
  EXPECT_FALSE(touches("G110 X0 Z0 V-1 I16 L3 Q5 D4 F8", "gsk.zero-depth"));
  EXPECT_TRUE(touches("G110 X0 Z0 V0 I16 L3 Q5 D4 F8", "gsk.zero-depth"));
}

}  // namespace
}  // namespace gonogo::reference::testing
