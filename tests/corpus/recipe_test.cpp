// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tool refuses to make a vector of.
#include "corpus/recipes/recipe.hpp"

#include <gtest/gtest.h>

#include "corpus/recipes/corpus_text.hpp"
#include "corpus_testing.hpp"
#include "tests/has.hpp"

namespace gonogo::testing {
namespace {

// A recipe of one case with these further lines.
std::string recipe_error(std::string_view lines) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.toml", R"(dialect = "gsk988ta"
cycle = "g94"
[[group]]
gid = "t.a"
features = ["g94"]
clauses = ["GSK-G94-01"]
[[group.case]]
id = "t.a.000001"
comment = "one"
)" + std::string(lines));
  return corpus_error([&] {
    for (const recipes::RecipeCase& recipe : recipes::read_recipe(file)) recipes::prepare(recipe);
  });
}

TEST(Recipe, AGoodOne) {
  EXPECT_EQ(recipe_error("program = \"G00 X1\\n\"\n"), "");
}

// `opening` stands behind the first line of each program, but where the case has another one.
TEST(Recipe, AnOpeningTurnsTheSpindle) {
  const ScratchFolder scratch;
  const std::string file = scratch.write("a.toml", R"(dialect = "sinumerik840d"
cycle = "basic"
opening = "S400 M3"
[[group]]
gid = "t.a"
features = ["basic"]
clauses = ["SIE-G1-01"]
[[group.case]]
id = "t.a.000001"
comment = "one"
program = "G0 X1\r\nG1 X2 F100\r\n"
[[group.case]]
id = "t.a.000002"
comment = "two"
opening = ""
program = "G0 X1\nG1 X2 F100\n"
)");
  const std::vector<recipes::RecipeCase> cases = recipes::read_recipe(file);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0].test.program, "G0 X1 S400 M3\r\nG1 X2 F100\r\n");
  EXPECT_EQ(recipes::prepare(cases[0]).expect.front().basis, reference::Basis::derived);
  EXPECT_EQ(cases[1].test.program, "G0 X1\nG1 X2 F100\n");
  EXPECT_EQ(recipes::prepare(cases[1]).expect.front().basis, reference::Basis::silent);
}

TEST(Recipe, AnAlarmThatTheRecipeDoesNotExpect) {
  EXPECT_EQ(recipe_error("program = \"G94 X1\\n\"\n"),
            "t.a.000001: the recipe wants the alarms none, the reference gives feed-missing@1.");
}

TEST(Recipe, AnAlarmThatDoesNotCome) {
  EXPECT_EQ(recipe_error("program = \"G00 X1\\n\"\nalarm = [\"feed-missing@1\"]\n"),
            "t.a.000001: the recipe wants the alarms feed-missing@1, the reference gives none.");
}

TEST(Recipe, AnAlarmOfAnotherBlock) {
  EXPECT_NE(recipe_error("program = \"G94 X1\\n\"\nalarm = [\"feed-missing@2\"]\n"), "");
}

TEST(Recipe, AnUnexpectedGap) {
  EXPECT_NE(recipe_error("program = \"G71\\n\"\n"), "");
  EXPECT_EQ(recipe_error("program = \"G71\\n\"\noutside = true\n"), "");
}

TEST(Recipe, AReadingWithoutEffect) {
  EXPECT_EQ(recipe_error("program = \"G00 X1\\n\"\n"
                         "readings = { \"gsk.g94.rewrite\" = [\"keep\", \"clear\"] }\n"),
            "t.a.000001: the reading gsk.g94.rewrite makes no difference.");
}

TEST(Recipe, AKeyThatRecipesDoNotHave) {
  EXPECT_TRUE(has(recipe_error("program = \"\"\nalarms = []\n"), "alarms"));
}

TEST(Recipe, NoToml) {
  EXPECT_TRUE(has(recipe_error("program = \n"), "a.toml:"));
}

TEST(Recipes, AnIdIsUsedOnce) {
  const ScratchFolder scratch;
  scratch.write("corpus.toml", "version = \"1.0.0\"\nretired = [\"t.a.000001\"]\n");
  scratch.write("gsk988ta/a.toml", R"(dialect = "gsk988ta"
cycle = "g94"
[[group]]
gid = "t.a"
features = ["g94"]
clauses = ["GSK-G94-01"]
[[group.case]]
id = "t.a.000001"
comment = "one"
program = ""
)");
  EXPECT_TRUE(has(corpus_error([&] { recipes::corpus_from_recipes(scratch.path().string()); }),
                  "the id t.a.000001 was used before"));
}

}  // namespace
}  // namespace gonogo::testing
