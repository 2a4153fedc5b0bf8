// SPDX-License-Identifier: GPL-3.0-or-later
//
// CIP: SIE-CIP-01, SIE-CIP-02.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

TEST(SieCip, TheSampleOfTheManualRuns) {
  EXPECT_EQ(line("G0 X30 Y40 F9\nCIP X50 Y40 I1=40 J1=45", 1), "arc3 x50 y40 z0 via x40 y45 z0 f9");
  EXPECT_EQ(clauses("G0 X30 Y40 F9\nCIP X50 Y40 I1=40 J1=45").back(), "SIE-CIP-01");
}

TEST(SieCip, BothPointsFollowTheModeFromTheStart) {
  const std::string in_space = "arc3 x11 y1 z1 via x6 y4 z5 f9";
  const std::string before = "G0 X1 Y1 Z1 F9\n";
  EXPECT_EQ(line(before + "CIP X11 I1=6 J1=4 K1=5", 1), in_space);
  EXPECT_EQ(line(before + "G91 CIP X10 I1=5 J1=3 K1=4", 1), in_space);
  EXPECT_EQ(line(before + "CIP X=IC(10) I1=IC(5) J1=4 K1=IC(4)", 1), in_space);
  EXPECT_EQ(line(before + "G91 CIP X=AC(11) I1=AC(6) J1=3 K1=AC(5)", 1), in_space);
}

TEST(SieCip, WhatIsLeftOutIsTheStarts) {
  EXPECT_EQ(line("G0 X1 Y1 Z1 F9\nCIP Y5 K1=4", 1), "arc3 x1 y5 z1 via x1 y1 z4 f9");
  EXPECT_EQ(line("F9\nCIP X5 J1=4 A3\nX9 J1=1", 1), "arc3 x9 y0 z0 via x5 y1 z0 f9");
}

TEST(SieCip, APointBetweenOnTheLineMakesItStraight) {
  EXPECT_EQ(line("CIP X10 Z10 I1=5 K1=5 F9", 0), "feed x10 y0 z10 f9");
  EXPECT_EQ(line("CIP X3 I1=0.001 F9", 0), "feed x3 y0 z0 f9");
}

TEST(SieCip, AStraightOneIsAnAlarmUnderItsReading) {
  const Profile refuses = sie({{"sie.cip.collinear", "alarm"}});
  EXPECT_EQ(outcome("CIP X10 Z10 I1=5 K1=5", refuses), "arc-intermediate-point I1");
  EXPECT_EQ(clauses("F9\nCIP X10 I1=5", refuses), Lines{"SIE-CIP-01"});
  EXPECT_EQ(outcome("CIP X10 Z10 I1=5 K1=5 J1=0.001", refuses), "end");
}

// No turns leave CIP as it is.
TEST(SieCip, NoTurnsMayBeAdded) {
  EXPECT_EQ(line("CIP X10 Z10 I1=5 K1=5 TURN=0 F9", 0), "feed x10 y0 z10 f9");
  EXPECT_EQ(line("G0 X1 F9\nCIP X-1 I1=0 J1=1 TURN=R1-0", 1), "arc3 x-1 y0 z0 via x0 y1 z0 f9");
  EXPECT_EQ(outcome("CIP X10 I1=5 TURN=1"), "conflicting-words TURN");
}

TEST(SieCip, AnyOtherPointOnTheLineIsAnAlarm) {
  for (const char* points :
       {"X10 I1=10", "X10 I1=0", "X10 I1=10.001", "X10 I1=-5", "X0 I1=5", "X0 I1=0", "A5 I1=7"}) {
    EXPECT_EQ(outcome(std::string("CIP ") + points), "arc-intermediate-point I1") << points;
  }
  EXPECT_EQ(outcome("CIP Y0 J1=5"), "arc-intermediate-point J1");
  EXPECT_EQ(clauses("F9\nCIP X10 I1=10"), Lines{"SIE-CIP-02"});
}

TEST(SieCip, ItNeedsAnIntermediatePointAndNothingElse) {
  EXPECT_EQ(outcome("CIP X10"), "missing-word I1");
  EXPECT_EQ(outcome("CIP X10 I1=5 J1=5 CR=5"), "conflicting-words CR");
  EXPECT_EQ(outcome("CIP X10 I5 J1=5"), "conflicting-words I");
  EXPECT_EQ(outcome("CIP X10 I1=5 J1=5 TURN=1"), "conflicting-words TURN");
  EXPECT_EQ(outcome("CIP RP=10 AP=5 I1=5"), "conflicting-words RP, conflicting-words AP");
}

TEST(SieCip, PointsAtEnclosedPlacesAreDecidedFromTheStart) {
  const std::string before = "F9\nG1 RP=50 AP=20\nG91 CIP ";
  EXPECT_EQ(outcome(before + "X10 I1=5 J1=3 K1=4"), "end");
  EXPECT_EQ(outcome(before + "X10 I1=5"), "end");
  EXPECT_EQ(outcome(before + "X10 I1=11"), "arc-intermediate-point I1");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
