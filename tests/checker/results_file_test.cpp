// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results files that are broken in one way each.
#include <gtest/gtest.h>

#include "tests/checker/workshop.hpp"
#include "tests/has.hpp"

namespace gonogo::checker {
namespace {

// Of a results file with one change.
void expect_of_results(const std::string& from, const std::string& to, int exit_code,
                       const std::string& sentence) {
  Workshop shop;
  shop.change_results(from, to);
  expect_said(shop, exit_code, sentence);
}

TEST(CheckerVerdicts, AHashThatIsNotThatOfTheLinesIsNoticed) {
  expect_of_results(R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny")",
                    R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tinx")", 1,
                    "the case lines have the SHA-256");
}

TEST(CheckerVerdicts, TimesAreNotHashed) {
  expect_of_results(
      R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny","features":["basic"],"clauses":["NGC-G0-01"],"verdict":"pass-exact","us":17)",
      R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny","features":["basic"],"clauses":["NGC-G0-01"],"verdict":"pass-exact","us":99)",
      0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, ACaseThatIsMissingIsNoticed) {
  Workshop shop;
  shop.drop_line(kArcCase);
  expect_said(shop, 3, "1 cases that were asked for are not there, " + kArcCase);
}

TEST(CheckerVerdicts, ACaseThatTheCorpusDoesNotHaveIsNoticed) {
  Workshop shop;
  shop.change_lines("tiny.arc.000001", "tiny.arc.000002");
  expect_said(shop, 1, "The corpus has no such case.");
}

TEST(CheckerVerdicts, TotalsThatAreNotThoseOfTheLinesAreNoticed) {
  expect_of_results(R"("pass-exact":3)", R"("pass-exact":4)", 1, "The totals of the footer");
}

TEST(CheckerVerdicts, ADecisionThatTheLinesDoNotMakeIsNoticed) {
  expect_of_results(R"("decision":"GO")", R"("decision":"NO-GO")", 1, "the lines make it GO");
}

TEST(CheckerVerdicts, AFileWithoutItsFooterIsIncomplete) {
  Workshop shop;
  shop.change_results(R"({"decision":)", R"({"id":"z","decision":)");
  EXPECT_EQ(shop.check_verdicts().exit_code, 2);
}

TEST(CheckerVerdicts, AnotherCorpusIsNoticed) {
  expect_of_results(R"("corpus":{"version":"2026.1.0","sha256":")",
                    R"("corpus":{"version":"2026.1.0","sha256":"0)", 1, "another corpus");
}

TEST(CheckerVerdicts, ALineUnderAnotherProfileIsNoticed) {
  Workshop shop;
  shop.change_lines(R"("id":"tiny.arc.000001","dialect":"rs274",)",
                    R"("id":"tiny.arc.000001","dialect":"rs274","profile":{"units":"inch"},)");
  expect_said(shop, 1, "under another profile");
}

TEST(CheckerVerdicts, ATraceThatIsNoneIsNoticed) {
  Workshop shop;
  shop.set_trace(kArcCase, R"({"k":"rapid","b":1,"to":{"x":10}})");
  expect_said(shop, 1, "stands in quotes");
}

TEST(CheckerVerdicts, AKnownFailureOfARunWithoutThemIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "xfail");
  expect_said(shop, 1, "It is xfail, and the run had no known failures.");
}

TEST(CheckerVerdicts, AKnownFailureMustFail) {
  Workshop shop;
  shop.change_results(R"("chord":null)", R"("chord":null,"known_failures":"ab")");
  shop.change_results(R"(["certify"])", R"(["certify","--known-failures","k"])");
  shop.set_verdict(kLineCase, "xfail");
  expect_said(shop, 1, "differs  " + kLineCase + ": The file says xfail; derived: GO.");
}

// J-RUN-13: it reads no file of known failures.
TEST(CheckerVerdicts, WhatAKnownFailureMakesOfACaseIsUnproven) {
  Workshop shop;
  shop.change_results(R"("chord":null)", R"("chord":null,"known_failures":"ab")");
  shop.change_results(R"(["certify"])", R"(["certify","--known-failures","k"])");
  expect_said(shop, 3, "Which passes are known to fail was not derived.");
  shop.depart();
  shop.set_verdict(kLineCase, "xfail");
  expect_said(shop, 3, "1  xfail: departs, but known failures are not read here");
}

TEST(CheckerVerdicts, AKnownFailureWithoutItsEvidenceIsNoticed) {
  for (const char* key : {"\"program\":", "\"trace\":"}) {
    Workshop shop;
    shop.change_results(R"("chord":null)", R"("chord":null,"known_failures":"ab")");
    shop.change_results(R"(["certify"])", R"(["certify","--known-failures","k"])");
    shop.depart();
    shop.set_verdict(kLineCase, "xfail");
    shop.change_lines(key, "\"notes\":");
    expect_said(shop, 1, std::string("The line has no ") + (key[1] == 'p' ? "program" : "trace"));
  }
}

TEST(CheckerVerdicts, AHeadLineThatTheLinesDoNotMakeIsNoticed) {
  const auto with_head = [](Workshop& shop, const std::string& head) {
    shop.change_results(R"("assignments":[])", R"("assignments":[],"head":")" + head + "\"");
  };
  Workshop honest;
  with_head(honest, "GO for basic of rs274: 3 judged; sandbox: none");
  expect_said(honest, 0, "3 verdicts derived again");
  for (const char* head : {"GO for basic of rs274: 18,000 judged", "NO-GO: 3 judged",
                           "UNDECIDED: 3 judged", "GO for basic of rs274: 13 judged"}) {
    Workshop shop;
    with_head(shop, head);
    expect_said(shop, 1, "The head line of the footer does not say GO and 3 judged.");
  }
}

// Their answers are in no file, so that this changes no exit code.
TEST(CheckerVerdicts, FreshProgramsAreToldAsNotShown) {
  expect_of_results(R"("assignments":[])",
                    R"("assignments":[],"fresh":{"rs274":{"wanted":3,"programs":2,"judged":2}})", 0,
                    "No line shows what the subject did with 2 fresh programs of rs274.");
}

TEST(CheckerVerdicts, ASkippedCaseWithATraceIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "skip");
  expect_said(shop, 1, "It was skipped, but there is a trace of it.");
}

// J-RUN-13: nobody but the subject knows why it skips what it never said that it has.
TEST(CheckerVerdicts, ASkippedCaseOfASubjectThatDeclaresNothingIsUnproven) {
  Workshop shop;
  shop.set_verdict(kLineCase, "skip");
  shop.drop_trace(kLineCase);
  expect_said(shop, 3, "1  skipped: only the subject can say why");
}

TEST(CheckerVerdicts, ASkippedCaseOfDeclaredFeaturesIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "skip");
  shop.drop_trace(kLineCase);
  shop.change_results(R"("features":["blocks","m"])",
                      R"("features":["blocks","m"],"dialects":{"rs274":["basic"]})");
  expect_said(shop, 1, "It was skipped, though the subject declares all that it needs.");
}

TEST(CheckerVerdicts, ACaseOfAFeatureThatIsNotDeclaredHasToBeSkipped) {
  expect_of_results(R"("features":["blocks","m"])",
                    R"("features":["blocks","m"],"dialects":{"rs274":["arc"]})", 1,
                    "The subject does not declare basic: such a case is skipped.");
}

TEST(CheckerVerdicts, AVersionOfTheCorpusThatIsAnotherIsNoticed) {
  expect_of_results(R"("corpus":{"version":"2026.1.0")", R"("corpus":{"version":"2025.1.0")", 1,
                    "The run names another version of the corpus");
}

TEST(CheckerVerdicts, AnExpectedGapThatTheCorpusDoesNotExpectIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "oracle-gap");
  shop.change_lines(R"("verdict":"oracle-gap")", R"("verdict":"oracle-gap","expected":true)");
  expect_said(shop, 1, "The line says that the corpus expects an oracle-gap, and it does not.");
}

TEST(CheckerVerdicts, AHeaderThatIsNotItsCommandLineIsNoticed) {
  expect_of_results(R"("argv":["certify"])", R"("argv":["certify","--tolerance","1"])", 1,
                    "The header and its command line differ in --tolerance.");
}

TEST(CheckerVerdicts, AHeaderWithoutACommandLineIsNoticed) {
  expect_of_results(R"("argv":["certify"])", R"("argv":[])", 1,
                    "The header names no command line that runs a campaign.");
}

// J-RUN-13: each shard of a merged run has its command line.
TEST(CheckerVerdicts, AMergedHeaderIsThatOfEachOfItsShards) {
  const auto merged = [](const std::string& second) {
    return R"("argv":["merge","a","b"],"shards":[)"
           R"({"shard":"1/2","seed":7,"argv":["certify","--shard","1/2"],"fresh":{}})" +
           second + "]";
  };
  const auto shard = [](const std::string& words) {
    return R"(,{"shard":"2/2","seed":8,"argv":["certify","--shard","2/2")" + words +
           R"(],"fresh":{}})";
  };
  const std::string own = R"("argv":["certify"])";
  expect_of_results(own, merged(shard("")), 0, "3 verdicts derived again");
  expect_of_results(own, merged(shard(R"(,"--tolerance","5")")), 1, "differ in --tolerance.");
  expect_of_results(own, merged(""), 1, "Shard 1/1 is not in its place.");
  expect_of_results(own, R"("argv":["merge","a","b"])", 1, "A merged run names its shards");
}

// Values are compared, not their spelling.
TEST(CheckerVerdicts, AFlagMayBeSetWithAValue) {
  const auto strict_by = [](const std::string& word) {
    return R"("strict":true,"argv":["certify",")" + word + "\"]";
  };
  for (const char* word : {"--strict", "--strict=true", "--strict=1", "--strict=ON"}) {
    expect_of_results(R"("argv":["certify"])", strict_by(word), 0, "3 verdicts derived again");
  }
  for (const char* word : {"--strict=false", "--strict=0", "--strict=no", "--strict=-1"}) {
    expect_of_results(R"("argv":["certify"])", strict_by(word), 1,
                      "The header and its command line differ in --strict.");
  }
}

TEST(CheckerVerdicts, AFeedToleranceOrNamesOfCasesThatTheHeaderDoesNotSayAreNoticed) {
  const auto with = [](const std::string& words, const std::string& header) {
    Workshop shop;
    shop.change_results(R"("argv":["certify"])", header + R"("argv":["certify",)" + words + "]");
    return shop.check_verdicts();
  };
  EXPECT_TRUE(has(with(R"("--feed-tolerance","300")", "").text, "differ in --feed-tolerance."));
  EXPECT_TRUE(has(with(R"("--show-ids")", "").text, "differ in --show-ids."));
  EXPECT_EQ(with(R"("--feed-tolerance","300.0","--show-ids")",
                 R"("feed_tolerance":"300","show_ids":true,)")
                .exit_code,
            0);
}

// It passes under its readings, and so it counts for those of the run.
TEST(CheckerVerdicts, AKnownContradictionThatPassesLeavesItsReadings) {
  Workshop shop;
  shop.set_verdict(kLineCase, "xpass");
  shop.change_lines(R"("attempts":1,"program")",
                    R"("attempts":1,"readings":{"open":["ngc.bare-motion"],)"
                    R"("explaining":["ngc.bare-motion=any"],"verdict":"pass-exact",)"
                    R"("known":"a reason"},"program")");
  shop.change_results(R"("assignments":[])", R"("assignments":["ngc.bare-motion=any"])");
  expect_said(shop, 0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, MoreCasesLeftOutThanTheProfileDoesAreNoticed) {
  Workshop shop;
  shop.drop_line(kLineCase);
  shop.change_results(R"("assignments":[])", R"("left_out":1,"assignments":[])");
  expect_said(shop, 3, "1 cases that were asked for are not there");
}

TEST(CheckerVerdicts, WithoutLineNumbersAnAlarmIsJudgedByItsClass) {
  Workshop shop;
  shop.change_results(R"("features":["blocks","m"])", R"("features":["m"])");
  shop.change_trace(kAlarmCase, R"({"k":"alarm","b":2)", R"({"k":"alarm","b":3)");
  expect_said(shop, 0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, FreshProgramsThatNobodyAskedForAreNoticed) {
  Workshop shop;
  shop.change_results(R"("assignments":[])",
                      R"("assignments":[],"fresh":{"rs274":{"wanted":3,"programs":2,"judged":2}})");
  shop.change_results(R"(["certify"])", R"(["certify","--fresh","0"])");
  expect_said(shop, 1, "There are fresh programs, and the command line asks for none.");
}

}  // namespace
}  // namespace gonogo::checker
