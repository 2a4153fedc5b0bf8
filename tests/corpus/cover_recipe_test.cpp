// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/recipes/cover_recipe.hpp"

#include <gtest/gtest.h>

#include "corpus_testing.hpp"
#include "fuzz/generate/cover/cases.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

std::vector<oracle::Case> cases_of(const std::string& text) {
  const ScratchFolder scratch;
  return recipes::cover_recipe_cases(scratch.write("cover.toml", text));
}

std::string cover_recipe_error(const std::string& text) {
  return corpus_error([&] { cases_of(text); });
}

constexpr const char* kGoodCoverRecipe =
    "[cover]\nmodel = \"ngc.line\"\nversion = 1\nstrength = 1\nfault_strength = 1\nseed = 1\n";

TEST(CoverRecipe, GivesTheCasesOfTheModel) {
  const std::vector<oracle::Case> cases = cases_of(kGoodCoverRecipe);
  ASSERT_FALSE(cases.empty());
  EXPECT_EQ(cases.front().id, "ngc.line.v1-t1f1-s1.000001");
}

TEST(CoverRecipe, LeavesOutWhatItNames) {
  const auto cases =
      cases_of(std::string(kGoodCoverRecipe) + "left_out = [\"ngc.line.v1-t1f1-s1.000001\"]\n");
  EXPECT_EQ(cases.size() + 1, cases_of(kGoodCoverRecipe).size());
}

TEST(CoverRecipe, AnotherVersionOfTheModelIsNoticed) {
  std::string text(kGoodCoverRecipe);
  text.replace(text.find("version = 1"), 11, "version = 9");
  EXPECT_TRUE(has(cover_recipe_error(text), "is at version 1"));
}

TEST(CoverRecipe, AnUnknownModelOrKeyIsNamed) {
  std::string text(kGoodCoverRecipe);
  EXPECT_TRUE(has(cover_recipe_error(text + "colour = 1\n"), "no key colour"));
  text.replace(text.find("ngc.line"), 8, "ngc.none");
  EXPECT_TRUE(has(cover_recipe_error(text), "no model ngc.none"));
}

// The completeness that the corpus states, counted from the tags of its cases alone.
TEST(CoverRecipe, TheCheckedInArraysHoldEveryTuple) {
  std::map<std::string, std::pair<cover::Making, std::vector<oracle::Case>>> arrays;
  for (const auto& [id, test] : checked_in_cases()) {
    if (const auto making = cover::making_of(test)) {
      auto& array = arrays[making->stem()];
      array.first = *making;
      array.second.push_back(test);
    }
  }
  EXPECT_EQ(arrays.size(), cover::models().size());
  for (const auto& [stem, array] : arrays) {
    // Cases of G74 and G75 are left out (their recipes say why).
    if (stem.starts_with("hnc.g74.") || stem.starts_with("hnc.g75.")) continue;
    const auto& [making, cases] = array;
    const auto count = cover::count_cases(cover::parse_parameters(making.model->parameters),
                                          making.strength, cases);
    EXPECT_TRUE(count.complete()) << stem << ": " << count.covered << " of " << count.allowed;
  }
}

}  // namespace
}  // namespace gonogo::testing
