// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/unit_error.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

TEST(UnitError, IsAFactorBetweenUnits) {
  EXPECT_EQ(unit_error(Quantity::feed, 10, 600, 0),
            " It is 60 times what is due: mm/min taken for mm/s?");
  EXPECT_EQ(unit_error(Quantity::feed, 254, 10, 0),
            " It is 5/127 of what is due: inches not converted to mm?");
  EXPECT_EQ(unit_error(Quantity::dwell, 2, 2000, 0),
            " It is 1000 times what is due: ms taken for s?");
  EXPECT_EQ(unit_error(Quantity::dwell, 2, 1, 0),
            " It is half what is due: halved as a diameter is?");
}

// A turn has 360 degrees; a degree is no length, and has no diameter.
TEST(UnitError, OfARotaryAxisIsOneOfDegrees) {
  EXPECT_EQ(unit_error(Quantity::rotary_feed, 360, 9144, 0),
            " It is 127/5 times what is due: degrees taken for inches?");
  EXPECT_EQ(unit_error(Quantity::rotary_feed, 360, 1, 0),
            " It is a 360th of what is due: turns put out for degrees?");
  EXPECT_EQ(unit_error(Quantity::rotary_feed, 360, 720, 0), "");
  EXPECT_EQ(unit_error(Quantity::rotary_feed, 1, 1000, 0), "");
}

TEST(UnitError, IsNoOtherFactor) {
  EXPECT_EQ(unit_error(Quantity::feed, 10, 601, 0), "");
  EXPECT_EQ(unit_error(Quantity::feed, 10, 30, 0), "");
  EXPECT_EQ(unit_error(Quantity::feed, 0, 0, 0), "");
  EXPECT_EQ(unit_error(Quantity::lead, 1, 1000, 0), "");
}

// 1/60 to two decimals is 0.02, which is near too much to say so; of 100 it is 1.67.
TEST(UnitError, AllowsForRounding) {
  const Number half = Number::decimal(false, 5, 3);
  EXPECT_EQ(unit_error(Quantity::feed, 1, Number::decimal(false, 2, 2), half), "");
  EXPECT_NE(unit_error(Quantity::feed, 100, Number::decimal(false, 167, 2), half), "");
  EXPECT_EQ(unit_error(Quantity::feed, 100, Number::decimal(false, 168, 2), half), "");
}

}  // namespace
}  // namespace gonogo::oracle
