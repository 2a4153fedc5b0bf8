// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject that rounds by a known mode shows, by hand.
#include "oracle/judge/rounding_census.hpp"

#include <gtest/gtest.h>

namespace gonogo::oracle {
namespace {

Number decimal(const char* text) {
  return Number::parse(text).value();
}

struct Pair {
  const char* exact;
  const char* got;
};

RoundingCensus census_of(const std::vector<Pair>& pairs) {
  RoundingCensus census;
  for (const Pair& pair : pairs) census.take(decimal(pair.exact), decimal(pair.got));
  return census;
}

// 10/3 is 3.333 and -10/3 is -3.334 down, 2/3 is 0.667 to nearest, 0.666 toward zero.
TEST(RoundingCensus, TellsTheModes) {
  using enum RoundingMode;
  using Modes = std::vector<RoundingMode>;
  EXPECT_EQ(census_of({{"10/3", "3.333"}, {"-2/3", "-0.667"}}).modes(), (Modes{nearest, down}));
  EXPECT_EQ(census_of({{"2/3", "0.667"}, {"-10/3", "-3.333"}, {"1/3", "0.333"}}).modes(),
            (Modes{nearest}));
  EXPECT_EQ(census_of({{"2/3", "0.666"}, {"-2/3", "-0.666"}}).modes(), (Modes{toward_zero}));
  EXPECT_EQ(census_of({{"1/3", "0.334"}, {"-1/3", "-0.334"}}).modes(), (Modes{away_from_zero}));
  EXPECT_EQ(census_of({{"2/3", "0.666"}, {"-1/3", "-0.334"}}).modes(), (Modes{down}));
  EXPECT_EQ(census_of({{"1/3", "0.334"}, {"-2/3", "-0.666"}}).modes(), (Modes{up}));
}

TEST(RoundingCensus, TellsTheCoarsestGrid) {
  EXPECT_EQ(census_of({{"1/3", "0.33"}, {"2/3", "0.67"}}).increment(), decimal("0.01"));
  EXPECT_EQ(census_of({{"1/3", "0.33"}, {"2/3", "0.667"}}).increment(), decimal("0.001"));
  // 0.5 lies on the grid of 0.001, too, but 0.0625 is no multiple of it.
  EXPECT_EQ(census_of({{"1/16", "0.062"}, {"1/2", "0.5"}}).increment(), decimal("0.001"));
  EXPECT_EQ(census_of({{"1/3", "1/4000000007"}}).increment(), 0);
}

// 0.3353 is 2.3 of 0.001 off 0.333: within 3, and by no mode.
TEST(RoundingCensus, TellsHowManyIncrementsOff) {
  const RoundingCensus census = census_of({{"0.3353", "0.333"}, {"1", "1"}});
  EXPECT_EQ(census.increments_off(), 3);
  EXPECT_TRUE(census.modes().empty());
  EXPECT_EQ(census.text(),
            "coordinates: 1 exact, 1 on a grid of 0.001 mm, within 3 of it; by no one mode");
}

// The root of 2 is 1.41421..., the root of 3 is 1.73205...
TEST(RoundingCensus, TakesRoots) {
  RoundingCensus census;
  census.take(Number::root(0, 1, 2), decimal("1.414"));
  census.take(Number::root(0, 1, 3), decimal("1.732"));
  census.take(Number::root(0, -1, 2), decimal("-1.414"));
  EXPECT_EQ(
      census.text(),
      "coordinates: 0 exact, 3 on a grid of 0.001 mm, within 1 of it; nearest or toward zero");
}

TEST(RoundingCensus, SaysNothingOfWhatIsExact) {
  EXPECT_EQ(census_of({{"0.5", "0.5"}}).text(), "coordinates: 1 exact");
  EXPECT_TRUE(census_of({{"0.5", "0.5"}}).modes().empty());
}

}  // namespace
}  // namespace gonogo::oracle
