// SPDX-License-Identifier: GPL-3.0-or-later
//
// Basic codes, lines of a program and the initial state: GSK-COM-04, 05 and 08. X and U words
// are diameters; records are true lengths in mm.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

std::vector<std::uint64_t> blocks_of(std::string_view program) {
  std::vector<std::uint64_t> blocks;
  for (const Item& item : expand(program)) blocks.push_back(std::get<Record>(item).block);
  blocks.pop_back();  // the end
  return blocks;
}

Profile by_radius() {
  Profile profile;
  profile.x_diameter = false;
  return profile;
}

TEST(Basic, ATraverseNamesTheAxesThatAreCommanded) {
  const Lines want = {"rapid x25 z20", "rapid y5", "rapid c90"};
  EXPECT_EQ(lines("G0 X50 Z20\nG0 Y5\nG0 C90"), want);
}

TEST(Basic, PowerOnIsPositioningInMillimetresByDiameter) {
  const Lines want = {"rapid x25"};
  EXPECT_EQ(lines("X50"), want);
}

TEST(Basic, ANumberWithoutAPointIsMillimetres) {
  const Lines want = {"rapid z50", "rapid z50", "rapid z50", "rapid z0.5", "rapid z-0.5"};
  EXPECT_EQ(lines("Z50\nZ50.\nZ050.000\nZ.5\nZ-.5"), want);
}

TEST(Basic, XAndUAreDiametersInEveryPlane) {
  for (const char* plane : {"G17", "G18", "G19"}) {
    const Lines want = {"rapid x25", "rapid x20"};
    EXPECT_EQ(lines(std::string(plane) + " G0 X50\nU-10"), want) << plane;
  }
}

TEST(Basic, XAndUAreLengthsInRadiusProgramming) {
  for (const char* plane : {"G17", "G18", "G19"}) {
    const Lines want = {"rapid x50", "rapid x40"};
    EXPECT_EQ(lines(std::string(plane) + " G0 X50\nU-10", by_radius()), want) << plane;
  }
}

TEST(Basic, UVWAndHAreIncrements) {
  const Lines want = {"rapid x5 y20 z30 c40", "rapid x5.5", "rapid y18", "rapid z33", "rapid c36"};
  EXPECT_EQ(lines("X10 Y20 Z30 C40\nU1\nV-2\nW3\nH-4"), want);
}

TEST(Basic, AStraightFeedIsModalAndSoIsF) {
  const Lines want = {"feed x25 f100", "feed z-5 f100", "feed z-6 f50"};
  EXPECT_EQ(lines("G1 X50 F100\nZ-5\nF50\nZ-6"), want);
}

TEST(Basic, FeedPerRevolutionIsModal) {
  const Lines want = {"feed z1 f0.2/rev", "feed z2 f0.2/rev", "feed z3 f100"};
  EXPECT_EQ(lines("G99 G1 Z1 F0.2\nZ2\nG98 Z3 F100"), want);
}

TEST(Basic, AMotionOfItsOwnCodeIsNotAskedForAFeed) {
  EXPECT_EQ(ending("G0 X50"), "end x25 y0 z0 a0 c0");
}

TEST(Basic, Com04AStraightFeedWithoutFIsAnAlarm) {
  EXPECT_EQ(ending("G1 X50"), "alarm b1 feed-missing");
  EXPECT_EQ(ending("G1\nX50"), "alarm b2 feed-missing");
  EXPECT_EQ(ending("G1"), "end x0 y0 z0 a0 c0");
}

TEST(Basic, Com04TheFeedOfTheInitialStateIsInForce) {
  Profile profile;
  profile.initial.feed = num("300");
  EXPECT_EQ(lines("G1 X50", profile), Lines{"feed x25 f300"});
}

TEST(Basic, Com08F0IsNoFeed) {
  EXPECT_EQ(ending("G1 X50 F0"), "alarm b1 feed-missing");
  EXPECT_EQ(ending("F100\nG1 X50 F0"), "alarm b2 feed-missing");
  EXPECT_EQ(lines("G1 X50 F0.001"), Lines{"feed x25 f0.001"});
}

TEST(Basic, Com08ANegativeFIsAnAlarmWhereverItStands) {
  EXPECT_EQ(ending("G0 X50 F-0.001"), "alarm b1 value-sign");
  EXPECT_EQ(ending("F-1"), "alarm b1 value-sign");
}

TEST(Basic, InchesHoldForLengthsAndFeedsFromTheirBlockOn) {
  // X1 is a radius of 12.7; F10 is 254 mm/min; F0.01 is 0.254 mm/rev.
  const Lines want = {"rapid x12.7 z25.4", "feed z50.8 f254", "feed z76.2 f0.254/rev",
                      "feed z1 f0.254/rev"};
  EXPECT_EQ(lines("G20 X1 Z1\nG1 Z2 F10\nG99 Z3 F0.01\nG21 Z1"), want);
}

TEST(Basic, ALeastIncrementInInches) {
  const Lines want = {"rapid x0.00127 z-0.00254"};
  EXPECT_EQ(lines("G20 X0.0001 Z-0.0001"), want);
}

TEST(Basic, TheUnitsOfTheProfileArePowerOn) {
  Profile profile;
  profile.units = Units::inch;
  const Lines want = {"rapid z25.4", "rapid z1"};
  EXPECT_EQ(lines("Z1\nG21 Z1", profile), want);
}

TEST(Basic, DegreesAndSecondsAreTheSameInInches) {
  const Lines want = {"rapid c90", "rapid c60", "dwell 1.5", "dwell 2"};
  EXPECT_EQ(lines("G20 C90\nH-30\nG4 P1500\nG4 X2"), want);
}

TEST(Basic, ADwellIsMillisecondsByPAndSecondsByXOrU) {
  const Lines want = {"dwell 1.5", "dwell 2.5", "dwell 0.5"};
  EXPECT_EQ(lines("G4 P1500\nG4 X2.5\nG4 U0.5"), want);
  EXPECT_EQ(ending("G4 X2.5"), "end x0 y0 z0 a0 c0");
}

TEST(Basic, ADwellWithoutATimeIsAMissingWord) {
  EXPECT_EQ(ending("G4"), "alarm b1 missing-word");
}

TEST(Basic, TheReferencePointIsReachedThroughThePointOfTheWords) {
  Profile profile;
  profile.reference_point[Axis::x] = num("200");
  profile.reference_point[Axis::z] = num("300");
  const Lines want = {"rapid x25 z20", "rapid x30 z25", "rapid x200 z300", "rapid x190",
                      "rapid x200"};
  EXPECT_EQ(lines("X50 Z20\nG28 X60 W5\nG28 U-20", profile), want);
  EXPECT_EQ(ending("X50 Z20\nG28 U0", profile), "end x200 y0 z20 a0 c0");
}

TEST(Basic, WithoutOneInTheProfileTheReferencePointIsZero) {
  const Lines want = {"rapid x25 z20", "rapid x25", "rapid x0"};
  EXPECT_EQ(lines("X50 Z20\nG28 U0"), want);
}

TEST(Basic, RenamingThePositionMovesNothing) {
  // The tool stands at radius 25, Z20 and is called X100 (radius 50), Z0 from there on.
  const Lines want = {"rapid x25 z20", "rename x25 y0 z-20 a0 c0", "rapid x45", "rapid z-5"};
  EXPECT_EQ(lines("X50 Z20\nG50 X100 Z0\nU-10\nZ-5"), want);
}

TEST(Basic, AfterG80AxisWordsAreTraverses) {
  const Lines want = {"feed z1 f100", "rapid z2", "rapid z3"};
  EXPECT_EQ(lines("G1 Z1 F100\nG80 Z2\nZ3"), want);
}

TEST(Basic, CodesWithoutEffectChangeNothing) {
  const std::string program = "G1 Z1 F100\nZ2";
  for (const char* codes : {"G40", "G54", "G97", "G96 S100", "S1000", "T0101"}) {
    EXPECT_EQ(lines(codes + std::string(" ") + program), lines(program)) << codes;
    EXPECT_EQ(lines(codes + std::string("\n") + program), lines(program)) << codes;
  }
}

TEST(Basic, MFunctionsArePassedOn) {
  EXPECT_EQ(lines("M3 S500\nM08\nM5"), (Lines{"m3", "m8", "m5"}));
}

TEST(Basic, NothingRunsAfterTheEndOfTheProgram) {
  for (const char* end : {"M2", "M17", "M30", "M02"}) {
    const Lines program = lines(std::string("Z1\n") + end + "\nZ2\nG6");
    ASSERT_EQ(program.size(), 2U) << end;
    EXPECT_EQ(program[0], "rapid z1") << end;
    EXPECT_EQ(ending(std::string("Z1\n") + end + "\nZ2\nG6"), "end x0 y0 z1 a0 c0") << end;
  }
}

TEST(Basic, TheMotionOfTheEndingBlockRuns) {
  EXPECT_EQ(lines("Z1\nZ2 M30\nZ3"), (Lines{"rapid z1", "rapid z2", "m30"}));
}

TEST(Basic, LeadingZerosAreFree) {
  EXPECT_EQ(lines("G00 Z1\nG001 Z2 F0100\nM003"), lines("G0 Z1\nG1 Z2 F100\nM3"));
}

TEST(Basic, SeveralCodesOfDifferentGroupsMayShareABlock) {
  EXPECT_EQ(lines("G17 G20 G99 G1 X2 Y1 F0.1"), Lines{"feed x25.4 y25.4 f2.54/rev"});
}

TEST(Basic, Com08AfterASemicolonTheLineIsIgnored) {
  EXPECT_EQ(lines("Z1; Z2 ? #5 (\nZ3"), (Lines{"rapid z1", "rapid z3"}));
}

TEST(Basic, CommentsProgramNumbersAndTapeMarksMoveNothing) {
  EXPECT_EQ(lines("%\nO1234 (FACE)\n(Z5)\nN10 Z1 (Z7)\n%"), Lines{"rapid z1"});
}

TEST(Basic, BlockSkipIsOffByDefault) {
  EXPECT_EQ(lines("/Z1\n/N5 Z2"), (Lines{"rapid z1", "rapid z2"}));
}

TEST(Basic, BlockSkipLeavesOutTheBlocksWithASlash) {
  Profile profile;
  profile.block_skip = true;
  EXPECT_EQ(lines("/Z1\nZ2\n/N5 G6 Z3\n/G1 F100\nZ4", profile), (Lines{"rapid z2", "rapid z4"}));
}

TEST(Basic, BlockNumbersCountEveryLine) {
  EXPECT_EQ(blocks_of("Z1\nZ2\nZ3"), (std::vector<std::uint64_t>{1, 2, 3}));
  EXPECT_EQ(blocks_of("\n\nZ1\n(note)\n\nN9 Z2\n"), (std::vector<std::uint64_t>{3, 6}));
}

TEST(Basic, BlockNumbersAreTheSameWithEveryLineEnd) {
  const std::vector<std::uint64_t> want = {1, 3, 5};
  EXPECT_EQ(blocks_of("Z1\n\nZ2\n;\nZ3"), want);
  EXPECT_EQ(blocks_of("Z1\r\n\r\nZ2\r\n;\r\nZ3\r\n"), want);
  EXPECT_EQ(blocks_of("Z1\r\rZ2\r;\rZ3\r"), want);
  EXPECT_EQ(blocks_of("Z1\n\rZ2\r\n;\rZ3"), want);  // CR after LF is a line end of its own
}

TEST(Basic, AnAlarmHasTheNumberOfItsLine) {
  EXPECT_EQ(ending("Z1\r\n\r\nG6"), "alarm b3 undefined-code");
  EXPECT_EQ(ending("\r\r\rG71"), "not-covered b4 G71");
}

TEST(Basic, WhatStandsBehindTheProgramIsNotRun) {
  EXPECT_EQ(ending("%\nO0230\nG00 X50\n%\nG00 X40 X30\n"), "end x25 y0 z0 a0 c0");
  EXPECT_EQ(ending("%\nO0230\nG00 X50\nO0231\nG00 X40\n"), "not-covered b4 program-head");
}

TEST(Basic, AnEmptyProgramEndsAtTheInitialState) {
  Profile profile;
  profile.initial.at[Axis::x] = num("1.5");
  profile.initial.at[Axis::a] = num("30");
  EXPECT_EQ(ending("", profile), "end x1.5 y0 z0 a30 c0");
  EXPECT_EQ(ending("\n\n(nothing)\n", profile), "end x1.5 y0 z0 a30 c0");
}

TEST(Basic, IncrementsCountFromTheInitialState) {
  Profile profile;
  profile.initial.at[Axis::x] = num("10");
  profile.initial.at[Axis::z] = num("-4");
  EXPECT_EQ(lines("U2 W1", profile), Lines{"rapid x11 z-3"});
}

TEST(Basic, TheInitialMotionAndPlaneAreThoseOfTheProfile) {
  Profile profile;
  profile.initial.motion = 1;
  profile.initial.plane = Plane::g17;
  profile.initial.at[Axis::x] = num("10");
  EXPECT_EQ(lines("Z1 F100\nG3 I-10", profile),
            (Lines{"feed z1 f100", "arc x10 y0 c0,0 rot1 f100"}));
}

}  // namespace
}  // namespace gonogo::reference::testing
