// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding.hpp"

#include <gtest/gtest.h>

#include "oracle/evidence/causes.hpp"

namespace gonogo::oracle {
namespace {

CaseHead departing(const char* id, const char* clause, std::size_t blocks, const char* want,
                   const char* got) {
  CaseHead head;
  head.id = id;
  head.dialect = "gsk988ta";
  head.cycle = "g94";
  head.clause = clause;
  head.want = want;
  head.got = got;
  head.program_blocks = blocks;
  head.program_bytes = 10 * blocks;
  return head;
}

constexpr const char* kRapid = R"({"k":"rapid","b":1,"to":{"z":"-7"}})";
constexpr const char* kOtherRapid = R"({"k":"rapid","b":1,"to":{"z":"-3"}})";
constexpr const char* kFeed = R"({"k":"feed","b":1,"to":{"z":"-7"},"f":"1"})";

TEST(Findings, cases_that_depart_in_one_way_are_one_finding_with_its_smallest) {
  Findings findings;
  const auto kind = VerdictKind::fail_geometry;
  findings.add(departing("a", "GSK-G94-02", 5, kRapid, kOtherRapid), kind);
  EXPECT_TRUE(findings.is_smallest());
  findings.add(departing("b", "GSK-G94-02", 2, kRapid, kOtherRapid), kind);
  EXPECT_TRUE(findings.is_smallest());
  findings.add(departing("c", "GSK-G94-02", 3, kRapid, kOtherRapid), kind);
  EXPECT_FALSE(findings.is_smallest());
  ASSERT_EQ(findings.list().size(), 1U);
  EXPECT_EQ(findings.list()[0]->line(),
            "3 x fail.geometry at GSK-G94-02 (rapid), smallest: b, 2 blocks");
}

TEST(Findings, a_program_that_is_not_kept_is_no_example_while_there_is_another) {
  Findings findings;
  findings.add(departing("a", "", 0, "", ""), VerdictKind::fail_reading);
  findings.add(departing("b", "", 9, "", ""), VerdictKind::fail_reading);
  EXPECT_EQ(findings.list()[0]->smallest.id, "b");
}

TEST(Findings, kinds_of_record_and_clauses_are_kept_apart) {
  Findings findings;
  const auto kind = VerdictKind::fail_geometry;
  findings.add(departing("a", "GSK-G94-02", 5, kRapid, kOtherRapid), kind);
  findings.add(departing("b", "GSK-G94-02", 5, kFeed, kRapid), kind);
  findings.add(departing("c", "GSK-G94-03", 5, kFeed, kRapid), kind);
  ASSERT_EQ(findings.list().size(), 3U);
  EXPECT_EQ(findings.list()[1]->text(), "fail.geometry at GSK-G94-02 (rapid for feed)");
}

TEST(Findings, a_wrong_path_comes_before_a_wrong_alarm_and_the_smaller_before_the_larger) {
  Findings findings;
  findings.add(departing("alarm", "A", 1, "", ""), VerdictKind::fail_alarm_class);
  findings.add(departing("large", "B", 9, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("small", "C", 2, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("feed", "D", 1, "", ""), VerdictKind::fail_feed);
  std::vector<std::string> order;
  for (const Finding* finding : findings.list()) order.push_back(finding->smallest.id);
  EXPECT_EQ(order, (std::vector<std::string>{"small", "large", "feed", "alarm"}));
}

TEST(Findings, those_of_one_cause_stand_together) {
  Findings findings;
  findings.add(departing("one", "A", 1, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("other", "B", 2, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("alarm", "C", 3, "", ""), VerdictKind::fail_alarm_class);
  findings.set_cause(findings.list()[0]->key, "the sign");
  findings.set_cause(findings.list()[2]->key, "the sign");
  std::vector<std::string> order;
  for (const Finding* finding : findings.list()) order.push_back(finding->smallest.id);
  EXPECT_EQ(order, (std::vector<std::string>{"one", "alarm", "other"}));
}

TEST(Findings, what_is_go_advised_or_expected_is_none) {
  Findings findings;
  CaseHead gap = departing("gap", "", 1, "", "");
  gap.expected = true;
  EXPECT_EQ(findings.add(gap, VerdictKind::oracle_gap), nullptr);
  EXPECT_EQ(findings.add(gap, VerdictKind::pass_exact), nullptr);
  EXPECT_EQ(findings.add(gap, VerdictKind::advice), nullptr);
  EXPECT_EQ(findings.add(gap, VerdictKind::skip), nullptr);
  gap.expected = false;
  EXPECT_NE(findings.add(gap, VerdictKind::oracle_gap), nullptr);
}

// A subject that breaks down in another way each time must not take memory without bound.
TEST(Findings, further_kinds_are_counted_as_one) {
  Findings findings;
  for (char first = 'a'; first <= 'z'; ++first) {
    for (char second = 'a'; second <= 'z'; ++second) {
      CaseHead head = departing("x", "", 1, "", "");
      head.message = std::string{first, second};
      findings.add(head, VerdictKind::crash);
    }
  }
  EXPECT_EQ(findings.list().size(), 201U);
}

TEST(CaseHeads, count_the_blocks_of_a_program_in_text_and_in_base64) {
  CaseHead head;
  ASSERT_TRUE(read_case_head(R"({"id":"a","program":"G0 X1\n\n  \nG1 X2\r\nM30"})", head));
  EXPECT_EQ(head.program_blocks, 3U);
  EXPECT_EQ(head.program_bytes, 20U);
  // "G0\nG1\n" in base64
  ASSERT_TRUE(read_case_head(R"({"id":"a","program":{"base64":"RzAKRzEK"}})", head));
  EXPECT_EQ(head.program_blocks, 2U);
  ASSERT_TRUE(read_case_head(R"({"id":"a"})", head));
  EXPECT_EQ(head.program_blocks, 0U);
}

TEST(Causes, are_kept_beside_the_results_and_gone_with_the_next_run) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "gonogo-causes";
  std::filesystem::create_directories(folder);
  const evidence::Causes causes = {
      {{gravity(VerdictKind::fail_feed), VerdictKind::fail_feed, "rs274", "NGC-1", "feed/feed"},
       "F is \xC3\xA4"}};
  evidence::write_causes(folder, causes);
  EXPECT_EQ(evidence::read_causes(folder), causes);
  evidence::write_causes(folder, {});
  EXPECT_TRUE(evidence::read_causes(folder).empty());
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gonogo::oracle
