// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/geometry/arc_centre.hpp"

#include <gtest/gtest.h>

#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::reference {
namespace {

using exact::testing::num;

// 5, 12, 13: half the chord is 5, so the centre stands 12 off its middle.
TEST(ArcCentre, OfAShortClockwiseArcIsOnTheRightOfTheChord) {
  const ArcEnds ends(Vector_2(10, 0));
  EXPECT_EQ(centre_from_radius(ends, 13, -1), Point_2(5, -12));
  EXPECT_EQ(centre_from_radius(ends, -13, -1), Point_2(5, 12));
  EXPECT_EQ(centre_from_radius(ends, 13, 1), Point_2(5, 12));
}

// The chord of 2 along both axes is 2 sqrt(2) long: the centre of R2 stands off its middle by
// sqrt(4 - 2) = sqrt(2), at 45 degrees, which is 1 along each axis.
TEST(ArcCentre, IsRationalWhereItsRootsAre) {
  EXPECT_EQ(centre_from_radius(ArcEnds(Vector_2(2, 2)), 2, -1), Point_2(2, 0));
}

TEST(ArcCentre, IsTheMiddleOfADiameterAndNoneBeyondIt) {
  const ArcEnds ends(Vector_2(0, 10));
  EXPECT_EQ(centre_from_radius(ends, 5, 1), Point_2(0, 5));
  EXPECT_FALSE(centre_from_radius(ends, num("4.999999"), 1).has_value());
}

// From (0, 0) to (8, 8) about (3, 4): the radii are 5 and sqrt(41) = 6.40312.
TEST(ArcCentre, ComparesTheRadiiOfItsEnds) {
  const OffsetCentre arc(ArcEnds(Vector_2(8, 8)), Vector_2(3, 4));
  EXPECT_EQ(arc.centre, Point_2(3, 4));
  EXPECT_EQ(arc.start_2, Number(25'000'000));
  EXPECT_EQ(arc.end_2, Number(41'000'000));
  EXPECT_TRUE(arc.radii_agree(num("1.4032")));
  EXPECT_FALSE(arc.radii_agree(num("1.4031")));
}

}  // namespace
}  // namespace gonogo::reference
