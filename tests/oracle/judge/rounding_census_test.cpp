// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a subject that rounds by a known mode shows, by hand.
#include "oracle/records/rounding_census.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gonogo::oracle {
namespace {

Number decimal(const char* text) {
  return Number::parse(text).value();
}

struct Pair {
  const char* exact;
  const char* got;
};

bool is_correct(const Pair& pair) {
  return abs(decimal(pair.exact) - decimal(pair.got)) * 2 <= decimal("0.001");
}

// Declared: rounded to 0.001 mm.
RoundingCensus census_of(const std::vector<Pair>& pairs) {
  RoundingCensus census;
  for (const Pair& pair : pairs) {
    census.take(decimal(pair.exact), decimal(pair.got), is_correct(pair));
  }
  return census;
}

// 10/3 is 3.333 and -10/3 is -3.334 down, 2/3 is 0.667 to nearest, 0.666 toward zero.
TEST(RoundingCensus, TellsTheModes) {
  using enum RoundingMode;
  using Modes = std::vector<RoundingMode>;
  EXPECT_EQ(census_of({{"10/3", "3.333"}, {"-2/3", "-0.667"}}).rounded().modes(),
            (Modes{nearest, down}));
  EXPECT_EQ(census_of({{"2/3", "0.667"}, {"-10/3", "-3.333"}, {"1/3", "0.333"}}).rounded().modes(),
            (Modes{nearest}));
  EXPECT_EQ(census_of({{"2/3", "0.666"}, {"-2/3", "-0.666"}}).rounded().modes(),
            (Modes{toward_zero}));
  EXPECT_EQ(census_of({{"1/3", "0.334"}, {"-1/3", "-0.334"}}).rounded().modes(),
            (Modes{away_from_zero}));
  EXPECT_EQ(census_of({{"2/3", "0.666"}, {"-1/3", "-0.334"}}).rounded().modes(), (Modes{down}));
  EXPECT_EQ(census_of({{"1/3", "0.334"}, {"-2/3", "-0.666"}}).rounded().modes(), (Modes{up}));
}

TEST(RoundingCensus, TellsTheCoarsestGrid) {
  EXPECT_EQ(census_of({{"1/3", "0.33"}, {"2/3", "0.67"}}).rounded().increment(), decimal("0.01"));
  EXPECT_EQ(census_of({{"1/3", "0.33"}, {"2/3", "0.667"}}).rounded().increment(), decimal("0.001"));
  // 0.5 lies on the grid of 0.001, too, but 0.0625 is no multiple of it.
  EXPECT_EQ(census_of({{"1/16", "0.062"}, {"1/2", "0.5"}}).rounded().increment(), decimal("0.001"));
  EXPECT_EQ(census_of({{"1/3", "1/4000000007"}}).rounded().increment(), 0);
}

// 0.3353 is 2.3 of 0.001 off 0.333: within 3, and by no mode.
TEST(RoundingCensus, TellsHowManyIncrementsOff) {
  const RoundingCensus census = census_of({{"0.3353", "0.333"}, {"1", "1"}});
  EXPECT_EQ(census.rounded().increments_off(), 3);
  EXPECT_TRUE(census.rounded().modes().empty());
  EXPECT_EQ(census.text(),
            "1 exact, 1 off; on a grid of 0.001 mm, at most 3 of its steps away, by no one way of "
            "rounding");
}

// The root of 2 is 1.41421..., the root of 3 is 1.73205...
TEST(RoundingCensus, TakesRoots) {
  RoundingCensus census;
  census.take(Number::root(0, 1, 2), decimal("1.414"), true);
  census.take(Number::root(0, 1, 3), decimal("1.732"), true);
  census.take(Number::root(0, -1, 2), decimal("-1.414"), true);
  EXPECT_EQ(census.text(),
            "0 exact, 3 correctly rounded; on a grid of 0.001 mm, at most 1 of its steps away, "
            "nearest or "
            "toward zero");
}

// 0.0625, 0.0635 and -0.0625 lie midway between two of 0.001.
TEST(RoundingCensus, TellsWhereHalvesGo) {
  using enum HalvesRule;
  using Rules = std::vector<HalvesRule>;
  EXPECT_EQ(census_of({{"0.0625", "0.063"}}).rounded().halves(), (Rules{away_from_zero, up}));
  EXPECT_EQ(census_of({{"0.0625", "0.063"}, {"-0.0625", "-0.063"}}).rounded().halves(),
            (Rules{away_from_zero}));
  EXPECT_EQ(
      census_of({{"0.0625", "0.062"}, {"0.0635", "0.064"}, {"1/3", "0.333"}}).rounded().halves(),
      (Rules{to_even}));
  EXPECT_EQ(census_of({{"0.0625", "0.063"}, {"-0.0625", "-0.062"}}).rounded().halves(),
            (Rules{up}));
  EXPECT_EQ(census_of({{"0.0625", "0.062"}, {"-0.0635", "-0.063"}}).rounded().halves(),
            (Rules{toward_zero}));
  EXPECT_EQ(census_of({{"0.0625", "0.062"}, {"-0.0635", "-0.064"}}).rounded().halves(),
            (Rules{to_even, down}));
  // No half: every rule says the same.
  EXPECT_EQ(census_of({{"1/3", "0.333"}}).rounded().halves().size(), kHalvesRules);
  EXPECT_EQ(census_of({{"0.0625", "0.063"}, {"-0.0625", "-0.063"}}).text(),
            "0 exact, 2 correctly rounded; on a grid of 0.001 mm, at most 1 of its steps away, "
            "nearest with "
            "halves away from zero or away from zero");
}

TEST(RoundingCensus, SaysNothingOfWhatIsExact) {
  EXPECT_EQ(census_of({{"0.5", "0.5"}}).text(), "1 exact");
  EXPECT_TRUE(census_of({{"0.5", "0.5"}}).rounded().modes().empty());
}

// 1/3 lies between 0.333333333 and 0.333333334: nothing of 1e-15 says which.
TEST(RoundingCensus, SaysWhatCannotBeTold) {
  RoundingCensus census;
  const Number wide = Number::between(decimal("0.3"), decimal("0.4"));
  census.take(wide, decimal("0.35"), false);
  EXPECT_EQ(census.text(), "0 exact, 1 of which it cannot be told");
}

// What is off the grid of 1e-9 mm: 1/4000000007 is 2.49999...e-10, up to 1e-9 off from 0.
TEST(RoundingCensus, SaysHowFarOffWithoutAGrid) {
  EXPECT_EQ(census_of({{"0", "1/4000000007"}}).text(),
            "0 exact, 1 correctly rounded; on no decimal grid, within 0.000000001 mm");
}

std::vector<Pair> many_pairs() {
  return {{"1", "1"},          {"1/3", "0.33"},       {"2/3", "0.667"},      {"0.0625", "0.062"},
          {"0.0635", "0.063"}, {"-0.005", "-0.01"},   {"0.005", "0.01"},     {"7/3", "2.3333"},
          {"1/7", "0.142"},    {"-1/7", "-0.142857"}, {"5", "1/4000000007"}, {"0.25", "0.3"}};
}

// Every way to cut the list in two: the sums of the parts are the whole, by way of a file, too.
TEST(RoundingCensus, IsTheSumOfItsParts) {
  const std::vector<Pair> all = many_pairs();
  for (std::size_t size = 1; size <= all.size(); ++size) {
    const RoundingCensus whole = census_of({all.begin(), all.begin() + static_cast<long>(size)});
    for (std::size_t cut = 0; cut <= size; ++cut) {
      const auto middle = all.begin() + static_cast<long>(cut);
      const RoundingCensus first = census_of({all.begin(), middle});
      const RoundingCensus second = census_of({middle, all.begin() + static_cast<long>(size)});
      RoundingCensus sum = second;
      sum.add(first);
      EXPECT_EQ(sum, whole) << size << " " << cut;
      RoundingCensus stored = RoundingCensus::from_json(first.json()).value();
      stored.add(RoundingCensus::from_json(second.json()).value());
      EXPECT_EQ(stored.json().dump(), whole.json().dump()) << size << " " << cut;
    }
  }
}

// Correctly rounded to 0.001; 0.3353 as 0.334 is off by 1.3 of it, down. No mode fits both.
TEST(RoundingCensus, TellsBothKindsWhereNoModeFitsBoth) {
  EXPECT_EQ(census_of({{"1", "1"}, {"2/3", "0.667"}, {"0.3353", "0.334"}}).text(),
            "1 exact; 1 correctly rounded, on a grid of 0.001 mm, at most 1 of its steps away, "
            "nearest or away "
            "from zero or up; 1 off, on a grid of 0.001 mm, at most 2 of its steps away, by no one "
            "way of rounding");
}

TEST(RoundingCensus, RefusesWhatIsNone) {
  using Json = nlohmann::ordered_json;
  for (const char* text :
       {R"([])", R"({"exact":-1})", R"({"exact":"1"})", R"({"exact":1,"correct":1})",
        R"({"exact":1,"off":{}})", R"({"exact":1,"off":{"count":0,"most":"1"}})",
        R"({"exact":1,"off":{"count":1,"most":0.1}})",
        R"({"exact":1,"off":{"count":1,"most":"-1"}})",
        R"({"exact":1,"off":{"count":1,"most":"0.0001","decimals":3}})",
        R"({"exact":1,"off":{"count":1,"most":"0.0001","decimals":30,"modes":{}}})",
        R"({"exact":1,"off":{"count":1,"most":"0.0001","decimals":3,"modes":{"best":3}}})",
        R"({"exact":1,"off":{"count":1,"most":"0.0001","decimals":3,"modes":{"down":10}}})"}) {
    EXPECT_FALSE(RoundingCensus::from_json(Json::parse(text))) << text;
  }
}

}  // namespace
}  // namespace gonogo::oracle
