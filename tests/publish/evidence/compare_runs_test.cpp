// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/compare.hpp"

#include <gtest/gtest.h>

#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::evidence {
namespace {

std::string run_line(const std::string& id, const std::string& verdict,
                     const std::string& rest = "") {
  return R"({"id":")" + id + R"(","dialect":"rs274","cycle":"g1","clauses":[],"verdict":")" +
         verdict + "\"" + rest + "}";
}

class CompareRuns : public testing::Test {
 protected:
  Comparison compare(const std::vector<std::vector<std::string>>& runs) {
    std::vector<std::string> paths;
    for (const auto& cases : runs) {
      paths.push_back(scratch_.write("run-" + std::to_string(paths.size()), results_text(cases)));
    }
    return compare_runs(paths);
  }
  Scratch scratch_;
};

TEST_F(CompareRuns, LastRunIsHeldAgainstAllBefore) {
  const Comparison comparison = compare(
      {{run_line("a", "pass-exact"), run_line("b", "fail.order"), run_line("c", "fail.order"),
        run_line("d", "pass-exact"), run_line("e", "pass-exact")},
       {run_line("a", "skip"), run_line("b", "skip"), run_line("c", "fail.order"),
        run_line("d", "fail.order"), run_line("e", "pass-exact")},
       {run_line("a", "fail.order"), run_line("b", "pass-exact"),
        run_line("c", "fail.order", R"(,"b":3)"), run_line("d", "pass-exact"),
        run_line("e", "pass-exact")}});
  ASSERT_EQ(comparison.changed.size(), 4U);
  EXPECT_EQ(comparison.changed[0].change, Change::regression);
  EXPECT_EQ(comparison.changed[1].change, Change::mended);
  EXPECT_EQ(comparison.changed[2].change, Change::departure);
  EXPECT_EQ(comparison.changed[3].change, Change::mended);  // GO, NO-GO, GO
  EXPECT_EQ(comparison.changed[3].runs[1]["verdict"], "fail.order");
  EXPECT_EQ(comparison.same, 1U);
}

TEST_F(CompareRuns, CaseOfSomeRunsIsNewGoneOrCompared) {
  const Comparison comparison =
      compare({{run_line("a", "pass-exact"), run_line("b", "pass-exact")},
               {run_line("a", "pass-exact"), run_line("c", "pass-exact")},
               {run_line("b", "fail.order"), run_line("c", "pass-exact"), run_line("d", "crash")}});
  EXPECT_EQ(comparison.added.first, std::vector<std::string>{"d"});
  EXPECT_EQ(comparison.gone.first, std::vector<std::string>{"a"});
  ASSERT_EQ(comparison.count(Change::regression), 1U);
  EXPECT_TRUE(comparison.changed[0].runs[1].is_null());
  EXPECT_EQ(comparison.same, 1U);
}

// J-RUN-16.
TEST_F(CompareRuns, KnownFailureIsARegressionWhereItFailsOtherwise) {
  const std::string known = run_line("a", "xfail", R"(,"departure":"fail.order","b":2)");
  const std::string passed = run_line("b", "pass-exact");
  const auto regressions = [&](const std::string& now) {
    return compare({{known, passed}, {known, passed}, {now, passed}}).count(Change::regression);
  };
  EXPECT_EQ(regressions(run_line("a", "fail.order", R"(,"b":2)")), 0U);
  EXPECT_EQ(regressions(run_line("a", "fail.order", R"(,"b":3)")), 1U);
  EXPECT_EQ(regressions(run_line("a", "crash", R"(,"b":2)")), 1U);
}

TEST_F(CompareRuns, TextsHaveARowOfVerdictsForEachCase) {
  const Comparison comparison = compare({{run_line("a", "pass-exact"), run_line("b", "pass-exact")},
                                         {run_line("a", "skip"), run_line("b", "pass-exact")},
                                         {run_line("a", "crash"), run_line("b", "pass-exact")}});
  const std::string text = comparison_text(comparison, CompareFormat::text);
  EXPECT_NE(text.find("  a\n    1 pass-exact\n    2 skip\n    3 crash\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("regressions         1"), std::string::npos) << text;
  const Json json = Json::parse(comparison_text(comparison, CompareFormat::json));
  EXPECT_EQ(json["regressions"][0]["runs"][1]["verdict"], "skip");
  EXPECT_EQ(json["counts"]["same"], 1);
  const std::string markdown = comparison_text(comparison, CompareFormat::markdown);
  EXPECT_TRUE(markdown.starts_with("# Regressions: 1"));
  EXPECT_NE(markdown.find("| a | pass-exact | skip | crash |"), std::string::npos) << markdown;
}

}  // namespace
}  // namespace gonogo::oracle::evidence
