// SPDX-License-Identifier: GPL-3.0-or-later
// G02 and G03 with X as a radius.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// The second record, after positioning.
std::string gsk_arc(const std::string& words, const char* profile = kRadiusProfile) {
  const Outcome outcome = run("G00 X0 Z0\n" + words + " F100\n", profile);
  return outcome.alarms != 0 ? outcome.alarm : outcome.records[0];
}

TEST(GskArc, CentreWordsCountFromTheStart) {
  // From (Z0, X0) about (Z5, X0) clockwise to (Z5, X5).
  EXPECT_EQ(gsk_arc("G02 X5 Z5 I0 K5"), "arc18 c=5,0 rot=-1 x=5 z=5 f=100");
}

TEST(GskArc, RadiusOfAQuarterCircle) {
  // From (Z0, X0) to (Z10, X10), R10: clockwise with Z right and X up the centre is (Z10, X0),
  // counterclockwise it is (Z0, X10).
  EXPECT_EQ(gsk_arc("G02 X10 Z10 R10"), "arc18 c=10,0 rot=-1 x=10 z=10 f=100");
  EXPECT_EQ(gsk_arc("G03 X10 Z10 R10"), "arc18 c=0,10 rot=1 x=10 z=10 f=100");
}

TEST(GskArc, NegativeRadiusTakesTheLongWay) {
  EXPECT_EQ(gsk_arc("G02 X10 Z10 R-10"), "arc18 c=0,10 rot=-1 x=10 z=10 f=100");
  EXPECT_EQ(gsk_arc("G03 X10 Z10 R-10"), "arc18 c=10,0 rot=1 x=10 z=10 f=100");
}

TEST(GskArc, ManualsExampleHasItsCentreAtMinus15) {
  // G03 U24 W-24 R15 from the origin, U a diameter: (Z-24, X12) about (Z-15, X0): 81 + 144 = 225.
  EXPECT_EQ(gsk_arc("G03 U24 W-24 R15", "{}"), "arc18 c=-15,0 rot=1 x=12 z=-24 f=100");
}

TEST(GskArc, SemicircleByRadius) {
  EXPECT_EQ(gsk_arc("G02 Z10 R5"), "arc18 c=5,0 rot=-1 x=0 z=10 f=100");
}

TEST(GskArc, RadiusBeatsCentreWords) {
  EXPECT_EQ(gsk_arc("G02 Z10 R5 I77 K77"), "arc18 c=5,0 rot=-1 x=0 z=10 f=100");
}

TEST(GskArc, FullCircleNeedsNoEndPoint) {
  EXPECT_EQ(gsk_arc("G03 K5"), "arc18 c=5,0 rot=1 x=0 z=0 f=100");
}

TEST(GskArc, ThirdAxisMakesAHelix) {
  EXPECT_EQ(gsk_arc("G03 K5 Y-3"), "arc18 c=5,0 rot=1 x=0 y=-3 z=0 f=100");
  EXPECT_EQ(gsk_arc("G17 G02 X10 R5 Z4"), "arc17 c=5,0 rot=-1 x=10 y=0 z=4 f=100");
}

TEST(GskArc, G19TakesJAndK) {
  EXPECT_EQ(gsk_arc("G19 G03 Y5 Z5 J0 K5"), "arc19 c=0,5 rot=1 y=5 z=5 f=100");
}

TEST(GskArc, RadiiMayDifferByTheParameter) {
  // Radius 5 at the start, 5.01 or 5.011 at the end; the centre is kept.
  EXPECT_EQ(gsk_arc("G02 Z10.01 K5"), "arc18 c=5,0 rot=-1 x=0 z=10.01 f=100");
  EXPECT_EQ(gsk_arc("G02 Z10.011 K5"), "arc-end-point");
  EXPECT_EQ(gsk_arc("G02 Z9.989 K5"), "arc-end-point");
  const char* loose = R"({"x_diameter":false,"parameters":{"3410":"0.5"}})";
  EXPECT_EQ(gsk_arc("G02 Z10.5 K5", loose), "arc18 c=5,0 rot=-1 x=0 z=10.5 f=100");
  EXPECT_EQ(gsk_arc("G02 Z10.501 K5", loose), "arc-end-point");
}

TEST(GskArc, RadiusShorterThanHalfTheChord) {
  EXPECT_EQ(gsk_arc("G02 Z10 R5"), "arc18 c=5,0 rot=-1 x=0 z=10 f=100");
  EXPECT_EQ(gsk_arc("G02 Z10.001 R5"), "arc-radius");
  EXPECT_EQ(gsk_arc("G02 Z10.001 R-5"), "arc-radius");
}

TEST(GskArc, RadiusWithoutTravel) {
  EXPECT_EQ(gsk_arc("G02 R5"), "arc-end-point");
}

TEST(GskArc, NeitherRadiusNorCentre) {
  EXPECT_EQ(gsk_arc("G02 Z10"), "missing-word");
  EXPECT_EQ(gsk_arc("G02 Z10 X3"), "missing-word");
}

TEST(GskArc, CodeAloneMovesNothing) {
  EXPECT_EQ(run("G02\nM8\n").motions(), "m 8\n");
}

TEST(GskArc, LargestCoordinatesStayExact) {
  // Radius 3e9 mm at both ends: the squares need 128 bits.
  const Outcome outcome = run("G02 X3000000000 Z3000000000 K3000000000 F1\n", kRadiusProfile);
  EXPECT_EQ(outcome.records[0], "arc18 c=3000000000,0 rot=-1 x=3000000000 z=3000000000 f=1");
}

}  // namespace
}  // namespace gonogo::expanders::testing
