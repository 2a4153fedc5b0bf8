// SPDX-License-Identifier: GPL-3.0-or-later
//
// RS274/NGC path commands derived by hand, against the vectors. r is the vector from the centre
// to the start of an arc, in the order of its plane: (X,Y), (Z,X), (Y,Z). A quarter turn
// counterclockwise takes (p, q) to (-q, p), one clockwise to (q, -p).
#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "derived.hpp"

namespace gonogo::testing {
namespace {

// But for the M2 that every program ends with.
Lines path_of(const std::string& id, std::size_t expectation = 0) {
  Lines all = records_of(id, expectation);
  std::erase_if(all, [](const std::string& line) { return line.ends_with(" m 2"); });
  return all;
}

TEST(DerivedNgcArc, AQuarterClockwise) {
  // Centre (0, 0); r (-3, 4) becomes (4, 3).
  const Lines want = {"1 rapid x-3 y4", "2 arc G17 -1 cx0 cy0 x4 y3 f100", "end x4 y3 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc.000001"), want);
}

TEST(DerivedNgcArc, ThreeQuartersClockwiseAboutAPointOffTheOrigin) {
  // From (0, -3) by I3 J-4: the centre is (3, -7), r (-3, 4). Three quarters clockwise are one
  // counterclockwise: (-4, -3), which is (-1, -10).
  const Lines want = {"1 rapid x0 y-3", "2 arc G17 -1 cx3 cy-7 x-1 y-10 f100",
                      "end x-1 y-10 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc.000005"), want);
}

TEST(DerivedNgcArc, HalfATurnCounterclockwise) {
  // r (5, -12) becomes (-5, 12).
  const Lines want = {"1 rapid x5 y-12", "2 arc G17 1 cx0 cy0 x-5 y12 f100",
                      "end x-5 y12 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc.000012"), want);
}

TEST(DerivedNgcArc, AFullCircleNamesItsStart) {
  // From (7, -4) by I-4 J-3: (3, -7).
  const Lines want = {"1 rapid x7 y-4", "2 arc G17 -1 cx3 cy-7 x7 y-4 f100", "end x7 y-4 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc.000007"), want);
}

TEST(DerivedNgcArc, ARotaryAxisGoesAlong) {
  // A45 and 45 more; the arc is half a turn about (15, 0).
  const Lines want = {"1 rapid x10 a45", "2 arc G17 -1 cx15 cy0 x20 y0 a90 f100",
                      "end x20 y0 z0 a90 c0"};
  EXPECT_EQ(path_of("ngc.arc.000055"), want);
}

TEST(DerivedNgcArc, NoAxisWordIsAFullCircleOrAnAlarm) {
  const Lines free = {"1 rapid x10", "2 arc G17 -1 cx13 cy4 x10 y0 f100", "end x10 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc.000078", 0), free);
  EXPECT_EQ(path_of("ngc.arc.000078", 1), Lines{"1 rapid x10"});
}

TEST(DerivedNgcRadius, TheCentreIsOnTheRightOfAShortClockwiseArc) {
  // From (0, 5) by (8, 6), R13: 12 from the middle (4, 8), to the right along (0.6, -0.8):
  // (4 + 7.2, 8 - 9.6).
  const Lines want = {"1 rapid x0 y5", "2 arc G17 -1 cx11.2 cy-1.6 x8 y11 f100",
                      "end x8 y11 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000001"), want);
}

TEST(DerivedNgcRadius, AndOnTheLeftOfALongOne) {
  // (4 - 7.2, 8 + 9.6).
  const Lines want = {"1 rapid x0 y5", "2 arc G17 -1 cx-3.2 cy17.6 x8 y11 f100",
                      "end x8 y11 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000005"), want);
}

TEST(DerivedNgcRadius, CounterclockwiseItIsTheOtherWayRound) {
  const Lines want = {"1 rapid x0 y5", "2 arc G17 1 cx-3.2 cy17.6 x8 y11 f100",
                      "end x8 y11 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000007"), want);
}

TEST(DerivedNgcRadius, HalfATurnHasItsCentreInTheMiddleWhateverTheSign) {
  const Lines want = {"1 rapid x10", "2 arc G17 -1 cx15 cy0 x20 y0 f100", "end x20 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000021"), want);
  EXPECT_EQ(path_of("ngc.arc-r.000022"), want);
}

TEST(DerivedNgcRadius, ThreeQuartersByANegativeR) {
  // From (10, 0) counterclockwise to (0, 10), the long way about (10, 10): r (0, -10) goes by
  // (10, 0) and (0, 10) to (-10, 0).
  const Lines want = {"1 rapid x10", "2 arc G17 1 cx10 cy10 x0 y10 f100", "end x0 y10 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000028"), want);
}

TEST(DerivedNgcRadius, ARadiusThatIsForgivenHasItsCentreInTheMiddle) {
  // 5 - 4.9988 = 0.0012 is below 0.00127.
  const Lines want = {"1 rapid x10", "2 arc G17 -1 cx15 cy0 x20 y0 f100", "end x20 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-r.000062", 0), Lines{"1 rapid x10"});
  EXPECT_EQ(path_of("ngc.arc-r.000062", 1), want);
}

TEST(DerivedNgcPlane, AQuarterClockwiseOfZAndX) {
  // From (Z14, X3) by K-4 I-3: the centre is (Z10, X0), r (Z4, X3) becomes (Z3, X-4).
  const Lines want = {"1 rapid x3 z14", "2 arc G18 -1 cx0 cz10 x-4 z13 f100",
                      "end x-4 y0 z13 a0 c0"};
  EXPECT_EQ(path_of("ngc.plane.000001"), want);
}

TEST(DerivedNgcPlane, ThreeQuartersCounterclockwiseOfZAndX) {
  // From (Z-9, X-12) by K12 I5: the centre is (Z3, X-7), r (Z-12, X-5). One quarter clockwise:
  // (Z-5, X12), which is (Z-2, X5).
  const Lines want = {"1 rapid x-12 z-9", "2 arc G18 1 cx-7 cz3 x5 z-2 f100",
                      "end x5 y0 z-2 a0 c0"};
  EXPECT_EQ(path_of("ngc.plane.000007"), want);
}

TEST(DerivedNgcPlane, AQuarterCounterclockwiseOfYAndZ) {
  // From (Y8, Z-19) by J-5 K12: the centre is (Y3, Z-7), r (Y5, Z-12) becomes (Y12, Z5).
  const Lines want = {"1 rapid y8 z-19", "2 arc G19 1 cy3 cz-7 y15 z-2 f100",
                      "end x0 y15 z-2 a0 c0"};
  EXPECT_EQ(path_of("ngc.plane.000041"), want);
}

TEST(DerivedNgcPlane, ByRadiusInTheOrderZX) {
  // From (Z30, X10) by Z6, R5 clockwise: the right of +Z is -X, so 4 from (Z33, X10) is X6.
  const Lines want = {"1 rapid x10 y20 z30", "2 arc G18 -1 cx6 cz33 x10 z36 f100",
                      "end x10 y20 z36 a0 c0"};
  EXPECT_EQ(path_of("ngc.plane.000017"), want);
}

TEST(DerivedNgcPlane, AnEdgeInEachPlane) {
  // r (0, 5) to (5, 0); then (Z-5, X0) to (Z0, X5); then (Y-5, Z0) to (Y0, Z5): quarters all.
  const Lines want = {"1 rapid x5 y5 z0",
                      "2 arc G17 -1 cx5 cy0 x10 y0 f100",
                      "3 arc G18 -1 cx10 cz5 x15 z5 f100",
                      "4 arc G19 -1 cy5 cz5 y5 z10 f100",
                      "5 m 2",
                      "end x15 y5 z10 a0 c0"};
  EXPECT_EQ(records_of("ngc.programs.000013"), want);
}

TEST(DerivedNgcHelix, TheThirdAxisOfZAndXIsY) {
  // r (Z-12, X-5) half a turn about (0, 0), Y from 0 to -5.
  const Lines want = {"1 rapid x-5 y0 z-12", "2 arc G18 -1 cx0 cz0 x5 y-5 z12 f100",
                      "end x5 y-5 z12 a0 c0"};
  EXPECT_EQ(path_of("ngc.helix.000018"), want);
}

TEST(DerivedNgcHelix, QuartersDownARamp) {
  const Lines want = {"1 rapid x10 y0 z0",
                      "2 arc G17 1 cx0 cy0 x0 y10 z-0.5 f200",
                      "3 arc G17 1 cx0 cy0 x-10 y0 z-1 f200",
                      "4 arc G17 1 cx0 cy0 x0 y-10 z-1.5 f200",
                      "5 arc G17 1 cx0 cy0 x10 y0 z-2 f200",
                      "6 m 2",
                      "end x10 y0 z-2 a0 c0"};
  EXPECT_EQ(records_of("ngc.programs.000010"), want);
}

TEST(DerivedNgcHelix, PCountsTheTurnsThatBegin) {
  // Five whole turns over 7.5 of Z; then a straight cut to the middle.
  const Lines want = {"1 rapid x8 y0 z-10", "2 arc G17 5 cx0 cy0 x8 y0 z-2.5 f300",
                      "3 feed x0 f300", "4 m 2", "end x0 y0 z-2.5 a0 c0"};
  EXPECT_EQ(records_of("ngc.programs.000011"), want);
}

TEST(DerivedNgcDistance, ACentreIsAPointOrAnOffset) {
  // Absolute I15 J0, then an offset of 5 from X20.
  const Lines want = {"1 rapid x10", "2 arc G17 -1 cx15 cy0 x20 y0 f100",
                      "3 arc G17 -1 cx25 cy0 x30 y0 f100", "end x30 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-distance.000030"), want);
}

TEST(DerivedNgcDistance, APointInInches) {
  // 25.4 * (2, 1); F10 is 254 mm a minute.
  const Lines want = {"1 rapid x25.4 y25.4", "3 arc G17 1 cx50.8 cy25.4 x76.2 y25.4 f254",
                      "end x76.2 y25.4 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.arc-distance.000041"), want);
}

TEST(DerivedNgcModes, FActsBeforeTheUnitsOfItsBlock) {
  const Lines want = {"1 rapid x10", "2 feed x25.4 f100", "end x25.4 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.mode.000086"), want);
}

TEST(DerivedNgcModes, ARingInInches) {
  // 25.4 * 1.5 = 38.1, * 0.1 = 2.54, * 0.125 = 3.175; F3 is 76.2, F12 is 304.8.
  const Lines want = {"2 rapid x38.1 y0 z2.54",
                      "3 feed z-3.175 f76.2",
                      "4 arc G17 -1 cx0 cy0 x38.1 y0 f304.8",
                      "5 rapid z2.54",
                      "6 m 2",
                      "end x38.1 y0 z2.54 a0 c0"};
  EXPECT_EQ(records_of("ngc.programs.000014"), want);
}

TEST(DerivedNgcModes, ADwellComesBeforeTheMotionOfItsBlock) {
  const Lines want = {"1 feed x10 f100", "2 dwell 1", "2 feed x20 f100", "3 feed y5 f100",
                      "end x20 y5 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.basic.000057"), want);
}

TEST(DerivedNgcModes, FunctionsBeforeAndAfterTheMotion) {
  const Lines want = {"1 m 3", "1 rapid x10", "1 m 0", "end x10 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.m.000019"), want);
}

TEST(DerivedNgcModes, FOfARotaryAxisIsAsWritten) {
  // Inches: 10 a minute is 254 mm; A alone turns at 10 degrees a minute.
  const Lines want = {"2 feed x25.4 f254", "3 feed a90 f10", "end x25.4 y0 z0 a90 c0"};
  EXPECT_EQ(path_of("ngc.rotary.000019"), want);
}

TEST(DerivedNgcTolerance, ASpiralKeepsItsCentreAndItsEnd) {
  // 0.001 outside; the next arc begins there and has its centre 10.001 below.
  const Lines want = {"1 rapid x10", "2 arc G17 1 cx0 cy0 x0 y10.001 f100",
                      "3 arc G17 1 cx0 cy0 x-10.001 y0 f100", "end x-10.001 y0 z0 a0 c0"};
  EXPECT_EQ(path_of("ngc.tolerance.000023"), want);
}

}  // namespace
}  // namespace gonogo::testing
