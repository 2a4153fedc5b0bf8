// SPDX-License-Identifier: GPL-3.0-or-later
//
// The case lines, which are written by hand, against the JSON library.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "campaign/results_reader.hpp"
#include "campaign_testing.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using Json = nlohmann::ordered_json;

CaseResult failed() {
  CaseResult result = passed("a.\x01\"\\\r\n\t\x7f");
  result.clauses = {"GSK-G94-02", "\xe8\xbd\xb4"};
  result.verdict.kind = VerdictKind::fail_geometry;
  result.verdict.clause = 0;
  result.verdict.reading = "k=v";
  result.verdict.block = 2;
  result.verdict.record = 0;
  result.verdict.word = 'X';
  result.verdict.want = R"({"k":"rapid"})";
  result.verdict.got = "\xff no UTF-8";
  result.verdict.deviation_exact = "1/3";
  result.verdict.deviation_mm = "0.333333333";
  result.verdict.witness = R"({"x": "1"})";
  result.verdict.message = "a, b";
  result.mapped = "A";
  result.profile = R"({"readings":{"r":"a b"}})";
  result.program = "G00 (\xbd\xe1)\n";
  result.trace = {R"({"k":"feed","x-n":"\u007f"})", R"({"k":"end"})"};
  result.notes = "\"noise\\\",\"us\":1\n";
  return result;
}

TEST(CaseLine, IsWhatTheJsonLibraryWritesOfIt) {
  for (const CaseResult& result : {failed(), passed("a")}) {
    const std::string line = case_line(result, true);
    EXPECT_EQ(Json::parse(line).dump(), line);
  }
}

TEST(CaseLine, WithoutItsTimesIsWhatTheHashTakes) {
  for (const CaseResult& result : {failed(), passed("a")}) {
    const std::string line = case_line(result, true);
    EXPECT_EQ(line_without_timing(line) + "\n", hashed_text(Json::parse(line)));
    EXPECT_EQ(line_without_timing(line), case_line(result, false));
  }
}

// What a subject writes to stderr comes when it comes.
TEST(CaseLine, WithoutItsTimesHasNoNotes) {
  CaseResult other = failed();
  other.notes = "other";
  EXPECT_TRUE(has(case_line(other, true), "other"));
  EXPECT_EQ(line_without_timing(case_line(other, true)),
            line_without_timing(case_line(failed(), true)));
}

TEST(CaseLine, WithoutItsTimesWhenSomebodyElseWroteIt) {
  EXPECT_EQ(line_without_timing(R"({"id":"a", "attempts":1, "us":3})"), R"({"id":"a"})");
}

TEST(CaseLine, SaysOfAGapWhetherItWasExpected) {
  CaseResult gap = passed("a");
  gap.verdict.kind = VerdictKind::oracle_gap;
  EXPECT_FALSE(has(case_line(gap, false), "expected"));
  gap.expected_gap = true;
  EXPECT_TRUE(has(case_line(gap, false), "\"expected\":true"));
}

// What broke the relation names its rule, what the gauge cannot say its reason; other lines
// neither.
TEST(CaseLine, NamesTheRuleOrTheReasonOfAGap) {
  EXPECT_TRUE(has(case_line(failed(), false), "\"rule\":\"R2\""));
  CaseResult gap = passed("a");
  gap.verdict = gap_verdict(GapReason::samples_hole, "A hole.");
  const std::string line = case_line(gap, false);
  EXPECT_TRUE(has(line, "\"gap\":\"samples-hole\""));
  EXPECT_FALSE(has(line, "\"rule\""));
  const std::string pass = case_line(passed("a"), false);
  EXPECT_FALSE(has(pass, "\"rule\""));
  EXPECT_FALSE(has(pass, "\"gap\""));
}

TEST(CaseLine, OfAKnownFailureKeepsItsRuleMessageAndReason) {
  CaseResult known = failed();
  known.verdict.departure = VerdictKind::fail_feed;
  known.verdict.kind = VerdictKind::xfail;
  known.verdict.known = "a known bug";
  const Json read = Json::parse(case_line(known, false));
  EXPECT_EQ(read["rule"], "R3");
  EXPECT_EQ(read["known"], "a known bug");
  EXPECT_EQ(read["message"], "a, b");
}

}  // namespace
}  // namespace gonogo::oracle
