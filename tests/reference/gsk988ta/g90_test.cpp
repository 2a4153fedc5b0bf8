// SPDX-License-Identifier: GPL-3.0-or-later
//
// G90: A is where the tool stands, B the start of the cut, C its programmed end, D the retreat.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

// The manual's cylinder: A X130 Z3, C X120 Z-110.
TEST(G90, CutsACylinder) {
  EXPECT_EQ(lines_after("G00 X130 Z3", "G18 G90 X120 Z-110 F200"),
            (Lines{"rapid x60", "feed x60 z-110 f200", "feed x65 f200", "rapid z3"}));
}

TEST(G90, NamesTheClauseOfEachMotion) {
  EXPECT_EQ(clauses_of("G90 X120 Z-110 F200"),
            (Lines{"GSK-G90-02", "GSK-G90-03", "GSK-G90-04", "GSK-G90-05"}));
}

TEST(G90, RepeatsWithTheWordsThatItRetains) {
  EXPECT_EQ(lines_after("G00 X130 Z3", "G90 X120 Z-30 F200\nX110").at(4), "rapid x55");
  EXPECT_EQ(lines_after("G00 X130 Z3", "G90 X120 Z-30 F200\nX110").at(5), "feed x55 z-30 f200");
}

// The manual's tapers from A X120 Z-30: B lies R beyond C on X, D is level with A on X. U is zero,
// so R has no opposite sign and no limit.
TEST(G90, CutsTheManualsTapers) {
  const Lines got =
      lines_after("G00 X120 Z-30", "G90 X120 Z-44 R-7.5 F150\nZ-56 R-15\nZ-68 R-22.5\nZ-80 R-30");
  EXPECT_EQ(got, (Lines{"rapid x52.5", "feed x60 z-44 f150", "feed x60 f150", "rapid z-30",
                        "rapid x45", "feed x60 z-56 f150", "feed x60 f150", "rapid z-30",
                        "rapid x37.5", "feed x60 z-68 f150", "feed x60 f150", "rapid z-30",
                        "rapid x30", "feed x60 z-80 f150", "feed x60 f150", "rapid z-30"}));
}

TEST(G90, TakesIncrementsFromA) {
  EXPECT_EQ(lines_after("G00 X130 Z3", "G90 U-20 W-33 F200"),
            (Lines{"rapid x55", "feed x55 z-30 f200", "feed x65 f200", "rapid z3"}));
}

// A X100, C X60: the travel on X is -20 as a true length.
TEST(G90, LimitsAnOppositeTaperToTheTravel) {
  EXPECT_EQ(ending("G00 X100 Z0\nG90 X60 Z-10 R20 F100"), "end x50 y0 z0 a0 c0");
  EXPECT_EQ(ending("G00 X100 Z0\nG90 X60 Z-10 R20.001 F100"), "alarm b2 taper-limit");
  EXPECT_EQ(ending("G00 X100 Z0\nG90 X60 Z-10 R-50 F100"), "end x50 y0 z0 a0 c0");
}

TEST(G90, RefusesAxesOutsideThePlane) {
  EXPECT_EQ(ending("G90 X60 Y5 F100"), "alarm b1 axis-not-in-plane");
  EXPECT_EQ(ending("G90 X60 H5 F100"), "alarm b1 axis-not-in-plane");
  EXPECT_EQ(ending("G17 G90 X60 Z5 F100"), "alarm b1 axis-not-in-plane");
}

TEST(G90, NeedsAFeed) {
  EXPECT_EQ(ending("G90 X60 Z-10"), "alarm b1 feed-missing");
}

TEST(G90, RunsWithRAloneAndNotWithoutWords) {
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 R-5 F100"),
            (Lines{"rapid x45", "feed x50 z0 f100", "feed x50 f100", "rapid z0"}));
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 F100"), Lines{});
}

// After G04 the words are there, after G50 they are not: X90 alone cuts without travel on Z.
TEST(G90, LosesItsWordsToGroup00ButNotToADwell) {
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 X94 Z-10 F100\nG04 P1\nX90").at(6),
            "feed x45 z-10 f100");
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 X94 Z-10 F100\nG50\nX90").at(6), "feed x45 z0 f100");
}

TEST(G90, LosesItsWordsToG94) {
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 X94 Z-10 R-5 F100\nG94 Z-3").at(4), "rapid z-3");
  EXPECT_EQ(lines_after("G00 X100 Z0", "G90 X94 Z-10 R-5 F100\nG94 Z-3").at(5),
            "feed x50 z-3 f100");
}

TEST(G90, ClearsRWhenWrittenAgainUnderItsReading) {
  const std::string blocks = "G90 X94 Z-10 R-5 F100\nG90 X90";
  EXPECT_EQ(lines_after("G00 X100 Z0", blocks).at(4), "rapid x40");
  EXPECT_EQ(lines_after("G00 X100 Z0", blocks, profile_with({{"gsk.g94.rewrite", "clear"}})).at(4),
            "rapid x45");
}

// G17: positioned on Y, cut along X. G19: positioned on Z, cut along Y.
TEST(G90, MirrorsG94InEachPlane) {
  EXPECT_EQ(lines_after("G00 X100 Y50", "G17 G90 X60 Y40 R-2 F100"),
            (Lines{"rapid y38", "feed x30 y40 f100", "feed y50 f100", "rapid x50"}));
  EXPECT_EQ(lines_after("G00 Y100 Z50", "G19 G90 Y60 Z40 R-2 F100"),
            (Lines{"rapid z38", "feed y60 z40 f100", "feed z50 f100", "rapid y100"}));
}

TEST(G90, ChecksTheRangeOfR) {
  EXPECT_EQ(ending("G90 R1000000 F100"), "alarm b1 value-out-of-range");
}

}  // namespace
}  // namespace gonogo::reference::testing
