// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/compare.hpp"

#include <gtest/gtest.h>

#include "tests/publish/evidence/results_files.hpp"

namespace gonogo::oracle::evidence {
namespace {

std::string line(const std::string& id, const std::string& verdict, const std::string& rest = "") {
  std::string text = R"({"id":")" + id +
                     R"(","dialect":"rs274","cycle":"g1","clauses":[],"verdict":")" + verdict +
                     "\"" + rest;
  if (!verdict.starts_with("pass") && verdict != "skip") text += R"(,"program":"","trace":[])";
  return text + "}";
}

class Compare : public testing::Test {
 protected:
  Comparison compare(const std::vector<std::string>& before,
                     const std::vector<std::string>& after) {
    return compare_runs(
        {scratch_.write("old", results_text(before)), scratch_.write("new", results_text(after))});
  }
  Scratch scratch_;
};

TEST_F(Compare, SameRunsHaveNoDifference) {
  const auto both = std::vector{line("a", "pass-exact"), line("b", "fail.order")};
  const Comparison comparison = compare(both, both);
  EXPECT_TRUE(comparison.changed.empty());
  EXPECT_TRUE(comparison.notes.empty());
  EXPECT_EQ(comparison.same, 2U);
}

TEST_F(Compare, GoThatIsNoGoNowIsARegression) {
  const Comparison comparison = compare({line("a", "pass-exact"), line("b", "skip")},
                                        {line("a", "fail.order"), line("b", "crash")});
  EXPECT_EQ(comparison.count(Change::regression), 1U);  // a skip was no GO
  EXPECT_EQ(comparison.changed[0].runs[0]["verdict"], "pass-exact");
  EXPECT_EQ(comparison.changed[0].runs[1]["verdict"], "fail.order");
}

TEST_F(Compare, NoGoThatIsGoNowIsMended) {
  EXPECT_EQ(compare({line("a", "crash")}, {line("a", "pass-exact")}).count(Change::mended), 1U);
}

TEST_F(Compare, NoGoThatDepartsElsewhereIsTold) {
  const auto at = [](const char* b) { return line("a", "fail.order", std::string(",\"b\":") + b); };
  EXPECT_EQ(compare({at("2")}, {at("3")}).count(Change::departure), 1U);
  EXPECT_EQ(compare({at("2")}, {at("2")}).count(Change::departure), 0U);
}

TEST_F(Compare, TimesMakeNoDifference) {
  EXPECT_EQ(
      compare({line("a", "pass-exact", ",\"us\":1")}, {line("a", "pass-exact", ",\"us\":2")}).same,
      1U);
}

// J-RUN-16: 2,038 passes that became advices, and 592 that became skips, were no regression once.
TEST_F(Compare, PassThatIsNoneNowIsARegressionWhateverItIsCalled) {
  const char* const kNone[] = {"skip", "advice", "oracle-gap", "xfail", "oracle-error"};
  std::vector<std::string> before;
  std::vector<std::string> after;
  for (const char* verdict : kNone) {
    before.push_back(line(std::string("a.") + std::to_string(before.size()), "pass-exact"));
    after.push_back(line(std::string("a.") + std::to_string(after.size()), verdict));
  }
  EXPECT_EQ(compare(before, after).count(Change::regression), 5U);
}

TEST_F(Compare, NoGoThatIsUndecidedOrKnownNowIsTold) {
  const Comparison comparison = compare({line("a", "fail.order"), line("b", "fail.order")},
                                        {line("a", "oracle-gap"), line("b", "xfail")});
  EXPECT_EQ(comparison.count(Change::verdict), 2U);
}

TEST_F(Compare, KnownFailureThatFailsOtherwiseNowIsARegression) {
  EXPECT_EQ(compare({line("a", "xfail")}, {line("a", "crash")}).count(Change::regression), 1U);
}

// J-RUN-16: the entry is gone and the failure is the same, elsewhere, or gone as well.
TEST_F(Compare, KnownFailureThatFailsAsBeforeIsNoRegression) {
  const auto known = [](const char* b) {
    return line("a", "xfail",
                std::string(R"(,"departure":"fail.order","known":"r","message":"x","b":)") + b);
  };
  const auto fails = [](const char* b) {
    return line("a", "fail.order", std::string(R"(,"message":"x","b":)") + b);
  };
  EXPECT_EQ(compare({known("2")}, {fails("2")}).count(Change::regression), 0U);
  EXPECT_EQ(compare({known("2")}, {fails("2")}).count(Change::verdict), 1U);
  EXPECT_EQ(compare({known("2")}, {fails("3")}).count(Change::regression), 1U);
  EXPECT_EQ(compare({known("2")}, {line("a", "xpass")}).count(Change::regression), 0U);
}

TEST_F(Compare, CasesOfOneRunOnlyAreNewOrGone) {
  const Comparison comparison =
      compare({line("a", "pass-exact"), line("c", "pass-exact"), line("d", "pass-exact")},
              {line("b", "crash"), line("c", "pass-exact"), line("e", "crash")});
  EXPECT_EQ(comparison.added.first, (std::vector<std::string>{"b", "e"}));
  EXPECT_EQ(comparison.gone.first, (std::vector<std::string>{"a", "d"}));
  EXPECT_EQ(comparison.same, 1U);
  EXPECT_EQ(comparison.count(Change::regression), 0U);
}

TEST_F(Compare, OtherCorpusAndMissingFooterAreNoted) {
  std::string other = results_text({line("a", "pass-exact")});
  other.replace(other.find("2026.6.0"), 8, "2026.7.0");
  other.erase(other.find("{\"decision\""));
  const Comparison comparison =
      compare_runs({scratch_.write("old", results_text({line("a", "pass-exact")})),
                    scratch_.write("new", other)});
  ASSERT_EQ(comparison.notes.size(), 2U);
  EXPECT_NE(comparison.notes[0].find("incomplete"), std::string::npos);
  EXPECT_NE(comparison.notes[1].find("corpus"), std::string::npos);
}

TEST_F(Compare, JsonHasTheSameNumbersAsTheText) {
  const Comparison comparison = compare({line("a", "pass-exact"), line("b", "pass-exact")},
                                        {line("a", "fail.order"), line("c", "pass-exact")});
  const Json json = Json::parse(comparison_text(comparison, CompareFormat::json));
  EXPECT_EQ(json["counts"]["regressions"], 1);
  EXPECT_EQ(json["regressions"][0]["id"], "a");
  EXPECT_EQ(json["counts"]["new"], 1);
  EXPECT_EQ(json["counts"]["gone"], 1);
  const std::string text = comparison_text(comparison, CompareFormat::text);
  EXPECT_NE(text.find("regressions         1"), std::string::npos) << text;
  EXPECT_TRUE(comparison_text(comparison, CompareFormat::markdown).starts_with("# Regressions: 1"));
}

}  // namespace
}  // namespace gonogo::oracle::evidence
