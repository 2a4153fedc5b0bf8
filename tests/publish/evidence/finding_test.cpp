// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/finding.hpp"

#include <gtest/gtest.h>

#include "oracle/records/cycle_table.hpp"
#include "oracle/records/finding_text.hpp"
#include "publish/evidence/causes.hpp"

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

// What the next motion is, or which other alarm is due, has nothing to do with it.
TEST(Findings, one_class_of_alarm_that_is_not_due_is_one_finding) {
  Findings findings;
  const char* const alarm = R"({"k":"alarm","class":"missing-word","b":3})";
  const char* const other = R"({"class":"value-sign","b":3})";
  findings.add(departing("a", "NGC-CYC-12", 2, kRapid, alarm), VerdictKind::fail_alarm_spurious);
  EXPECT_EQ(findings.list()[0]->text(),
            "fail.alarm-spurious at NGC-CYC-12 (missing-word for rapid)");
  findings.add(departing("b", "NGC-CYC-12", 3, kFeed, alarm), VerdictKind::fail_alarm_spurious);
  findings.add(departing("c", "NGC-CYC-11", 4, kFeed, alarm), VerdictKind::fail_alarm_spurious);
  findings.add(departing("d", "NGC-CYC-22", 5, other, alarm), VerdictKind::fail_alarm_class);
  ASSERT_EQ(findings.list().size(), 1U);
  EXPECT_EQ(findings.list()[0]->line(),
            "3 x fail.alarm-spurious, 1 x fail.alarm-class (not due: missing-word), smallest: a, 2 "
            "blocks");
  EXPECT_EQ(findings.list()[0]->text(),
            "fail.alarm-spurious and fail.alarm-class (not due: missing-word)");
  findings.add(departing("e", "NGC-CYC-22", 5, alarm, other), VerdictKind::fail_alarm_class);
  EXPECT_EQ(findings.list().size(), 2U);
}

// The table of verdicts beside it counts the same cases.
TEST(Findings, a_heading_names_no_verdict_that_none_of_its_cases_has) {
  Findings findings;
  const char* const alarm = R"({"k":"alarm","class":"missing-word","b":3})";
  const char* const due = R"({"class":"value-sign","b":3})";
  findings.add(departing("a", "NGC-CYC-22", 5, due, alarm), VerdictKind::fail_alarm_class);
  findings.add(departing("b", "NGC-CYC-22", 6, due, alarm), VerdictKind::fail_alarm_class);
  ASSERT_EQ(findings.list().size(), 1U);
  EXPECT_EQ(
      findings.list()[0]->line(),
      "2 x fail.alarm-class at NGC-CYC-22 (missing-word for value-sign), smallest: a, 5 blocks");
}

TEST(Findings, motions_of_a_block_that_is_over_are_one_finding) {
  Findings findings;
  const auto kind = VerdictKind::fail_geometry;
  const char* const next_rapid = R"({"k":"rapid","b":2,"to":{"z":"-7"}})";
  const char* const next_feed = R"({"k":"feed","b":3,"to":{"z":"-7"},"f":"1"})";
  findings.add(departing("a", "GSK-G94-02", 5, next_rapid, kOtherRapid), kind);
  findings.add(departing("b", "GSK-G00-01", 5, next_feed, kOtherRapid), kind);
  findings.add(departing("c", "GSK-G94-02", 5, kRapid, kOtherRapid), kind);
  ASSERT_EQ(findings.list().size(), 2U);
  EXPECT_EQ(findings.list()[0]->text(), "fail.geometry (of an earlier block: rapid)");
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

TEST(Findings, a_feed_for_a_traverse_comes_behind_a_wrong_place_and_a_traverse_for_a_feed) {
  Findings findings;
  const auto kind = VerdictKind::fail_geometry;
  findings.add(departing("label", "A", 1, kRapid, kFeed), kind);
  findings.add(departing("place", "B", 3, kFeed, kFeed), kind);
  findings.add(departing("traverse", "C", 2, kFeed, kRapid), kind);
  std::vector<std::string> order;
  for (const Finding* finding : findings.list()) order.push_back(finding->smallest.id);
  EXPECT_EQ(order, (std::vector<std::string>{"traverse", "place", "label"}));
}

CaseHead broken_down(const char* id, const char* message) {
  CaseHead head = departing(id, "", 1, "", "");
  head.message = message;
  return head;
}

TEST(Findings, a_breakdown_keeps_its_numbers_while_all_cases_say_the_same) {
  Findings findings;
  findings.add(broken_down("a", "It ended by signal 11 after \"G94 X1\"."), VerdictKind::crash);
  findings.add(broken_down("b", "It ended by signal 11 after \"G94 X1\"."), VerdictKind::crash);
  ASSERT_EQ(findings.list().size(), 1U);
  EXPECT_EQ(findings.list()[0]->text(), "crash (It ended by signal 11 after \"G94 X1\".)");
  findings.add(broken_down("c", "It ended by signal 6 after \"G80\"."), VerdictKind::crash);
  ASSERT_EQ(findings.list().size(), 1U);
  EXPECT_EQ(findings.list()[0]->text(), "crash (It ended by signal ... after \"...\".)");
}

TEST(Findings, those_of_one_cause_stand_together) {
  Findings findings;
  findings.add(departing("one", "A", 1, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("other", "B", 2, "", ""), VerdictKind::fail_geometry);
  findings.add(departing("alarm", "C", 3, "", ""), VerdictKind::fail_alarm_class);
  findings.set_cause(findings.list()[0]->key, {"the sign", ""});
  findings.set_cause(findings.list()[2]->key, {"the sign", ""});
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

TEST(FindingText, steps_are_told_as_people_write_them) {
  EXPECT_EQ(want_and_got(kRapid, kOtherRapid), "want rapid Z-7 / got rapid Z-3");
  EXPECT_EQ(want_and_got(kFeed, ""), "want feed Z-7 F1 / got nothing");
  EXPECT_EQ(short_step(R"({"k":"alarm","class":"taper-limit","b":2,"word":"R"})"),
            "alarm taper-limit of R in line 2");
  EXPECT_EQ(short_step(R"({"k":"alarm","b":3,"any_of":["syntax","not-an-integer"]})"),
            "alarm syntax or not-an-integer in line 3");
  EXPECT_EQ(short_step("end"), "end");
  EXPECT_EQ(short_step(R"({"k":"level","b":2,"plane":"G17","centre":{"x":"10","y":"5","z":"-2"},)"
                       R"("pocket_radius":"6","step":"4","f":"200","rot":"-","clause":"GSK-1"})"),
            "a layer in G17 about X10 Y5 Z-2 pocket radius 6 step 4 F200 clockwise");
  EXPECT_EQ(want_and_got("", ""), "");
}

TEST(FindingText,
     a_step_says_which_way_round_and_in_which_plane_and_a_line_only_where_two_are_named) {
  EXPECT_EQ(
      want_and_got(
          R"({"k":"arc","b":2,"plane":"G18","c":{"x":"1","z":"7/3"},"rot":-1,"to":{"x":"1"},"f":"9"})",
          R"({"k":"arc","b":2,"plane":"G18","c":{"x":"1","z":"2"},"rot":3,"to":{"x":"1"},"f":"9","fm":"rev"})"),
      "want arc X1 in G18 about X1 Z2.333333333... clockwise F9 / "
      "got arc X1 in G18 about X1 Z2 counterclockwise in 3 turns F9 a revolution");
  EXPECT_EQ(want_and_got(R"({"k":"m","b":3,"m":2})", R"({"k":"m","b":2,"m":2})"),
            "want M2 in line 3 / got M2 in line 2");
}

// 0.25 times the root of 73 is 2.136000936...; the root of 2 is 1.414213562...
TEST(FindingText, a_root_or_an_enclosure_is_a_decimal_wherever_it_stands) {
  const std::string lead = R"({"root":["0","0.25","73"]})";
  const std::string root = R"({"root":["0","1","2"]})";
  const std::string between = R"({"enclosure":["1.4142135623730949","1.4142135623730951"]})";
  EXPECT_EQ(
      short_step(R"({"k":"thread","b":2,"to":{"x":"20"},"lead":)" + lead + R"(,"start":"0"})"),
      "thread X20 lead 2.136000936... start 0");
  EXPECT_EQ(
      short_step(R"({"k":"thread","to":{"x":)" + root + R"(},"lead":"1","start":)" + between + "}"),
      "thread X1.414213562... lead 1 start 1.414213562...");
  EXPECT_EQ(short_step(R"({"k":"dwell","s":)" + between + "}"), "dwell s 1.414213562...");
  EXPECT_EQ(short_step(R"({"k":"feed","to":{"a":"9"},"f":)" + root + "}"),
            "feed A9 F1.414213562...");
  EXPECT_EQ(short_step(R"({"k":"level","centre":{"x":)" + between + R"(},"step":)" + root + "}"),
            "a layer about X1.414213562... step 1.414213562...");
}

// All that a finding has, in one order for all who tell it.
TEST(FindingText, has_what_the_case_is_about_its_machine_the_block_both_steps_and_what_to_do) {
  FindingFacts facts;
  facts.comment = "a taper";
  facts.profile = R"({"units":"inch"})";
  facts.blocks = marked_blocks("G0 X1\nG94 X2\n", 2);
  facts.want = kRapid;
  facts.got = kOtherRapid;
  facts.message = "It ends early.";
  facts.rule = "R4";
  facts.clause = "GSK-NONE";
  facts.block = 2;
  facts.deviation_exact = "1/3";
  facts.deviation_mm = "0.333333333";
  facts.next = "gonogo certify --case a";
  EXPECT_EQ(finding_text(facts, "  "),
            "  about      a taper\n"
            "  machine    units inch\n"
            "  1 | G0 X1\n"
            "  2 | G94 X2\n"
            "    | ^^^^^^\n"
            "  want rapid Z-7 / got rapid Z-3\n"
            "  It ends early.\n"
            "  rule       R4 (traverse)\n"
            "  clause     GSK-NONE\n"
            "  deviation  0.333333333 mm (exactly 1/3)\n"
            "  again      gonogo certify --case a\n");
}

TEST(FindingText, a_deviation_is_told_exactly_where_that_is_short) {
  FindingFacts facts;
  facts.deviation_mm = "0.333333333";
  facts.deviation_exact = "1/3";
  EXPECT_EQ(deviation_text(facts), "0.333333333 mm (exactly 1/3)");
  facts.deviation_exact = "1000000000000001/3000000000000001";
  EXPECT_EQ(deviation_text(facts), "0.333333333 mm");
  facts.deviation_exact = R"({"root":["6","-0.001","30254578"]})";
  EXPECT_EQ(deviation_text(facts), "0.333333333 mm");
}

TEST(FindingText, the_block_that_departs_is_marked) {
  EXPECT_EQ(marked_blocks("G0 X1\r\nG94 X2\nM30\nM2\n", 2),
            "1 | G0 X1\n2 | G94 X2\n  | ^^^^^^\n3 | M30\n");
  EXPECT_EQ(marked_blocks("G0\n", 0), "1 | G0\n");
  EXPECT_EQ(marked_blocks("G0\nG1\n\n\nG2\nG3\nG4\n", 0),
            "1 | G0\n2 | G1\n3 | \n4 | \n5 | G2\n6 | ...\n");
  EXPECT_EQ(marked_blocks("G0\n", 2), "");
  EXPECT_EQ(marked_blocks("\xE4\n", 1), "1 | ?\n  | ^\n");
}

TEST(FindingText, the_machine_is_told_where_it_is_not_the_default) {
  EXPECT_EQ(other_machine("{}"), "");
  EXPECT_EQ(other_machine(R"({"units":"inch","initial":{"feed":"5"},"readings":{"a.b":"c"}})"),
            "units inch; initial.feed 5; a.b c");
}

// Five cases of two cycles, each counted once.
TEST(CycleTable, counts_every_case_once_and_shows_first_what_fails) {
  RunScope scope;
  const auto add = [&](const char* cycle, VerdictKind kind, bool expected = false) {
    CaseHead head = departing("a", "", 1, "", "");
    head.cycle = cycle;
    head.expected = expected;
    scope.add(head, kind);
  };
  add("g90", VerdictKind::pass_exact);
  add("g94", VerdictKind::fail_geometry);
  add("g94", VerdictKind::pass_exact);
  add("g94", VerdictKind::oracle_gap, true);
  add("g112", VerdictKind::skip);
  const CycleTable table = cycle_table(scope);
  ASSERT_EQ(table.rows.size(), 2U);
  const std::string counting =
      "  The table counts a case once; the head line counts it for each feature it needs.\n";
  EXPECT_EQ(table.text(20),
            "  cycle  judged      GO   NO-GO  not covered\n"
            "  g94         2       1       1            1\n"
            "  g90         1       1       0            0\n"
            "  nothing judged: g112 1\n" +
                counting);
  EXPECT_EQ(table.text(1),
            "  cycle  judged      GO   NO-GO  not covered\n"
            "  g94         2       1       1            1\n"
            "  and 1 more\n"
            "  nothing judged: g112 1\n" +
                counting);
  EXPECT_EQ(scope.judged() + scope.skipped() + scope.undecided() + scope.known() + scope.advised() +
                scope.not_covered(),
            5U);
}

// All cases are of one cycle: the head line has the same numbers.
TEST(CycleTable, of_one_row_says_nothing_of_how_it_counts) {
  RunScope scope;
  CaseHead head = departing("a", "", 1, "", "");
  head.cycle = "g90";
  scope.add(head, VerdictKind::pass_exact);
  EXPECT_EQ(cycle_table(scope).text(20).find("counts"), std::string::npos);
}

// By gravity a feed of G90 comes behind a path of G94; by cycle it comes before.
TEST(Findings, are_told_by_gravity_or_by_cycle) {
  Findings findings;
  const auto add = [&](const char* id, const char* cycle, VerdictKind kind) {
    CaseHead head = departing(id, "GSK-1", 1, "", "");
    head.cycle = cycle;
    head.verdict = name(kind);
    findings.add(head, kind);
  };
  add("b", "g94", VerdictKind::fail_geometry);
  add("a", "g90", VerdictKind::fail_feed);
  EXPECT_EQ(findings.list().front()->cycle(), "g94");
  EXPECT_EQ(findings.list(Findings::Order::cycle).front()->cycle(), "g90");
}

TEST(Causes, are_kept_beside_the_results_and_gone_with_the_next_run) {
  const auto folder = std::filesystem::path(::testing::TempDir()) / "gonogo-causes";
  std::filesystem::create_directories(folder);
  const Finding::Key key{gravity(VerdictKind::fail_feed), VerdictKind::fail_feed, "rs274", "NGC-1",
                         "feed/feed"};
  evidence::write_causes(folder, {{{key, {"F is \xC3\xA4", "It explains all."}}}, 3});
  const evidence::Causes read = evidence::read_causes(folder);
  ASSERT_EQ(read.of.size(), 1U);
  EXPECT_EQ(read.of.at(key).text(), "Behaves as if: F is \xC3\xA4. It explains all.");
  EXPECT_EQ(read.asked, 3U);
  evidence::write_causes(folder, {});
  EXPECT_TRUE(evidence::read_causes(folder).of.empty());
  std::filesystem::remove_all(folder);
}

// Data count records from 0 (docs/formats.md); people count them as they count lines.
TEST(FindingText, the_first_record_is_number_1) {
  Verdict verdict;
  verdict.record = 0;
  EXPECT_NE(finding_text(finding_facts(verdict), "").find("record     1\n"), std::string::npos);
  EXPECT_EQ(record_number(std::nullopt), "");
}

}  // namespace
}  // namespace gonogo::oracle
