// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "expanders/gsk/direction.hpp"

namespace gonogo::expanders::gsk {
namespace {

constexpr long double kHalfRootOfThree = std::numbers::sqrt3_v<long double> / 2;

TEST(GskDirection, QuartersAreExact) {
  const long double wanted[][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (Fixed quarter = 0; quarter < 4; ++quarter) {
    const Direction direction = direction_of(quarter * 5, 20);
    EXPECT_EQ(direction.cosine, wanted[quarter][0]) << quarter;
    EXPECT_EQ(direction.sine, wanted[quarter][1]) << quarter;
  }
}

TEST(GskDirection, HalvesAreExact) {
  EXPECT_EQ(direction_of(60, 360).cosine, 0.5L);
  EXPECT_EQ(direction_of(30, 360).sine, 0.5L);
  EXPECT_EQ(direction_of(300, 360).cosine, 0.5L);
  EXPECT_EQ(direction_of(240, 360).cosine, -0.5L);
  EXPECT_EQ(direction_of(60, 360).sine, kHalfRootOfThree);
}

TEST(GskDirection, OthersAreUnitVectorsOfTheirAngle) {
  for (Fixed degree = 0; degree < 360; ++degree) {
    const Direction direction = direction_of(degree * kOne, 360 * kOne);
    const double angle = static_cast<double>(degree) * std::numbers::pi / 180;
    EXPECT_NEAR(static_cast<double>(direction.cosine), std::cos(angle), 1e-15) << degree;
    EXPECT_NEAR(static_cast<double>(direction.sine), std::sin(angle), 1e-15) << degree;
  }
}

TEST(GskDirection, TurnsBothWays) {
  const Direction from = direction_of(1, 4);
  const Direction onwards = turned(from, direction_of(1, 6), 1);
  EXPECT_EQ(onwards.cosine, -kHalfRootOfThree);
  EXPECT_EQ(onwards.sine, 0.5L);
  const Direction back = turned(from, direction_of(1, 6), -1);
  EXPECT_EQ(back.cosine, kHalfRootOfThree);
  EXPECT_EQ(back.sine, 0.5L);
}

}  // namespace
}  // namespace gonogo::expanders::gsk
