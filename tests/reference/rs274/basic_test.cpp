// SPDX-License-Identifier: GPL-3.0-or-later
//
// G0, G1, G4 and the feed.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcBasic, G0TraversesAndG1Feeds) {
  EXPECT_EQ(path("G0 X1 Y2 Z3\nG1 X4 F100"), (Lines{"rapid x1 y2 z3", "feed x4 f100"}));
}

TEST(NgcBasic, MotionsNameTheirClauses) {
  EXPECT_EQ(clauses("G0 X1\nG1 X4 F100\nG4 P1"), (Lines{"NGC-G0-01", "NGC-G0-01", "NGC-G4-01"}));
}

TEST(NgcBasic, LettersStandInEitherCase) {
  EXPECT_EQ(path("g1x-1.5y2f100"), path("G1 X-1.5 Y2 F100"));
}

TEST(NgcBasic, G0AndG1WithoutAnAxisWordDoNothing) {
  EXPECT_EQ(path("F9\nG0\nG1\nG1 M3\nG0 S9"), Lines{});
}

TEST(NgcBasic, CuttingNeedsAFeedAboveZero) {
  EXPECT_EQ(ending_of("G1 X1"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G1 X1 F0"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("F100\nG1 X1 F0"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G1 X1 F0.0001"), "end x1 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G2 X1 I0.5"), "alarm b1 feed-missing");
}

TEST(NgcBasic, ANegativeFeedIsAnAlarmEvenWithoutAMotion) {
  EXPECT_EQ(ending_of("F-1"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G0 X1 F-0.001"), "alarm b1 value-sign");
}

TEST(NgcBasic, TheFeedOfTheProfileIsInForceAtTheStart) {
  Profile profile = ngc();
  profile.initial.feed = 250;
  EXPECT_EQ(path("G1 X1", profile), Lines{"feed x1 f250"});
}

TEST(NgcBasic, RotaryAxesMoveAlong) {
  EXPECT_EQ(path("G1 X1 A90 C-45.5 F100\nG0 A0"), (Lines{"feed x1 a90 c-45.5 f100", "rapid a0"}));
}

// 10 inches a minute are 254 mm a minute; degrees have no units.
TEST(NgcBasic, FOfARotaryAxisThatMovesAloneIsInDegrees) {
  const Lines want = {"feed a90 f10", "feed x25.4 a0 f254", "feed x25.4 a5 f10"};
  EXPECT_EQ(path("G20\nF10\nG1 A90\nX1 A0\nX1 A5"), want);
}

TEST(NgcBasic, TheAxesBUVWAreNotCovered) {
  for (const char* word : {"B", "U", "V", "W"}) {
    EXPECT_EQ(ending_of(std::string("G0 X1\nX2 X3 ") + word + "1"),
              std::string("not-covered b2 ") + word);
  }
}

TEST(NgcBasic, G4DwellsForPSeconds) {
  EXPECT_EQ(path("G4 P1.5\nG20 G4 P2\nG4 P0"), (Lines{"dwell 1.5", "dwell 2", "dwell 0"}));
  EXPECT_EQ(ending_of("G4"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G4 X1"), "alarm b1 missing-word missing-word");
  EXPECT_EQ(ending_of("G4 P-0.1"), "alarm b1 value-sign");
}

TEST(NgcBasic, G4ComesBeforeTheMotionOfItsBlock) {
  EXPECT_EQ(path("G1 X1 F100 G4 P2\nX2 G4 P1"),
            (Lines{"dwell 2", "feed x1 f100", "dwell 1", "feed x2 f100"}));
}

TEST(NgcBasic, POfTheDwellIsNoWordOfTheMotion) {
  EXPECT_EQ(path("G2 I1 F100 G4 P2.5").at(1), "arc x0 y0 c1,0 rot-1 f100");
  EXPECT_EQ(path("G4 P2.5"), Lines{"dwell 2.5"});
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
