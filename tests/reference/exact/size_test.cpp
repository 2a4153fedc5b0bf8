// SPDX-License-Identifier: GPL-3.0-or-later
//
// What an exact number takes, sums whose terms cancel out, and angles in radians.
#include "reference/exact/size.hpp"

#include <gtest/gtest.h>

#include "exact_testing.hpp"
#include "reference/exact/radians.hpp"

namespace gonogo::exact {
namespace {

using testing::num;

// An enclosure: the cosine of 20 degrees.
Number cosine() {
  return cos_sin_degrees(20)[0];
}

TEST(Size, AShortNumberTakesNothing) {
  EXPECT_EQ(size_of(num("12.5")).bits, 0U);
  EXPECT_EQ(size_of(num("12.5")).depth, 0U);
}

// 2^100 / 3 has 101 bits and 2.
TEST(Size, ARationalTakesTheBitsOfItsParts) {
  EXPECT_EQ(size_of(Number::binary(1, 100) / Number(3)).bits, 103U);
}

TEST(Size, AnEnclosureIsAsDeepAsItsOperations) {
  EXPECT_EQ(size_of(cosine()).depth, 1U);
  EXPECT_EQ(size_of(cosine() * cosine() + Number(1)).depth, 3U);
}

TEST(Cancelling, ATermThatIsTakenAwayAgainIsGone) {
  const Number x = cosine();
  EXPECT_EQ((x + Number(3)) - x, Number(3));
  EXPECT_EQ((Number(3) + x) - x, Number(3));
  EXPECT_EQ((x - Number(3)) - x, Number(-3));
  EXPECT_EQ(x - (x + Number(3)), Number(-3));
  EXPECT_EQ(x - (Number(3) + x), Number(-3));
  EXPECT_EQ(x - (x - Number(3)), Number(3));
  EXPECT_EQ((Number(3) - x) + x, Number(3));
  EXPECT_EQ(x + (Number(3) - x), Number(3));
}

TEST(Cancelling, AnIntervalCancelsOnlyItself) {
  const Number x = Number::between(1, 2);
  EXPECT_EQ((x + Number(3)) - x, Number(3));
  EXPECT_THROW((void)((x + Number(3)) - Number::between(1, 2) == Number(3)), Undecided);
}

// pi is between 3.14159265358979 and 3.1415926535898.
TEST(Radians, HalfATurnIsPi) {
  EXPECT_GT(radians(180), num("3.14159265358979"));
  EXPECT_LT(radians(180), num("3.1415926535898"));
  EXPECT_EQ(radians(0), Number(0));
}

}  // namespace
}  // namespace gonogo::exact
