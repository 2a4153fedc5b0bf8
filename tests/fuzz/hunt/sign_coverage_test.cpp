// SPDX-License-Identifier: GPL-3.0-or-later
//
// Signs of comparisons, as the reference tells them.
#include "fuzz/hunt/sign_coverage.hpp"
#include "reference/clause_literal.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "hunting.hpp"
#include "oracle/steps/program_input.hpp"
#include "reference/dialect.hpp"
#include "reference/expander.hpp"

namespace gonogo::hunt::testing {
namespace {

using reference::operator""_clause;

void expand(const std::string& dialect, const std::string& program) {
  const reference::Profile profile = defaults(dialect);
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  while (expander.next() != nullptr) {
  }
}

// G110 with a step L below, of and above twice the tool radius D = 2.
std::string pocket(const char* step) {
  return std::string("G00 X0 Y0 Z10 F100\nG17\nG110 X0 Y0 Z-5 R-5 I20 Q5 D2 L") + step + "\n";
}

Signs of(const SignCounter& counter, reference::ClauseId clause, const std::string& what) {
  const auto found = counter.counts().find({clause, what});
  return found == counter.counts().end() ? Signs{} : found->second;
}

TEST(SignCoverage, AComparisonTellsBelowAtAndAbove) {
  const auto step = [](const char* value) {
    SignCounter counter;
    expand("gsk988ta", pocket(value));
    return of(counter, "GSK-G110-03"_clause, "L - 2 D");
  };
  EXPECT_EQ(step("3.9"), (Signs{1, 0, 0}));
  EXPECT_EQ(step("4"), (Signs{0, 1, 0}));
  EXPECT_EQ(step("4.1"), (Signs{0, 0, 1}));
}

TEST(SignCoverage, TheLastCounterThatWasMadeTakesWhatIsDecided) {
  SignCounter first;
  { const SignCounter inner; }
  expand("gsk988ta", pocket("4"));
  EXPECT_EQ(of(first, "GSK-G110-03"_clause, "L - 2 D"), (Signs{0, 1, 0}));
  {
    SignCounter second;
    expand("gsk988ta", pocket("4"));
    EXPECT_EQ(of(second, "GSK-G110-03"_clause, "L - 2 D"), (Signs{0, 1, 0}));
  }
  EXPECT_EQ(of(first, "GSK-G110-03"_clause, "L - 2 D"), (Signs{0, 1, 0}));
}

TEST(SignCoverage, AHuntComesToBothSidesOfTheTaperLimit) {
  const SignCounter::Counts counts = signs_of_hunt(builtin("gsk"), "gsk988ta", 1, 500);
  const auto found = counts.find({"GSK-G94-09"_clause, "abs(R) - abs(travel)"});
  ASSERT_NE(found, counts.end());
  EXPECT_GT(found->second[0], 0U);
  EXPECT_GT(found->second[2], 0U);
}

TEST(SignCoverage, RowsHoldBothAndTheSummaryCountsSigns) {
  const SignCounter::Counts corpus = {{{"GSK-G94-09"_clause, "a"}, {2, 0, 1}}};
  const SignCounter::Counts hunt = {{{"GSK-G94-09"_clause, "a"}, {0, 3, 1}},
                                    {{"GSK-G94-09"_clause, "b"}, {1, 0, 0}}};
  const std::vector<SignRow> rows = sign_rows(corpus, hunt);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(met(rows[0].corpus), "-   +");
  EXPECT_EQ(met(rows[0].hunt), "  0 +");
  const SignSummary summary = summary_of(rows);
  EXPECT_EQ(summary.comparisons, 2U);
  EXPECT_EQ(summary.corpus, 2U);
  EXPECT_EQ(summary.hunt, 3U);
  EXPECT_EQ(summary.either, 4U);
}

// A speed or a feed in force is never below zero: the word is refused before.
TEST(SignCoverage, TheCorpusHasEverySignThatAProgramCanBringAbout) {
  const oracle::Corpus corpus(std::string(GONOGO_SOURCE_DIR) + "/corpus");
  std::set<std::string> missing;
  for (const reference::Dialect& dialect : reference::dialects()) {
    for (const auto& [key, signs] : signs_of_corpus(corpus, dialect.name)) {
      for (std::size_t i = 0; i < signs.size(); ++i) {
        if (signs[i] != 0) continue;
        missing.insert(fmt::format("{} {} {} {}", dialect.name, reference::clause_name(key.first),
                                   key.second, "-0+"[i]));
      }
    }
  }
  EXPECT_EQ(missing, (std::set<std::string>{"sinumerik802s SIE-LC82-03 F -",
                                            "sinumerik802s SIE-MOD-06 speed -",
                                            "sinumerik840d SIE-MOD-06 speed -"}));
}

}  // namespace
}  // namespace gonogo::hunt::testing
