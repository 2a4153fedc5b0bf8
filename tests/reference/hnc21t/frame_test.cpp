// SPDX-License-Identifier: GPL-3.0-or-later
//
// Work offsets, G92, absolute and incremental words, diameters, inches.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// Offsets are true lengths: G54 (100, 200), G55 (-1, -2), G59 (10, 20).
Profile with_offsets(
    std::initializer_list<std::pair<std::string_view, std::string_view>> readings = {}) {
  Profile profile = hnc(readings);
  const auto set = [&](const char* name, int x, int z) {
    profile.offsets[name][Axis::x] = x;
    profile.offsets[name][Axis::z] = z;
  };
  set("G54", 100, 200);
  set("G55", -1, -2);
  set("G59", 10, 20);
  return profile;
}

// The textbook's program of work coordinates, %3303.
TEST(Frame, AbsoluteWordsAreInTheWorkCoordinates) {
  EXPECT_EQ(path("%3303\nN01 G54G00G90X40Z30\nN02 G59\nN03 G00X30Z30\nN04 M30", with_offsets()),
            (Lines{"rapid x120 z230", "rapid x25 z50"}));
}

TEST(Frame, AnOffsetMovesNothingByItself) {
  EXPECT_EQ(path("G59\nG55\nG54", with_offsets()), Lines{});
}

TEST(Frame, IncrementsKnowNoOffset) {
  EXPECT_EQ(path("G59 U20 W3", with_offsets()), Lines{"rapid x10 z3"});
  EXPECT_EQ(path("G59 G91 X20 Z3", with_offsets()), Lines{"rapid x10 z3"});
}

TEST(Frame, G54HoldsAtPowerOn) {
  EXPECT_EQ(path("G00 X40 Z30", with_offsets()), Lines{"rapid x120 z230"});
  EXPECT_EQ(path("G00 X40 Z30", with_offsets({{"hnc.offset.initial", "none"}})),
            Lines{"rapid x20 z30"});
}

TEST(Frame, AsksForTheInitialOffsetOnlyWhereItMatters) {
  EXPECT_EQ(touched("G00 X40 Z30"), Lines{});
  EXPECT_EQ(touched("G54 G00 X40 Z30", with_offsets()), Lines{});
  EXPECT_EQ(touched("G00 U40 W30", with_offsets()), Lines{});
  EXPECT_EQ(touched("G00 X40", with_offsets()), Lines{"hnc.offset.initial"});
}

// A Z0 of the machine, C X20 Z-10 in G59: (10 + 10, 20 - 10).
TEST(Frame, CyclesAreInTheWorkCoordinates) {
  EXPECT_EQ(path("G59 G80 X20 Z-10 F100", with_offsets()),
            (Lines{"rapid x20", "feed x20 z10 f100", "feed x0 f100", "rapid z0"}));
  EXPECT_EQ(path("G59 G74 Z-10 F100", with_offsets()).at(0), "feed z10 f100");
  EXPECT_EQ(path("G59 G75 X20 Z-10 I1 F100", with_offsets()).at(2), "rapid z10");
}

// A kept coordinate is a place of the base frame.
TEST(Frame, AKeptCoordinateDoesNotFollowTheOffset) {
  EXPECT_EQ(
      path("G54 G80 X20 Z-10 F100\nG59 X20", with_offsets({{"hnc.missing-axis", "keep"}})).at(5),
      "feed x20 z190 f100");
}

TEST(Frame, G92RenamesThePosition) {
  EXPECT_EQ(path("G00 X10 Z5\nG92 X40 Z30\nG01 U2 W1 F100"),
            (Lines{"rapid x5 z5", "rename x15 y0 z25 a0 c0", "feed x21 z31 f100"}));
}

TEST(Frame, G92NamesOnlyItsAxes) {
  EXPECT_EQ(path("G00 X10 Z5\nG92 Z30").at(1), "rename x0 y0 z25 a0 c0");
  EXPECT_EQ(path("G92"), Lines{"rename x0 y0 z0 a0 c0"});
}

// The new coordinates are those of the offset in force: 20 + 10 and 30 + 20.
TEST(Frame, G92IsInTheWorkCoordinates) {
  EXPECT_EQ(path("G59\nG92 X40 Z30\nG00 X40 Z30", with_offsets()),
            (Lines{"rename x30 y0 z50 a0 c0", "rapid x30 z50"}));
}

TEST(Frame, G92IsAbsoluteUnderG91AndIncrementalByUAndW) {
  EXPECT_EQ(path("G00 X10 Z5\nG91 G92 X40 Z30").at(1), "rename x15 y0 z25 a0 c0");
  EXPECT_EQ(path("G00 X10 Z5\nG92 U40 W30").at(1), "rename x20 y0 z30 a0 c0");
  EXPECT_EQ(ending_of("G92 X1 U1"), "alarm b1 conflicting-words");
}

TEST(Frame, G92WordsAreNoWordsOfTheCycleInForce) {
  EXPECT_EQ(path("G80 I-5 F100\nG92 X40 Z30 I9\nX20 Z10"), Lines{"not-covered b2 I"});
  EXPECT_EQ(path("G80 I-5 F100\nG92 X40 Z30\nX20 Z10"),
            (Lines{"rename x20 y0 z30 a0 c0", "rapid x5", "feed x10 z10 f100", "feed x20 f100",
                   "rapid z30"}));
}

// The textbook's pair of programs in diameters and in radii; F is ours.
TEST(Frame, DiametersAndRadiiAreOneProgram) {
  const Lines want = {"rename x90 y0 z254 a0 c0", "feed x10 z210 f100", "feed x25 z50 f100",
                      "rapid x90 z254"};
  EXPECT_EQ(path("%3341\nN1 G92X180Z254\nN2 G36G01X20W-44F100\nN3 U30Z50\nN4 G00X180Z254\nN5 M30"),
            want);
  Profile radius = hnc();
  radius.x_diameter = false;
  EXPECT_EQ(
      path("%3342\nN1 G92X90Z254\nN2 G37G01X10W-44F100\nN3 U15Z50\nN4 G00X90Z254\nN5 M30", radius),
      want);
}

TEST(Frame, G36AndG37HoldFromTheirBlockOn) {
  EXPECT_EQ(path("G37 G00 X10\nX12\nG36 X10\nU2"),
            (Lines{"rapid x10", "rapid x12", "rapid x5", "rapid x6"}));
}

// The textbook's figure of G90, G91 and both in one program.
TEST(Frame, AbsoluteAndIncrementalWordsMix) {
  const Lines want = {"feed x7.5 z20 f100", "feed x22.5 z40 f100", "feed x12.5 z60 f100",
                      "feed x0 z0 f100"};
  EXPECT_EQ(path("G01X15Z20F100\nX45Z40\nX25Z60\nX0Z0"), want);
  EXPECT_EQ(path("G91\nG01X15Z20F100\nX30Z20\nX-20Z20\nX-25Z-60"), want);
  EXPECT_EQ(path("G01X15Z20F100\nU30Z40\nX25W20\nX0Z0"), want);
}

TEST(Frame, InchesHoldForLengthsAndFeeds) {
  EXPECT_EQ(path("G20 G01 X1 Z1 F10\nG21 X2"), (Lines{"feed x12.7 z25.4 f254", "feed x1 f254"}));
  Profile inch = hnc();
  inch.units = Units::inch;
  EXPECT_EQ(path("G00 X1", inch), Lines{"rapid x12.7"});
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
