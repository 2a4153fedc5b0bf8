// SPDX-License-Identifier: GPL-3.0-or-later
//
// CGAL's functions over the exact number: what they give is exact, and what cannot be told is
// thrown.
#include "reference/geometry/kernel.hpp"

#include <gtest/gtest.h>

#include "tests/reference/exact/exact_testing.hpp"

namespace gonogo::geometry {
namespace {

using exact::testing::num;

// Seen from (1, 2, 3) the points are (1, 2, 2), (2, 1, -2) and the first one's opposite: each 3
// away.
TEST(Kernel, FindsTheCentreOfThreePointsInSpaceAsRationals) {
  const Point_3 centre = CGAL::circumcenter(Point_3(2, 4, 5), Point_3(3, 3, 1), Point_3(0, 0, 1));
  EXPECT_EQ(centre, Point_3(1, 2, 3));
  EXPECT_TRUE(centre.x().is_rational());
}

// cos 45 = sin 45 = sqrt(2) / 2, so that (10, 0) comes to 5 sqrt(2) on both axes: one root.
TEST(Kernel, TurnsBy45DegreesWithOneRoot) {
  const auto [cosine, sine] = exact::cos_sin_degrees(45);
  const Aff_transformation_2 turn(CGAL::ROTATION, sine, cosine);
  const Point_2 turned = turn(Point_2(10, 0));
  EXPECT_EQ(turned.x(), exact::sqrt(Number(50)));
  EXPECT_EQ(turned.y(), exact::sqrt(Number(50)));
  EXPECT_EQ(turn.inverse()(turned), Point_2(10, 0));
}

// First turned, then moved: (1, 0) comes to (0, 1) and then to (5, 8).
TEST(Kernel, PutsTheTransformationOnTheRightFirst) {
  const Aff_transformation_2 turn(CGAL::ROTATION, Number(1), Number(0));
  const Aff_transformation_2 move(CGAL::TRANSLATION, Vector_2(5, 7));
  EXPECT_EQ((move * turn)(Point_2(1, 0)), Point_2(5, 8));
}

TEST(Kernel, HalvesAThirdExactly) {
  EXPECT_EQ(CGAL::midpoint(Point_2(num("1/3"), 0), Point_2(0, num("0.000001"))),
            Point_2(num("1/6"), num("0.0000005")));
}

TEST(Kernel, TellsTheSideOfAPointAMillionthOfAMicrometreAway) {
  const Point_2 from(0, 0), to(1000, 1000);
  EXPECT_EQ(CGAL::orientation(from, to, Point_2(500, num("500.000000000001"))), CGAL::LEFT_TURN);
  EXPECT_EQ(CGAL::orientation(from, to, Point_2(500, 500)), CGAL::COLLINEAR);
}

// Both lie on the ray at 20 degrees, by coordinates that are enclosures: no number of digits shows
// it.
TEST(Kernel, ThrowsWhereNoDigitsDecide) {
  const auto [cosine, sine] = exact::cos_sin_degrees(20);
  const Vector_2 way(cosine, sine);
  EXPECT_THROW((void)CGAL::orientation(way * cosine, way * sine), exact::Undecided);
}

TEST(Kernel, SeesThePlanesAsRightHandedPairs) {
  using reference::Plane;
  const reference::Position at{{1, 2, 3, 4, 5}};
  EXPECT_EQ(point_in(axes_of(Plane::g17), at), Point_2(1, 2));
  EXPECT_EQ(point_in(axes_of(Plane::g18), at), Point_2(3, 1));  // Z and X
  EXPECT_EQ(point_in(axes_of(Plane::g19), at), Point_2(2, 3));
  reference::Position moved = at;
  put_in(moved, axes_of(Plane::g18), Point_2(30, 10));
  EXPECT_EQ(moved, (reference::Position{{10, 2, 30, 4, 5}}));
}

}  // namespace
}  // namespace gonogo::geometry
