// SPDX-License-Identifier: GPL-3.0-or-later
// CIP and CT of the expander of sinumerik840d.
#include <gtest/gtest.h>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(SinumerikThroughPoint, IsAnArcInSpace) {
  EXPECT_EQ(last_motion_or_alarm("G0 X30 Y40\nCIP X50 Y40 I1=40 J1=45 F9\n"),
            "arc3 via=40,45,0 x=50 y=40 z=0 f=9");
  EXPECT_EQ(last_motion_or_alarm("G18\nCIP X3 Y4 Z5 A6 I1=1 J1=1 K1=2 F9\n"),
            "arc3 via=1,1,2 x=3 y=4 z=5 a=6 f=9");
}

TEST(SinumerikThroughPoint, IncrementsCountFromTheStart) {
  const char* want = "arc3 via=12,3,0 x=14 y=0 z=0 f=9";
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nG91 CIP X4 I1=2 J1=3 F9\n"), want);
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nCIP X=IC(4) I1=IC(2) J1=3 F9\n"), want);
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nG91 CIP X=AC(14) I1=AC(12) J1=3 F9\n"), want);
}

TEST(SinumerikThroughPoint, OnTheStraightWay) {
  EXPECT_EQ(last_motion_or_alarm("CIP X3 Y6 Z9 I1=1 J1=2 K1=3 F9\n"), "feed x=3 y=6 z=9 f=9");
  EXPECT_EQ(last_motion_or_alarm("CIP X3 Y6 Z9 I1=4 J1=8 K1=12 F9\n"), "arc-intermediate-point");
  EXPECT_EQ(last_motion_or_alarm("CIP X3 Y6 Z9 I1=-1 J1=-2 K1=-3 F9\n"), "arc-intermediate-point");
  EXPECT_EQ(last_motion_or_alarm("CIP X3 Y6 Z9 I1=1 J1=2 K1=3.001 F9\n"),
            "arc3 via=1,2,3.001 x=3 y=6 z=9 f=9");
}

TEST(SinumerikThroughPoint, NoTurnsAreNoTurns) {
  EXPECT_EQ(last_motion_or_alarm("CIP X3 I1=1 TURN=0 F9\n"), "feed x=3 y=0 z=0 f=9");
  EXPECT_EQ(last_motion_or_alarm("G1 X10 F9\nCT X15 TURN=0\n"), "feed x=15 f=9");
}

TEST(SinumerikThroughPoint, NeedsThreePoints) {
  EXPECT_EQ(last_motion_or_alarm("CIP X3 F9\n"), "missing-word");
  EXPECT_EQ(last_motion_or_alarm("CIP X3 I1=0 F9\n"), "arc-intermediate-point");
  EXPECT_EQ(last_motion_or_alarm("CIP X3 I1=3 F9\n"), "arc-intermediate-point");
  EXPECT_EQ(last_motion_or_alarm("CIP I1=3 J1=1 F9\n"), "arc-intermediate-point");
}

TEST(SinumerikThroughPoint, TakesNoOtherWords) {
  for (const char* word : {"I1", "CR=5", "AR=5", "AP=5", "RP=5", "TURN=1"}) {
    EXPECT_EQ(last_motion_or_alarm("CIP X3 I1=1 J1=1 F9 " + std::string(word) + "\n"),
              "conflicting-words")
        << word;
  }
}

// From (10, 0) in the direction of X: radius 10 about (10, 10), and on round the same circle.
TEST(SinumerikTangent, FollowsALine) {
  EXPECT_EQ(last_motion_or_alarm("G1 X10 F9\nCT X20 Y10\n"), "arc17 c=10,10 rot=1 x=20 y=10 f=9");
  EXPECT_EQ(last_motion_or_alarm("G1 X10 F9\nCT X20 Y10\nX10 Y20\n"),
            "arc17 c=10,10 rot=1 x=10 y=20 f=9");
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nCT X20 Y-10 F9\n"),
            "arc17 c=10,-10 rot=-1 x=20 y=-10 f=9");
}

TEST(SinumerikTangent, InTheActivePlane) {
  EXPECT_EQ(last_motion_or_alarm("G18\nG1 Z10 F9\nCT Z20 X10\n"),
            "arc18 c=10,10 rot=1 x=10 z=20 f=9");
  EXPECT_EQ(last_motion_or_alarm("G19\nG1 Y10 X7 F9\nCT Y20 Z10\n"),
            "arc19 c=10,10 rot=1 y=20 z=10 f=9");
}

TEST(SinumerikTangent, ThirdAxisMakesAHelix) {
  EXPECT_EQ(last_motion_or_alarm("G1 X10 F9\nCT X20 Y10 Z5 A6\n"),
            "arc17 c=10,10 rot=1 x=20 y=10 z=5 a=6 f=9");
}

// Half a circle that ends upward at (2, 0); then clockwise about (3, 0).
TEST(SinumerikTangent, FollowsAnArc) {
  EXPECT_EQ(last_motion_or_alarm("G3 X2 I1 F9\nCT X4\n"), "arc17 c=3,0 rot=-1 x=4 y=0 f=9");
  EXPECT_EQ(last_motion_or_alarm("G3 X2 CR=1 F9\nCT X4\n"), "arc17 c=3,0 rot=-1 x=4 y=0 f=9");
  EXPECT_EQ(last_motion_or_alarm("G111 X1\nG3 RP=1 AP=0 F9\nCT X4\n"),
            "arc17 c=3,0 rot=-1 x=4 y=0 f=9");
}

// Clockwise over (5, 5), it ends downward at (10, 0).
TEST(SinumerikTangent, FollowsAThroughPointArc) {
  EXPECT_EQ(last_motion_or_alarm("CIP X10 I1=5 J1=5 F9\nCT X20\n"),
            "arc17 c=15,0 rot=1 x=20 y=0 f=9");
}

TEST(SinumerikTangent, PolarTarget) {
  EXPECT_EQ(last_motion_or_alarm("G1 X10 F9\nG111 X20\nCT RP=10 AP=90\n"),
            "arc17 c=10,10 rot=1 x=20 y=10 f=9");
}

TEST(SinumerikTangent, StraightOn) {
  EXPECT_EQ(last_motion_or_alarm("G1 X10 Y5 F9\nCT X20 Y10 Z3\n"), "feed x=20 y=10 z=3 f=9");
  EXPECT_EQ(last_motion_or_alarm("G1 X10 Y5 F9\nCT X20 Y10.001\n").substr(0, 6), "arc17 ");
  EXPECT_EQ(last_motion_or_alarm("G0 RP=10 AP=33\nCT RP=20 F9\n").substr(0, 5), "feed ");
}

TEST(SinumerikTangent, NoDirection) {
  EXPECT_EQ(last_motion_or_alarm("CT X20 F9\n"), "arc-tangent");
  EXPECT_EQ(last_motion_or_alarm("G0 Z5\nCT X20 F9\n"), "arc-tangent");
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nCT X5 F9\n"), "arc-tangent");
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nCT X10 Z5 F9\n"), "arc-tangent");
  EXPECT_EQ(last_motion_or_alarm("CIP Z10 X0 I1=5 K1=5 F9\nG19\nCT Y1\n"), "arc-tangent");
}

TEST(SinumerikTangent, MotionsWithoutLengthAreNone) {
  EXPECT_EQ(last_motion_or_alarm("G0 X10\nX10\nG4 F1\nG110\nCT X20 Y10 F9\n"),
            "arc17 c=10,10 rot=1 x=20 y=10 f=9");
}

TEST(SinumerikTangent, TakesNoOtherWords) {
  for (const char* word : {"I1", "CR=5", "AR=5", "I1=5", "TURN=1"}) {
    EXPECT_EQ(last_motion_or_alarm("G0 X10\nCT X20 Y10 F9 " + std::string(word) + "\n"),
              "conflicting-words")
        << word;
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
