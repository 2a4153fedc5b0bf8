// SPDX-License-Identifier: GPL-3.0-or-later
// G2 and G3 of the expander of rs274: sense, centre, planes, helix and turns.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string ngc_arc(const char* block, const char* before = "G0 X0") {
  const Outcome outcome = run_ngc("F9\n" + std::string(before) + "\n" + block + "\n");
  return outcome.alarm.empty() && outcome.records.size() > 1
             ? outcome.records[outcome.records.size() - 2]
             : outcome.alarm + outcome.note;
}

TEST(NgcArc, CentreCountsFromTheStart) {
  EXPECT_EQ(ngc_arc("G2 X4 Y2 I2", "G0 Y2"), "arc17 c=2,2 rot=-1 x=4 y=2 f=9");
  EXPECT_EQ(ngc_arc("G3 X4 Y2 I2", "G0 Y2"), "arc17 c=2,2 rot=1 x=4 y=2 f=9");
}

// From (3, 0, 1), centre (1, 0, 1): the end (1, 0, 3) is a quarter turn on.
TEST(NgcArc, G18TakesZThenX) {
  EXPECT_EQ(ngc_arc("G18 G3 X1 Z3 I-2", "G0 X3 Z1"), "arc18 c=1,1 rot=1 x=1 z=3 f=9");
  EXPECT_EQ(ngc_arc("G18 G3 X4 Z2 K1", "G0 X3 Z1"), "arc18 c=2,3 rot=1 x=4 z=2 f=9");
}

TEST(NgcArc, G19TakesYThenZ) {
  EXPECT_EQ(ngc_arc("G19 G2 Y4 Z5 J3", "G0 Z5"), "arc-end-point");
  EXPECT_EQ(ngc_arc("G19 G2 Y6 Z5 J3", "G0 Z5"), "arc19 c=3,5 rot=-1 y=6 z=5 f=9");
}

TEST(NgcArc, AbsoluteCentre) {
  EXPECT_EQ(ngc_arc("G90.1 G2 X4 I2 J5", "G0 Y5"), "arc17 c=2,5 rot=-1 x=4 y=5 f=9");
  EXPECT_EQ(ngc_arc("G91.1 G2 X4 I2 J0", "G90.1 G0 Y5"), "arc17 c=2,5 rot=-1 x=4 y=5 f=9");
}

TEST(NgcArc, G91LeavesTheCentreAlone) {
  EXPECT_EQ(ngc_arc("G91 G90.1 G2 X4 I2 J5", "G0 Y5"), "arc17 c=2,5 rot=-1 x=4 y=5 f=9");
}

TEST(NgcArc, CentreInInches) {
  EXPECT_EQ(ngc_arc("G2 X2 I1", "G20"), "arc17 c=25.4,0 rot=-1 x=50.8 y=0 f=9");
}

TEST(NgcArc, FullCircle) {
  EXPECT_EQ(ngc_arc("G2 I3"), "arc17 c=3,0 rot=-1 x=0 y=0 f=9");
  EXPECT_EQ(ngc_arc("G3 X0 J-3"), "arc17 c=0,-3 rot=1 x=0 y=0 f=9");
}

TEST(NgcArc, OffsetsRepeatTheMode) {
  EXPECT_EQ(ngc_arc("I3", "G2 X4 I2"), "arc17 c=7,0 rot=-1 x=4 y=0 f=9");
}

// Chord 6 with R5: the centre is 4 off its middle (3, 0). G2, the short way, has it on the right.
TEST(NgcArc, RadiusSidesOfTheChord) {
  EXPECT_EQ(ngc_arc("G2 X6 R5"), "arc17 c=3,-4 rot=-1 x=6 y=0 f=9");
  EXPECT_EQ(ngc_arc("G3 X6 R5"), "arc17 c=3,4 rot=1 x=6 y=0 f=9");
  EXPECT_EQ(ngc_arc("G2 X6 R-5"), "arc17 c=3,4 rot=-1 x=6 y=0 f=9");
  EXPECT_EQ(ngc_arc("G3 X6 R-5"), "arc17 c=3,-4 rot=1 x=6 y=0 f=9");
}

// In G18 the left of +Z is +X, in G19 the left of +Y is +Z.
TEST(NgcArc, RadiusInOtherPlanes) {
  EXPECT_EQ(ngc_arc("G18 G3 Z6 R5"), "arc18 c=3,4 rot=1 x=0 z=6 f=9");
  EXPECT_EQ(ngc_arc("G19 G3 Y6 R5"), "arc19 c=3,4 rot=1 y=6 z=0 f=9");
}

TEST(NgcArc, RadiusOfHalfAChord) {
  EXPECT_EQ(ngc_arc("G2 X6 R3"), "arc17 c=3,0 rot=-1 x=6 y=0 f=9");
}

// Chord 2 with R2: sqrt(3) off its middle.
TEST(NgcArc, RadiusWithARoot) {
  EXPECT_EQ(ngc_arc("G3 X2 R2"), "arc17 c=1,1.732050808 rot=1 x=2 y=0 f=9");
}

TEST(NgcArc, ThirdAxisMakesAHelix) {
  EXPECT_EQ(ngc_arc("G2 X4 Z-1 I2"), "arc17 c=2,0 rot=-1 x=4 y=0 z=-1 f=9");
  EXPECT_EQ(ngc_arc("G18 G2 Z4 Y-1 K2"), "arc18 c=2,0 rot=-1 x=0 y=-1 z=4 f=9");
  EXPECT_EQ(ngc_arc("G3 Z-1 I2"), "arc17 c=2,0 rot=1 x=0 y=0 z=-1 f=9");
}

TEST(NgcArc, RotaryAxesGoAlong) {
  EXPECT_EQ(ngc_arc("G2 X4 A90 C-5 I2"), "arc17 c=2,0 rot=-1 x=4 y=0 a=90 c=-5 f=9");
}

TEST(NgcArc, PCountsTurns) {
  EXPECT_EQ(ngc_arc("G2 X4 I2 P1"), "arc17 c=2,0 rot=-1 x=4 y=0 f=9");
  EXPECT_EQ(ngc_arc("G3 X4 Z5 I2 P3"), "arc17 c=2,0 rot=3 x=4 y=0 z=5 f=9");
  EXPECT_EQ(ngc_arc("G2 X6 R5 P2"), "arc17 c=3,-4 rot=-2 x=6 y=0 f=9");
}

TEST(NgcArc, PIsForItsBlock) {
  EXPECT_EQ(ngc_arc("X8 I2", "G2 X4 I2 P5"), "arc17 c=6,0 rot=-1 x=8 y=0 f=9");
}

TEST(NgcArc, PlaneStays) {
  EXPECT_EQ(ngc_arc("G2 Z4 K2", "G18"), "arc18 c=2,0 rot=-1 x=0 z=4 f=9");
}

}  // namespace
}  // namespace gonogo::expanders::testing
