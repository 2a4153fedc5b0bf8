// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/number_range.hpp"

#include <gtest/gtest.h>

namespace gonogo::fuzz {
namespace {

TEST(NumberRange, NineDigitsBeforeThePointAndSevenBehindAreShort) {
  EXPECT_TRUE(has_short_numbers(""));
  EXPECT_TRUE(has_short_numbers("G1 X-123456789.1234567 Y.5 Z5."));
  EXPECT_TRUE(has_short_numbers("N0000000000000000000010 X1.00000000000000000000\n"));
}

TEST(NumberRange, MoreAreNotAnywhere) {
  EXPECT_FALSE(has_short_numbers("X1234567890"));
  EXPECT_FALSE(has_short_numbers("X1 Y=AC(20.00000000000000000001)"));
  EXPECT_FALSE(has_short_numbers("X.00000001"));
  EXPECT_FALSE(has_short_numbers("X1..00000001"));
}

}  // namespace
}  // namespace gonogo::fuzz
