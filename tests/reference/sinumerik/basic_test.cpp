// SPDX-License-Identifier: GPL-3.0-or-later
//
// Straight motions, dwells, feeds, units, M functions: SIE-G1, SIE-ADDR, SIE-MOD, SIE-COM.
#include <gtest/gtest.h>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

TEST(SieBasic, TheSampleOfTheManualRuns) {
  const Lines expected = {"rapid x20 y20 z2", "feed z-2 f40", "feed x80 y80 z-15 f40",
                          "rapid z100"};
  EXPECT_EQ(path("N10 G17 S400 M3\nN20 G0 X20 Y20 Z2\nN30 G1 Z-2 F40\nN40 X80 Y80 Z-15\n"
                 "N50 G0 Z100 M30\nX1"),
            expected);
}

TEST(SieBasic, ARotaryAxisGoesAlong) {
  EXPECT_EQ(path("G1 G90 X100 Y20 Z30 A40 F100"), Lines{"feed x100 y20 z30 a40 f100"});
  EXPECT_EQ(line("G0 A40\nG91 A5 C=AC(7)", 1), "rapid a45 c7");
}

TEST(SieBasic, AcAndIcGoBeforeTheModeInForce) {
  EXPECT_EQ(line("G0 X10 Y10\nX=IC(5) Y20", 1), "rapid x15 y20");
  EXPECT_EQ(line("G0 X10 Y10\nG91 X=AC(5) Y20 Z3", 1), "rapid x5 y30 z3");
  EXPECT_EQ(line("G0 G91 X10\nX10\nG90 X1", 2), "rapid x1");
}

// By a setting of the machine: X of an end, whatever the mode and the unit; I and CR are lengths.
TEST(SieBasic, XIsADiameterWhereTheMachineSaysSo) {
  Profile profile = sie();
  profile.x_diameter = true;
  EXPECT_EQ(path("G0 X20 Y3\nG91 X10\nX=AC(8)\nG70 G90 X2", profile),
            (Lines{"rapid x10 y3", "rapid x15", "rapid x4", "rapid x25.4"}));
  EXPECT_EQ(centre(last_motion("G1 F100 Y0\nG2 X20 Y0 I5 J0", profile)), "5.000000000,0.000000000");
  EXPECT_EQ(centre(last_motion("G1 F100 Y0\nG2 X20 Y0 CR=5", profile)), "5.000000000,0.000000000");
  EXPECT_EQ(outcome("G0 X20\nG111 X5", profile), "not-covered X");
  EXPECT_EQ(outcome("G0 RP=5 AP=0", profile), "not-covered RP");
  EXPECT_EQ(outcome("CIP X10 Y0 I1=5 J1=5", profile), "not-covered I1");
  EXPECT_EQ(outcome("G2 X10 Y0 I=AC(5) J0", profile), "not-covered I");
}

// SIE-MOD-07
TEST(SieBasic, TheCodesOfTheCuttingSpeedChooseTheFeedToo) {
  EXPECT_EQ(path("G96 S120\nG1 X1 F0.2\nG97 S800\nX2\nG961 S90 F50\nX3\nG971\nX4"),
            (Lines{"feed x1 f0.2/rev", "feed x2 f0.2/rev", "feed x3 f50", "feed x4 f50"}));
  EXPECT_EQ(outcome("G95 G96"), "duplicate-word G");
}

// SIE-MOD-08. G97 gives a feed per revolution as G95 does: no change.
TEST(SieBasic, WhetherFStaysWhereTheFeedChangesIsAReading) {
  const Profile deletes = sie({{"sie.feed-change", "deleted"}});
  constexpr std::string_view kChange = "G1 X1 F100\nG95 X2";
  EXPECT_EQ(path(kChange, sie({{"sie.feed-change", "kept"}})),
            (Lines{"feed x1 f100", "feed x2 f100/rev"}));
  EXPECT_EQ(outcome_of_program(kChange, deletes), "feed-missing F");
  EXPECT_EQ(outcome_of_program("F100\nG961 S90\nG1 X1", deletes), "end");
  EXPECT_EQ(outcome_of_program("F100\nG95\nG94 G1 X1", deletes), "feed-missing F");
  EXPECT_EQ(path("G1 X1 F100\nG95 X2 F0.2\nG97 X3\nG95 X4", deletes),
            (Lines{"feed x1 f100", "feed x2 f0.2/rev", "feed x3 f0.2/rev", "feed x4 f0.2/rev"}));
  EXPECT_EQ(touched("S1 M3 F100\nG95 G0 X1\nF0.2\nG1 X2"), Lines{});
  EXPECT_EQ(touched("S1 M3 F100\nG95 G1 X1"), Lines{"sie.feed-change"});
  Profile comes_up = deletes;
  comes_up.initial.feed = 100;
  EXPECT_EQ(outcome_of_program("G1 X1\nG95 X2", comes_up), "feed-missing F");
}

// SIE-MOD-09, SIE-COM-05, SIE-COM-06: what the block does that a control may refuse.
TEST(SieBasic, RunsOnWhereNoTextHasAnAlarm) {
  EXPECT_EQ(path("G0 X1 M3 S600\nM5\nG4 S10"), (Lines{"rapid x1", "dwell 1"}));
  for (const char* block : {"G0 X1 T-1", "G0 X1 T1.5", "G0 X1 D-1", "G0 X1 D1.5", "G0 X1 D10",
                            "G0 X1 H1.5", "G0 X1 F0"}) {
    EXPECT_EQ(path(block), Lines{"rapid x1"}) << block;
    EXPECT_EQ(path(block, s802()), Lines{"rapid x1"}) << block;
  }
}

// 10 turns at 600 a minute last a second. After G97 alone the spindle turns as it did, however that
// was.
TEST(SieBasic, RevolutionsOfACuttingSpeedAreNotCovered) {
  EXPECT_EQ(path("S600\nG96 S120\nG97 S600\nG4 S10"), Lines{"dwell 1"});
  EXPECT_EQ(outcome("S600\nG96\nG4 S10"), "not-covered G4");
  EXPECT_EQ(outcome("S600\nG961 S120\nG971\nG4 S10"), "not-covered G4");
  EXPECT_EQ(outcome("S600\nG96\nG4 F1"), "end");
}

TEST(SieBasic, BeforeAnyCodeTheMotionIsAReading) {
  EXPECT_EQ(path("X1 F9"), Lines{"feed x1 f9"});
  EXPECT_EQ(path("X1 F9", sie({{"sie.initial-motion", "g0"}})), Lines{"rapid x1"});
  EXPECT_EQ(touched("F9 S1 M3\nG17\nG1 X1"), Lines{});
  EXPECT_EQ(touched("S1 M3 X1 F9"), Lines{"sie.initial-motion"});
  Profile traverses = sie();
  traverses.initial.motion = 0;
  EXPECT_EQ(path("X1", traverses), Lines{"rapid x1"});
  EXPECT_EQ(touched("X1", traverses), Lines{});
}

TEST(SieBasic, ACodeAloneMovesNothing) {
  EXPECT_EQ(path("G1\nG2\nCIP\nCT\nF9 G0\nX1"), Lines{"rapid x1"});
}

TEST(SieBasic, CuttingNeedsAFeed) {
  EXPECT_EQ(outcome_of_program("G1 X1"), "feed-missing F");
  EXPECT_EQ(outcome_of_program("F5\nF0\nG1 X1"), "feed-missing F");
  EXPECT_EQ(outcome_of_program("G0 X1 F5\nG1 X2"), "end");
  EXPECT_EQ(outcome_of_program("G2 I5"), "feed-missing F");
  EXPECT_EQ(outcome_of_program("CIP X5 I1=1 J1=1"), "feed-missing F");
  EXPECT_EQ(outcome_of_program("G0 X1\nCT X5 Y1"), "feed-missing F");
  EXPECT_EQ(clauses("G1 X1"), Lines{"SIE-COM-01"});
}

TEST(SieBasic, AFeedOrSpeedBelowZeroIsAnAlarm) {
  EXPECT_EQ(outcome("G0 F-1"), "value-sign F");
  EXPECT_EQ(outcome("S-1"), "value-sign S");
  EXPECT_EQ(outcome("G4 F-0.1"), "value-sign F");
}

TEST(SieBasic, TheSpindleIsAReading) {
  const Profile alarm = sie({{"sie.spindle", "alarm"}});
  EXPECT_EQ(outcome("G1 X1"), "end");
  EXPECT_EQ(outcome("G1 X1", alarm), "spindle-stopped S");
  EXPECT_EQ(outcome("G1 X1 M3", alarm), "spindle-stopped S");
  EXPECT_EQ(outcome("G1 X1 S100", alarm), "spindle-stopped S");
  EXPECT_EQ(outcome("M4 G1 X1 S100", alarm), "end");
  EXPECT_EQ(outcome("S100 M3\nG2 I5 M5", alarm), "spindle-stopped S");
  EXPECT_EQ(outcome("G0 X1", alarm), "end");
  Profile turning = alarm;
  turning.initial.spindle = 3;
  EXPECT_EQ(outcome("CIP X1 I1=0.5 J1=1", turning), "end");
  EXPECT_EQ(touched("S1 M3 F1\nG1 X1"), Lines{});
  EXPECT_EQ(touched("F1\nG1 X1"), Lines{"sie.spindle"});
}

TEST(SieBasic, InchesAreOfLengthsAlone) {
  EXPECT_EQ(line("G70 G1 X1 Y=IC(2) A3 F100", 0), "feed x25.4 y50.8 a3 f100");
  EXPECT_EQ(line("G70 G2 X2 I1 F10\nG71 G2 X0 CR=25.4", 1), "arc x0 y0 c25.4,0 rot-1 f10");
  EXPECT_EQ(line("G70 G0 RP=2 AP=90", 0), "rapid x0 y50.8");
  EXPECT_EQ(line("R1=2 G70\nG0 X=R1\nG71 X=R1", 1), "rapid x2");
}

TEST(SieBasic, WhatFIsUnderG70IsAReading) {
  const Profile inch = sie({{"sie.g70.f", "inch"}});
  EXPECT_EQ(line("G70 G1 X1 F10", 0, inch), "feed x25.4 f254");
  EXPECT_EQ(line("F10 G71\nG70 G1 X1 A5", 0, inch), "feed x25.4 a5 f254");
  EXPECT_EQ(line("G70 G1 A5 F10", 0, inch), "feed a5 f10");
  EXPECT_EQ(line("G70 G1 X0 A5 F10", 0, inch), "feed x0 a5 f10");
  EXPECT_EQ(line("G70 G2 I1 F10", 0, inch), "arc x0 y0 c25.4,0 rot-1 f254");
  EXPECT_EQ(touched("G70 F10\nG0 X1\nG1 A5\nG71 X1", inch), Lines{"sie.spindle"});
  EXPECT_EQ(touched("G70 F10 M3 S1\nG1 X1", inch), Lines{"sie.g70.f"});
}

TEST(SieBasic, FeedsAreOfMinutesOrRevolutions) {
  EXPECT_EQ(line("G95 G1 X1 F0.2", 0), "feed x1 f0.2/rev");
  EXPECT_EQ(line("G95 G1 X1 F0.2\nG94 X2 F100", 1), "feed x2 f100");
}

TEST(SieBasic, ADwellIsOfSecondsOrRevolutions) {
  EXPECT_EQ(path("S500 M3 F100\nG4 F2.5\nG4 S10\nG1 X1"),
            (Lines{"dwell 2.5", "dwell 1.2", "feed x1 f100"}));
  EXPECT_EQ(outcome("G4"), "missing-word F");
  EXPECT_EQ(outcome("G4 F1 S1"), "conflicting-words S");
  EXPECT_EQ(outcome("G4 S1"), "spindle-stopped S");
  EXPECT_EQ(outcome("G4 F1 X1"), "conflicting-words X");
  EXPECT_EQ(outcome("G1 G4 F1"), "conflicting-words G");
  EXPECT_EQ(outcome("G4 F1 M3"), "conflicting-words M");
}

// The text has it in a block of its own, and names no alarm: of what moves nothing it is ours.
TEST(SieBasic, WhatMovesNothingBesideADwellIsAnAlarmOfOurs) {
  for (const char* beside : {"M3", "T1", "D1", "H1", "G90", "G17", "R1=2"}) {
    EXPECT_EQ(clauses(std::string("G4 F1 ") + beside), Lines{"SIE-MOD-10"}) << beside;
  }
  for (const char* beside : {"X1", "I1", "CR=5", "AP=30", "G1", "CIP"}) {
    EXPECT_EQ(clauses(std::string("G4 F1 ") + beside), Lines{"SIE-MOD-03"}) << beside;
  }
}

TEST(SieBasic, MFunctionsStandRoundTheMotion) {
  EXPECT_EQ(lines("G0 X1 M8 M0\nM1 X2 M5\nM17 X3\nX4", sie()),
            (Lines{"m8", "rapid x1", "m0", "m5", "rapid x2", "m1", "rapid x3", "m17"}));
  EXPECT_EQ(outcome("M99"), "end");
  EXPECT_EQ(outcome("M2147483647"), "end");
  EXPECT_EQ(outcome("M2147483648"), "value-out-of-range M");
  EXPECT_EQ(outcome("M1.5"), "not-an-integer M");
  EXPECT_EQ(outcome("G4 S10 F-20"), "conflicting-words S, value-sign F");
}

TEST(SieBasic, ABlockWithASlashRunsUnlessBlocksAreSkipped) {
  EXPECT_EQ(path("/G0 X1\n/2 N5 G0 X2"), (Lines{"rapid x1", "rapid x2"}));
  Profile skips = sie();
  skips.block_skip = true;
  EXPECT_EQ(path("/G0 X1\n/2 N5 G0 X2\nG0 X3", skips), Lines{"rapid x3"});
}

TEST(SieBasic, AnAddressStandsOnce) {
  EXPECT_EQ(outcome("G0 X1 X2"), "duplicate-word X");
  EXPECT_EQ(outcome("G0 X1 X=AC(2)"), "duplicate-word X");
  EXPECT_EQ(outcome("F1 F1"), "duplicate-word F");
  EXPECT_EQ(outcome("G2 X1 CR=1 CR=2"), "duplicate-word CR");
  EXPECT_EQ(outcome("G0 R1=1 R1=2 H1 H2 M3 M8"), "end");
  EXPECT_EQ(outcome("CIP X2 I1=1 J1=1 J1=AC(1)"), "duplicate-word J1");
}

TEST(SieBasic, WordsOfOtherMotionsConflict) {
  EXPECT_EQ(outcome("G1 X1 I5"), "conflicting-words I");
  EXPECT_EQ(outcome("G0 CR=5"), "conflicting-words CR");
  EXPECT_EQ(outcome("G1 X1 AR=5 J1=3"), "conflicting-words AR, conflicting-words J1");
  EXPECT_EQ(outcome("G1 X1 TURN=1"), "conflicting-words TURN");
  EXPECT_EQ(outcome("G2 X10 CR=5 K1=1"), "conflicting-words K1");
  EXPECT_EQ(clauses("G0 X1 TURN=1"), Lines{"SIE-ARC-13"});
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
