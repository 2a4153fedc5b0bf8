// SPDX-License-Identifier: GPL-3.0-or-later
//
// Basic codes and arcs derived by hand, against the vectors.
#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "derived.hpp"

namespace gonogo::testing {
namespace {

TEST(DerivedBasic, SecondsByXAreNoDiameterAndNoPosition) {
  const Lines want = {"1 rapid x25", "2 dwell 2", "3 rapid x30", "end x30 y0 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.basic.000030"), want);
}

TEST(DerivedBasic, PIsMilliseconds) {
  const Lines want = {"1 dwell 1.5", "end x0 y0 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.basic.000025"), want);
}

TEST(DerivedBasic, AnInchIs254) {
  // X1 is a radius of 12.7; X0.0001 of 0.00127.
  const Lines want = {"1 rapid x12.7 z25.4", "2 rapid x0.00127 z-0.00254",
                      "end x0.00127 y0 z-0.00254 a0 c0"};
  EXPECT_EQ(records_of("gsk.basic.000034"), want);
}

TEST(DerivedBasic, TheReferencePointOfTheProfile) {
  // By radius 30, Z30 to X200, Z300 (true lengths); U-20 is 10.
  const Lines want = {"1 rapid x25 z20", "2 rapid x30 z30", "2 rapid x200 z300",
                      "3 rapid x190 z290", "end x190 y0 z290 a0 c0"};
  EXPECT_EQ(records_of("gsk.basic.000050"), want);
}

TEST(DerivedBasic, RenamingMovesNothing) {
  // X100 names radius 50; X80 is 40, U-10 is 5 less.
  const Lines want = {"1 rapid x25 z20", "3 rapid x40 z-5", "4 rapid x35", "end x35 y0 z-5 a0 c0"};
  EXPECT_EQ(records_of("gsk.basic.000052"), want);
}

TEST(DerivedArc, CounterclockwiseInG18WithZRightAndXUp) {
  // From (Z1, X10) by W-24, U24 = 12: R15 counterclockwise has its centre 15 left of the start:
  // (-9)^2 + 12^2 = 15^2.
  const Lines want = {"1 rapid x10 z1", "2 arc G18 1 cx10 cz-14 x22 z-23 f200",
                      "end x22 y0 z-23 a0 c0"};
  EXPECT_EQ(records_of("gsk.arc.000023"), want);
}

TEST(DerivedArc, ACentreBy51213) {
  // From (0, 0) to (0, 10), clockwise by R13: the centre lies 12 to the right of the way up.
  const Lines want = {"1 rapid x0 y0", "2 arc G17 -1 cx12 cy5 x0 y10 f200", "end x0 y10 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.arc.000019"), want);
}

TEST(DerivedArc, ANegativeRIsTheLongWay) {
  // From (10, 0) to (0, -10), clockwise, 270 degrees: the centre is (10, -10), the start above it.
  const Lines want = {"1 rapid x10 y0", "2 arc G17 -1 cx10 cy-10 x0 y-10 f200",
                      "end x0 y-10 z0 a0 c0"};
  EXPECT_EQ(records_of("gsk.arc.000002"), want);
}

TEST(DerivedArc, ACentreWithARoot) {
  // From (0, 0) to (0, 10), counterclockwise by R10: sqrt(100 - 25) = 5 sqrt(3) to the left.
  const auto records = checked_in_expectation("gsk.arc.000020").records;
  ASSERT_EQ(records.size(), 3U);
  EXPECT_EQ(records[1].centre[0], reference::Number::root(0, -5, 3));
  EXPECT_EQ(records[1].centre[1], reference::Number(5));
  EXPECT_EQ(records[1].rot, 1);
}

TEST(DerivedArc, InG19TheFirstAxisIsY) {
  const Lines want = {"1 rapid y10 z0", "2 arc G19 -1 cy0 cz0 y0 z-10 f200",
                      "end x0 y0 z-10 a0 c0"};
  EXPECT_EQ(records_of("gsk.arc.000068"), want);
}

TEST(DerivedArc, AFullTurnDown) {
  const Lines want = {"1 rapid x10 y0 z5", "2 arc G17 -1 cx0 cy0 x10 y0 z3 f200",
                      "end x10 y0 z3 a0 c0"};
  EXPECT_EQ(records_of("gsk.arc.000080"), want);
}

}  // namespace
}  // namespace gonogo::testing
