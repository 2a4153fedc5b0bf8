// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/tally.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign/results.hpp"
#include "campaign_testing.hpp"

namespace gonogo::oracle {
namespace {

CaseFacts under(std::string id, std::vector<std::string> explaining) {
  CaseFacts made = facts(std::move(id), VerdictKind::pass_exact);
  made.readings = OpenReadings{{"r"}, std::move(explaining), VerdictKind::pass_exact, {}};
  return made;
}

TEST(Tally, APassIsGo) {
  const RunAnswer go = answer({facts("a", VerdictKind::pass_exact)});
  EXPECT_EQ(go.decision, "GO");
  EXPECT_EQ(go.exit_code, 0);
  EXPECT_EQ(go.judged, 1U);
}

TEST(Tally, OneNoGoDecidesWhateverElseIsUndecided) {
  const RunAnswer no_go =
      answer({facts("a", VerdictKind::oracle_error), facts("b", VerdictKind::fail_feed)});
  EXPECT_EQ(no_go.decision, "NO-GO");
  EXPECT_EQ(no_go.exit_code, 1);
}

TEST(Tally, AStaleEntryIsNoGo) {
  EXPECT_EQ(answer({facts("a", VerdictKind::pass_exact)}, {"x"}).exit_code, 1);
}

TEST(Tally, AGapIsUndecidedUnlessTheCorpusExpectsIt) {
  CaseFacts gap = facts("b", VerdictKind::oracle_gap);
  EXPECT_EQ(answer({facts("a", VerdictKind::pass_exact), gap}).exit_code, 3);
  gap.head.expected = true;
  EXPECT_EQ(answer({facts("a", VerdictKind::pass_exact), gap}).exit_code, 0);
}

TEST(Tally, ADialectOfSkipsAloneIsUndecided) {
  EXPECT_EQ(answer({facts("a", VerdictKind::pass_exact), facts("b", VerdictKind::skip, "hnc21t")})
                .exit_code,
            3);
  EXPECT_EQ(answer({}).decision, "UNDECIDED");
}

TEST(Tally, KnownFailuresAreNotJudged) {
  const RunAnswer known = answer({facts("a", VerdictKind::xfail), facts("b", VerdictKind::xfail)});
  EXPECT_EQ(known.decision, "UNDECIDED");
  EXPECT_EQ(known.judged, 0U);
}

TEST(Tally, ACaseThatNoAssignmentExplainsWithThoseBeforeItFails) {
  Tally tally;
  EXPECT_EQ(tally.add(under("a", {"r=1", "r=2"})), VerdictKind::pass_exact);
  EXPECT_EQ(tally.add(under("b", {"r=1"})), VerdictKind::pass_exact);
  EXPECT_EQ(tally.add(under("c", {"r=2"})), VerdictKind::fail_reading);
  EXPECT_EQ(tally.conflict()->against, "b");
  EXPECT_TRUE(has(tally.conflict()->message, "r: b shows 1, this case 2."));
  EXPECT_EQ(tally.add(under("d", {"r=1"})), VerdictKind::pass_exact);
  const RunAnswer no_go = tally.finish({});
  EXPECT_EQ(no_go.reading_conflict, "c");
  EXPECT_EQ(no_go.assignments, std::vector<std::string>{"r=1"});
  EXPECT_EQ(no_go.totals.at("fail.reading"), 1U);
  EXPECT_EQ(no_go.exit_code, 1);
}

// J-RUN-17.
TEST(Tally, AFailureOfReadingsMayBeKnown) {
  Tally tally;
  EXPECT_EQ(tally.add(under("a", {"r=1"})), VerdictKind::pass_exact);
  CaseFacts known = under("b", {"r=2"});
  known.readings->known = "two makers";
  EXPECT_EQ(tally.add(known), VerdictKind::xfail);
  known = under("c", {"r=1"});
  known.readings->known = "two makers";
  EXPECT_EQ(tally.add(known), VerdictKind::xpass);
}

TEST(Tally, ReadingsOfDifferentCasesAreJoined) {
  const RunAnswer go = answer({under("a", {"r=1", "r=2"}), under("b", {"r=1 s=3", "r=3 s=4"})});
  EXPECT_EQ(go.assignments, std::vector<std::string>{"r=1 s=3"});
}

// 1/3 as 0.333 and 2/3 as 0.667.
RoundingCensus rounded() {
  RoundingCensus census;
  census.take_exact(2);
  census.take(Number(1) / 3, Number::millionths(333'000), true);
  census.take(Number(2) / 3, Number::millionths(667'000), true);
  return census;
}

TEST(Tally, CoordinatesAreThoseOfAllThatIsGoByDialect) {
  std::vector<CaseFacts> cases;
  for (const char* dialect : {"gsk988ta", "rs274", "gsk988ta"}) {
    cases.push_back(facts("a" + std::to_string(cases.size()), VerdictKind::pass_rounded, dialect));
    cases.back().coordinates = rounded();
  }
  // GO under its readings, but not with those of the run: it says nothing.
  for (const char* assignment : {"r=1", "r=2"}) {
    cases.push_back(under("b" + std::to_string(cases.size()), {assignment}));
    cases.back().coordinates = rounded();
  }
  const RunAnswer said = answer(cases);
  ASSERT_EQ(said.coordinates.size(), 2U);
  EXPECT_EQ(said.coordinates.at("gsk988ta").exact(), 6U);
  EXPECT_EQ(said.coordinates.at("gsk988ta").rounded().count(), 6U);
  EXPECT_EQ(said.coordinates.at("rs274"), rounded());
}

TEST(Tally, ACaseLineSaysHowItsCoordinatesAreRounded) {
  CaseResult result = passed("a");
  result.verdict.kind = VerdictKind::pass_rounded;
  result.verdict.coordinates = rounded();
  EXPECT_EQ(facts_of(case_line(result, true)).coordinates, rounded());
  result.verdict.coordinates = RoundingCensus();
  result.verdict.coordinates->take_exact(7);
  EXPECT_TRUE(has(case_line(result, true), R"("coordinates":{"exact":7})"));
  EXPECT_EQ(facts_of(case_line(result, true)).coordinates, result.verdict.coordinates);
  result.verdict.kind = VerdictKind::xfail;
  EXPECT_FALSE(facts_of(case_line(result, true)).coordinates);
}

TEST(Tally, ACaseLineSaysItsFacts) {
  CaseResult result = passed("a \"quoted\"");
  result.verdict.kind = VerdictKind::pass_rounded;
  result.readings = OpenReadings{{"r", "s"}, {"r=1", "r=2 s=3"}, VerdictKind::pass_rounded, {}};
  result.mapped = "PS*";
  const CaseFacts read = facts_of(case_line(result, true));
  EXPECT_EQ(read.head.id, result.id);
  EXPECT_EQ(read.head.dialect, result.dialect);
  EXPECT_EQ(read.mapped, "PS*");
  ASSERT_TRUE(read.readings);
  EXPECT_EQ(read.readings->open, result.readings->open);
  EXPECT_EQ(read.readings->explaining, result.readings->explaining);
  EXPECT_EQ(read.verdict, VerdictKind::pass_rounded);
}

TEST(Tally, AReconciledLineStillSaysWhatItWasBefore) {
  CaseResult result = passed("a");
  result.readings = OpenReadings{{"r"}, {"r=1"}, VerdictKind::pass_exact, {}};
  result.program = "G0 X1\n";
  result.trace = {R"({"k":"rapid"})"};
  const std::string line = case_line(result, true);
  const ReadingConflict conflict{"r: x shows 2, this case 1.", "x"};
  const std::string failed =
      reconciled_line(line, VerdictKind::fail_reading, conflict, PassEvidence::drop);
  const auto told = nlohmann::json::parse(failed);
  EXPECT_EQ(told["verdict"], "fail.reading");
  EXPECT_EQ(told["message"], conflict.message);
  EXPECT_EQ(told["readings"]["against"], "x");
  EXPECT_EQ(told["program"], result.program);
  EXPECT_EQ(told["trace"][0]["k"], "rapid");
  EXPECT_EQ(facts_of(failed).verdict, VerdictKind::pass_exact);
  EXPECT_EQ(reconciled_line(failed, VerdictKind::pass_exact, std::nullopt, PassEvidence::keep),
            line);
  result.program.clear();
  EXPECT_EQ(reconciled_line(line, VerdictKind::pass_exact, std::nullopt, PassEvidence::drop),
            case_line(result, true));
}

TEST(Tally, WhatIsNoCaseLineIsRefused) {
  EXPECT_THROW(facts_of("{}"), std::runtime_error);
  EXPECT_THROW(facts_of("{\"id\":\"a\",\"dialect\":\"d\",\"verdict\":\"good\"}"),
               std::runtime_error);
  EXPECT_THROW(facts_of("{\"id\":"), std::runtime_error);
  EXPECT_THROW(facts_of(R"({"id":"a","dialect":"d","verdict":"skip","coordinates":{"exact":-1}})"),
               std::runtime_error);
}

}  // namespace
}  // namespace gonogo::oracle
