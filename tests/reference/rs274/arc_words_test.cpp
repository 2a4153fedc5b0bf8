// SPDX-License-Identifier: GPL-3.0-or-later
//
// G2 and G3: senses, planes, which words an arc has, helices, turns.
#include <gtest/gtest.h>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

Lines arc_path(const std::string& block, const Profile& profile = ngc()) {
  return path("F100\n" + block, profile);
}
std::string fault(const std::string& block, const Profile& profile = ngc()) {
  return ending_of("F100\n" + block, profile);
}

TEST(NgcArc, G2IsClockwiseAndG3Counterclockwise) {
  EXPECT_EQ(arc_path("G2 X2 I1"), Lines{"arc x2 y0 c1,0 rot-1 f100"});
  EXPECT_EQ(arc_path("G3 X2 I1"), Lines{"arc x2 y0 c1,0 rot1 f100"});
}

// The planes' pairs are (X,Y), (Z,X) and (Y,Z), with the offsets of their own axes.
TEST(NgcArc, TurnsInThePlaneInForce) {
  EXPECT_EQ(arc_path("G17 G2 X1 Y1 I1"), Lines{"arc x1 y1 c1,0 rot-1 f100"});
  EXPECT_EQ(arc_path("G18 G2 X1 Z1 I1"), Lines{"arc x1 z1 c0,1 rot-1 f100"});
  EXPECT_EQ(arc_path("G18 G3 X1 Z1 K1"), Lines{"arc x1 z1 c1,0 rot1 f100"});
  EXPECT_EQ(arc_path("G19 G2 Y1 Z1 J1"), Lines{"arc y1 z1 c1,0 rot-1 f100"});
  EXPECT_EQ(arc_path("G19\nG3 Y1 Z1 K1"), Lines{"arc y1 z1 c0,1 rot1 f100"});
}

TEST(NgcArc, NeedsARadiusOrACentre) {
  EXPECT_EQ(fault("G2 X1"), "alarm b2 missing-word");
  EXPECT_EQ(fault("G2"), "alarm b2 missing-word");
  EXPECT_EQ(fault("G2 X2 I1\nX3"), "alarm b3 missing-word");
  EXPECT_EQ(fault("G2 X2 I1\nZ3"), "alarm b3 missing-word");
}

TEST(NgcArc, RAndOffsetsExcludeEachOther) {
  EXPECT_EQ(fault("G2 X2 R1 I1"), "alarm b2 conflicting-words");
  EXPECT_EQ(fault("G2 X2 J0 R1"), "alarm b2 conflicting-words");
  EXPECT_EQ(fault("G2 X2 R1 K0"), "alarm b2 conflicting-words axis-not-in-plane");
}

TEST(NgcArc, AnOffsetOfTheThirdAxisIsAnAlarm) {
  EXPECT_EQ(fault("G2 X2 I1 K0"), "alarm b2 axis-not-in-plane");
  EXPECT_EQ(fault("G18 G2 X2 I1 J1"), "alarm b2 axis-not-in-plane");
  EXPECT_EQ(fault("G19 G2 Y2 J1 I1"), "alarm b2 axis-not-in-plane");
  EXPECT_EQ(fault("G2 X2 K1"), "alarm b2 axis-not-in-plane missing-word");
}

TEST(NgcArc, WithTheThirdAxisIsAHelix) {
  EXPECT_EQ(arc_path("G2 X2 Z-3 I1"), Lines{"arc x2 y0 z-3 c1,0 rot-1 f100"});
  EXPECT_EQ(arc_path("G18 G3 X2 Y5 R1"), Lines{"arc x2 y5 z0 c0,1 rot1 f100"});
  EXPECT_EQ(clauses("F1\nG2 X2 Z-3 I1\nX4 Z-3 R1\nX6 I1\nX8 R1\nX10 I1 P2"),
            (Lines{"NGC-ARC-05", "NGC-ARC-05", "NGC-ARC-02", "NGC-ARC-04", "NGC-ARC-05"}));
}

TEST(NgcArc, RotaryAxesMoveAlong) {
  EXPECT_EQ(arc_path("G2 X2 I1 A90 C5"), Lines{"arc x2 y0 a90 c5 c1,0 rot-1 f100"});
}

TEST(NgcArc, PIsTheNumberOfTurnsBegun) {
  EXPECT_EQ(arc_path("G2 X2 I1 P3"), Lines{"arc x2 y0 c1,0 rot-3 f100"});
  EXPECT_EQ(arc_path("G3 X2 R1 P2"), Lines{"arc x2 y0 c1,0 rot2 f100"});
  EXPECT_EQ(arc_path("G3 Z5 I1 P4"), Lines{"arc x0 y0 z5 c1,0 rot4 f100"});
  EXPECT_EQ(arc_path("G3 X2 I1 P1.0"), Lines{"arc x2 y0 c1,0 rot1 f100"});
}

TEST(NgcArc, PIsAPositiveWholeNumber) {
  EXPECT_EQ(fault("G2 X2 I1 P1.5"), "alarm b2 not-an-integer");
  EXPECT_EQ(fault("G2 X2 I1 P0"), "alarm b2 value-sign");
  EXPECT_EQ(fault("G2 X2 I1 P-1"), "alarm b2 value-sign");
  EXPECT_EQ(fault("G2 X2 I1 P-1.5"), "alarm b2 value-sign not-an-integer");
  EXPECT_EQ(arc_path("G2 X2 I1 P2147483647"), Lines{"arc x2 y0 c1,0 rot-2147483647 f100"});
  EXPECT_EQ(fault("G2 X2 I1 P2147483648"), "alarm b2 value-out-of-range");
}

TEST(NgcArc, EveryBrokenRuleIsReported) {
  EXPECT_EQ(ending_of("G2 X2 X3 R1 I1 P0.5"),
            "alarm b1 duplicate-word conflicting-words not-an-integer feed-missing");
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
