// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/drawn_vectors.hpp"

#include <gtest/gtest.h>

#include <set>

#include "corpus/io/recheck.hpp"
#include "fuzz/hunt/coverage.hpp"

namespace gonogo::hunt {
namespace {

DrawnVectors drawn_from(std::string_view dialect, std::uint64_t seed, std::size_t programs) {
  const auto source = [&](std::uint64_t one) {
    generate::Choices choices(one);
    return generate::generator_of(dialect).generate(choices, nullptr);
  };
  return draw_vectors(source, seed, programs, "gonogo");
}

TEST(DrawnVectors, AreCasesThatTheReferenceStandsBy) {
  for (const generate::Generator& generator : generate::generators()) {
    const DrawnVectors drawn = drawn_from(generator.dialect, 7, 100);
    EXPECT_GT(drawn.cases.size(), 20U) << generator.dialect;
    std::set<std::string> ids;
    std::set<std::string> groups;
    for (const oracle::Case& test : drawn.cases) {
      EXPECT_EQ(oracle::recheck(test), std::nullopt) << test.id;
      EXPECT_FALSE(test.clauses.empty()) << test.id;
      EXPECT_FALSE(test.expect.empty()) << test.id;
      EXPECT_TRUE(ids.insert(test.id).second && groups.insert(test.group).second) << test.id;
    }
  }
}

TEST(DrawnVectors, AreTheSameForASeedAndOthersForAnother) {
  const DrawnVectors first = drawn_from("rs274", 7, 50);
  const DrawnVectors again = drawn_from("rs274", 7, 50);
  const DrawnVectors other = drawn_from("rs274", 1007, 50);
  ASSERT_EQ(first.cases.size(), again.cases.size());
  for (std::size_t i = 0; i < first.cases.size(); ++i) {
    EXPECT_EQ(first.cases[i].id, again.cases[i].id);
    EXPECT_EQ(first.cases[i].program, again.cases[i].program);
  }
  EXPECT_NE(first.cases.front().program, other.cases.front().program);
}

// CT after an arc without sweep, which no text decides: nothing is expected of that program.
TEST(DrawnVectors, LeaveOutWhatTheReferenceCannotDecide) {
  const DrawnVectors drawn = drawn_from("sinumerik840d", 30'955'327, 2);
  EXPECT_EQ(drawn.left_out, 1U);
  EXPECT_EQ(drawn.cases.size(), 1U);
}

// The first of a seed shows everything anew, and so does each of the rest something.
TEST(DrawnVectors, EachShowsSomethingThatNoneBeforeShows) {
  const DrawnVectors drawn = drawn_from("hnc21t", 7, 300);
  EXPECT_LT(drawn.cases.size() + drawn.left_out, 300U) << "nothing was left out";
  std::set<std::uint64_t> shown;
  for (const oracle::Case& test : drawn.cases) {
    const auto coverage =
        coverage_of({test.profile, test.program}, kMostDrawnCost, CoverageDetail::clauses);
    ASSERT_TRUE(coverage) << test.id;
    const std::size_t before = shown.size();
    shown.insert(coverage->features.begin(), coverage->features.end());
    EXPECT_GT(shown.size(), before) << test.id;
  }
  EXPECT_EQ(shown.size(), drawn.features);
}

}  // namespace
}  // namespace gonogo::hunt
