// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/reach.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hunting.hpp"

namespace gonogo::hunt::testing {
namespace {

oracle::Verdict verdict(oracle::VerdictKind kind) {
  oracle::Verdict verdict;
  verdict.kind = kind;
  return verdict;
}

TEST(Reach, CountsProgramsByClauseAndFeature) {
  using oracle::VerdictKind;
  Reach reach("gsk988ta");
  reach.add(ProgramSource::corpus, gsk(kTaper), verdict(VerdictKind::pass_exact));
  reach.add(ProgramSource::campaign, gsk(kTaper), verdict(VerdictKind::fail_geometry));
  reach.add(ProgramSource::campaign, gsk("G00 X100 Z5\nG94 X50 Z-10 R2 F100\n"),
            verdict(VerdictKind::skip));
  reach.add(ProgramSource::corpus, gsk("G00 X100\n"), std::nullopt);
  reach.add_about("GSK-G94-02");
  reach.add_about("no clause of the dialect");

  EXPECT_EQ(reach.programs().corpus, 2U);
  EXPECT_EQ(reach.programs().campaign, 2U);
  EXPECT_EQ(reach.programs().judged, 2U);
  EXPECT_EQ(reach.programs().no_go, 1U);
  EXPECT_EQ(reach.programs().skipped, 1U);
  const ClauseReach& approach = reach.clauses().at("GSK-G94-02");
  EXPECT_EQ(approach.about, 1U);
  EXPECT_EQ(approach.count.corpus, 1U);
  EXPECT_EQ(approach.count.campaign, 2U);
  EXPECT_EQ(approach.count.judged, 2U);
  EXPECT_EQ(approach.count.no_go, 1U);
  const ReachCount& cycle = reach.features().at("g94");
  EXPECT_EQ(cycle.programs(), 3U);
  EXPECT_EQ(cycle.skipped, 1U);
  EXPECT_EQ(reach.clauses().count("no clause of the dialect"), 0U);
  // What no program reached is there, with nothing.
  EXPECT_EQ(reach.clauses().at("GSK-G110-12").count.programs(), 0U);
  EXPECT_EQ(reach.features().at("g110").programs(), 0U);
}

TEST(Reach, WaysOfAClauseAreThoseOfSignsAndKinds) {
  Reach reach("gsk988ta");
  const auto clause = [&]() -> const ClauseReach& { return reach.clauses().at("GSK-G94-02"); };
  const auto passed = verdict(oracle::VerdictKind::pass_exact);
  reach.add(ProgramSource::corpus, gsk("G00 X100 Z5\nG94 X50 Z-10 F100\n"), passed);
  const std::size_t one = clause().ways.size();
  EXPECT_GT(one, 0U);
  // Other values of the same signs.
  reach.add(ProgramSource::corpus, gsk("G00 X100 Z5\nG94 X51 Z-11 F100\n"), passed);
  EXPECT_EQ(clause().ways.size(), one);
  // The other way along Z; skipped, it is met and not judged.
  reach.add(ProgramSource::campaign, gsk("G00 X100 Z5\nG94 X50 Z10 F100\n"),
            verdict(oracle::VerdictKind::skip));
  EXPECT_GT(clause().ways.size(), one);
  EXPECT_EQ(clause().judged_ways.size(), one);
}

TEST(Reach, FeaturesThatOnlyACaseNamesCount) {
  Reach reach("rs274");
  const generate::GeneratedProgram program{defaults("rs274"), "#1=5\nG0 X#1\n"};
  reach.add(ProgramSource::corpus, program, verdict(oracle::VerdictKind::skip), {"parameters"});
  EXPECT_EQ(reach.features().at("parameters").skipped, 1U);
}

TEST(Reach, JsonAndTextSayTheSame) {
  Reach reach("gsk988ta");
  reach.add(ProgramSource::corpus, gsk(kTaper), verdict(oracle::VerdictKind::pass_exact));
  const auto json = nlohmann::json::parse(reach.json("lib:acme.so"));
  EXPECT_EQ(json.at("subject"), "lib:acme.so");
  EXPECT_EQ(json.at("clauses").size(), reach.clauses().size());
  std::size_t reached = 0;
  for (const auto& [id, clause] : json.at("clauses").items()) {
    reached += clause.at("corpus") > 0 ? 1U : 0U;
  }
  EXPECT_GT(reached, 2U);
  EXPECT_EQ(json.at("reached").at("clauses").at("reached"), reached);
  EXPECT_NE(reach.text().find("clauses   " + std::to_string(reached) + " of "), std::string::npos);
}

}  // namespace
}  // namespace gonogo::hunt::testing
