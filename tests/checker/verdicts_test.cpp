// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results and traces that are broken in one way each.
#include <gtest/gtest.h>

#include "tests/checker/workshop.hpp"

namespace gonogo::checker {
namespace {

const std::string kLineCase = "tiny.line.000001";
const std::string kArcCase = "tiny.arc.000001";
const std::string kAlarmCase = "tiny.alarm.000001";

void expect_said(Workshop& shop, int exit_code, const std::string& sentence) {
  const Said said = shop.check_verdicts();
  EXPECT_EQ(said.exit_code, exit_code) << said.text;
  EXPECT_NE(said.text.find(sentence), std::string::npos) << said.text;
}

void expect_differs(const std::string& id, const std::string& from, const std::string& to,
                    const std::string& sentence) {
  Workshop shop;
  shop.change_trace(id, from, to);
  expect_said(shop, 1, "differs  " + id + ": The file says pass-exact; derived: NO-GO. ");
  expect_said(shop, 1, sentence);
}

TEST(CheckerVerdicts, WhatIsWholeAgrees) {
  Workshop shop;
  expect_said(shop, 0, "3 cases: 3 verdicts derived again (3 GO, 0 NO-GO, 0 not covered)");
}

TEST(CheckerVerdicts, AGoThatIsNoneIsNoticed) {
  expect_differs(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"2.0011"},"f")", "the line");
}

TEST(CheckerVerdicts, WithinTheToleranceIsNoDeparture) {
  Workshop shop;
  // rs274 has the resolution 0.0001, which is smaller than the declared 0.001.
  shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"2.0001"},"f")");
  expect_said(shop, 0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, OneUnitBeyondTheToleranceIsADeparture) {
  expect_differs(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"2.00010000001"},"f")",
                 "Record 1");
}

TEST(CheckerVerdicts, ANoGoThatIsNoneIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "fail.geometry");
  expect_said(shop, 1, "differs  " + kLineCase + ": The file says fail.geometry; derived: GO.");
}

TEST(CheckerVerdicts, ANoGoThatIsOneAgrees) {
  Workshop shop;
  shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")");
  shop.set_verdict(kLineCase, "fail.geometry");
  expect_said(shop, 0, "3 verdicts derived again (2 GO, 1 NO-GO, 0 not covered)");
}

// J-RUN-04: an advice departs, and changes no decision.
// No text states the line.
void make_silent(Workshop& shop) {
  const std::string line = R"("program":"G0 X1\nG1 Y2 F100\nM3\n","expect":[{"basis":)";
  shop.change_vectors(line + R"("text")", line + R"("silent")");
}

TEST(CheckerVerdicts, AnAdviceDepartsAndIsNoNoGo) {
  Workshop shop;
  make_silent(shop);
  shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")");
  shop.set_verdict(kLineCase, "advice");
  expect_said(shop, 0, "3 verdicts derived again (2 GO, 1 NO-GO, 0 not covered)");
}

TEST(CheckerVerdicts, AnAdviceWhereATextStatesTheExpectationIsNoticed) {
  Workshop shop;
  shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")");
  shop.set_verdict(kLineCase, "advice");
  expect_said(shop, 1, "differs  " + kLineCase + ": The file says advice; a text states");
}

TEST(CheckerVerdicts, AnAdviceThatDoesNotDepartIsNoticed) {
  Workshop shop;
  make_silent(shop);
  shop.set_verdict(kLineCase, "advice");
  expect_said(shop, 1, "differs  " + kLineCase + ": The file says advice; derived: GO.");
}

TEST(CheckerVerdicts, AFeedOffByOneInTheLastPlaceIsADeparture) {
  expect_differs(kLineCase, R"("f":"100")", R"("f":"100.000000001")", "feed");
}

TEST(CheckerVerdicts, AFeedThatIsRoundedAsGrantedIsNone) {
  Workshop shop;
  shop.change_vectors(R"("f":"100"})", R"("f":"100.04"})");
  shop.change_results(R"("chord":null)", R"("chord":null,"feed_resolution":"0.1")");
  expect_said(shop, 0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, AFeedThatIsRoundedTheOtherWayIsADeparture) {
  Workshop shop;
  shop.change_vectors(R"("f":"100"})", R"("f":"100.06"})");
  shop.change_results(R"("chord":null)", R"("chord":null,"feed_resolution":"0.1")");
  expect_said(shop, 1, "differs  " + kLineCase);
}

// J-RUN-02: declared, it counts up to the machine's 0.001 only.
TEST(CheckerVerdicts, AFeedThatIsRoundedMoreCoarselyThanTheMachineIsADeparture) {
  Workshop shop;
  shop.change_vectors(R"("f":"100"})", R"("f":"100.04"})");
  shop.change_results(R"("resolution":"0.001")", R"("resolution":"0.001","feed_resolution":"0.1")");
  expect_said(shop, 1, "differs  " + kLineCase);
}

TEST(CheckerVerdicts, AnAlarmOneLineLateIsNoticed) {
  expect_differs(kAlarmCase, R"({"k":"alarm","b":2)", R"({"k":"alarm","b":3)",
                 "The alarm is feed-missing in line 3 for feed-missing in line 2.");
}

TEST(CheckerVerdicts, AnAlarmOfAnotherClassIsNoticed) {
  expect_differs(kAlarmCase, "feed-missing", "arc-radius", "The alarm is arc-radius");
}

TEST(CheckerVerdicts, AnAlarmOfSeveralClassesIsRightWhereOneIs) {
  Workshop shop;
  shop.change_trace(kAlarmCase, "feed-missing", "arc-radius feed-missing");
  expect_said(shop, 0, "3 verdicts derived again");
  expect_differs(kAlarmCase, "feed-missing", "arc-radius lead-missing", "The alarm is arc-radius");
}

TEST(CheckerVerdicts, AnAlarmThatIsMissingIsNoticed) {
  expect_differs(kAlarmCase, R"({"k":"alarm","b":2,"class":"feed-missing"})", "",
                 "The alarm is missing");
}

TEST(CheckerVerdicts, MotionOfTheAlarmsLineIsNoticed) {
  expect_differs(kAlarmCase, R"({"k":"alarm")",
                 R"({"k":"feed","b":2,"to":{"y":"2"},"f":"1"})"
                 "\n"
                 R"({"k":"alarm")",
                 "One motion too many");
}

TEST(CheckerVerdicts, AnAlarmWhereNoneMustComeIsNoticed) {
  expect_differs(kArcCase, R"("f":"50"})",
                 R"("f":"50"})"
                 "\n"
                 R"({"k":"alarm","b":2,"class":"arc-radius"})",
                 "none must come");
}

TEST(CheckerVerdicts, AnArcTheOtherWayIsNoticed) {
  expect_differs(kArcCase, R"("rot":-1)", R"("rot":1)", "the senses differ");
}

TEST(CheckerVerdicts, AnArcWithATurnTooManyIsNoticed) {
  expect_differs(kArcCase, R"("rot":-1)", R"("rot":-2)", "the turns differ");
}

TEST(CheckerVerdicts, ACentreThatIsOffIsNoticed) {
  expect_differs(kArcCase, R"("c":{"x":"0","y":"0"})", R"("c":{"x":"0.01","y":"0"})",
                 "the centres differ");
}

TEST(CheckerVerdicts, AMotionOfAnotherLineIsNoticed) {
  expect_differs(kLineCase, R"({"k":"feed","b":2)", R"({"k":"feed","b":1)", "source lines differ");
}

TEST(CheckerVerdicts, ATraverseForACutIsNoticed) {
  expect_differs(kLineCase, R"({"k":"rapid","b":1,"to":{"x":"1"}})",
                 R"({"k":"feed","b":1,"to":{"x":"1"},"f":"100"})", "the kinds differ");
}

TEST(CheckerVerdicts, AnMFunctionThatIsMissingIsNoticed) {
  expect_differs(kLineCase, R"({"k":"m","b":3,"m":3})", "", "The M functions are not");
}

TEST(CheckerVerdicts, AnMFunctionAmongTheMotionsOfAnotherLineIsNoticed) {
  const std::string feed = R"({"k":"feed","b":2,"to":{"y":"2"},"f":"100"})";
  const std::string function = R"({"k":"m","b":3,"m":3})";
  expect_differs(kLineCase, feed + "\n" + function, function + "\n" + feed,
                 "An M function of line 3 stands among the motions of line 2.");
}

TEST(CheckerVerdicts, AnEndElsewhereIsNoticed) {
  expect_differs(kLineCase, R"("to":{"x":"1","y":"2"}})", R"("to":{"x":"1","y":"3"}})",
                 "The end is at");
}

TEST(CheckerVerdicts, AMotionThatIsMissingIsNoticed) {
  expect_differs(kArcCase, R"({"k":"rapid","b":1,"to":{"x":"10"}})", "", "the kinds differ");
}

TEST(CheckerVerdicts, AHashThatIsNotThatOfTheLinesIsNoticed) {
  Workshop shop;
  shop.change_results(R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny")",
                      R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tinx")");
  expect_said(shop, 1, "the case lines have the SHA-256");
}

TEST(CheckerVerdicts, TimesAreNotHashed) {
  Workshop shop;
  shop.change_results(
      R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny","features":["basic"],"clauses":["NGC-G0-01"],"verdict":"pass-exact","us":17)",
      R"("id":"tiny.arc.000001","dialect":"rs274","cycle":"tiny","features":["basic"],"clauses":["NGC-G0-01"],"verdict":"pass-exact","us":99)");
  expect_said(shop, 0, "3 verdicts derived again");
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
  Workshop shop;
  shop.change_results(R"("pass-exact":3)", R"("pass-exact":4)");
  expect_said(shop, 1, "The totals of the footer");
}

TEST(CheckerVerdicts, ADecisionThatTheLinesDoNotMakeIsNoticed) {
  Workshop shop;
  shop.change_results(R"("decision":"GO")", R"("decision":"NO-GO")");
  expect_said(shop, 1, "the lines make it GO");
}

TEST(CheckerVerdicts, AFileWithoutItsFooterIsIncomplete) {
  Workshop shop;
  shop.change_results(R"({"decision":)", R"({"id":"z","decision":)");
  EXPECT_EQ(shop.check_verdicts().exit_code, 2);
}

TEST(CheckerVerdicts, AnotherCorpusIsNoticed) {
  Workshop shop;
  shop.change_results(R"("corpus":{"version":"2026.1.0","sha256":")",
                      R"("corpus":{"version":"2026.1.0","sha256":"0)");
  expect_said(shop, 1, "another corpus");
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
  shop.set_verdict(kLineCase, "xfail");
  expect_said(shop, 1, "differs  " + kLineCase + ": The file says xfail; derived: GO.");
}

// J-RUN-13: it reads no file of known failures.
TEST(CheckerVerdicts, WhatAKnownFailureMakesOfACaseIsUnproven) {
  Workshop shop;
  shop.change_results(R"("chord":null)", R"("chord":null,"known_failures":"ab")");
  expect_said(shop, 3, "Which passes are known to fail was not derived.");
  shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")");
  shop.set_verdict(kLineCase, "xfail");
  expect_said(shop, 3, "1  xfail: departs, but known failures are not read here");
}

TEST(CheckerVerdicts, AKnownFailureWithoutItsEvidenceIsNoticed) {
  for (const char* key : {"\"program\":", "\"trace\":"}) {
    Workshop shop;
    shop.change_results(R"("chord":null)", R"("chord":null,"known_failures":"ab")");
    shop.change_trace(kLineCase, R"("to":{"y":"2"},"f")", R"("to":{"y":"3"},"f")");
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
  Workshop shop;
  shop.change_results(R"("assignments":[])",
                      R"("assignments":[],"fresh":{"rs274":{"wanted":3,"programs":2,"judged":2}})");
  expect_said(shop, 0, "No line shows what the subject did with 2 fresh programs of rs274.");
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
  Workshop shop;
  shop.change_results(R"("features":["blocks","m"])",
                      R"("features":["blocks","m"],"dialects":{"rs274":["arc"]})");
  expect_said(shop, 1, "The subject does not declare basic: such a case is skipped.");
}

TEST(CheckerVerdicts, AVersionOfTheCorpusThatIsAnotherIsNoticed) {
  Workshop shop;
  shop.change_results(R"("corpus":{"version":"2026.1.0")", R"("corpus":{"version":"2025.1.0")");
  expect_said(shop, 1, "The run names another version of the corpus");
}

TEST(CheckerVerdicts, AnExpectedGapThatTheCorpusDoesNotExpectIsNoticed) {
  Workshop shop;
  shop.set_verdict(kLineCase, "oracle-gap");
  shop.change_lines(R"("verdict":"oracle-gap")", R"("verdict":"oracle-gap","expected":true)");
  expect_said(shop, 1, "The line says that the corpus expects an oracle-gap, and it does not.");
}

TEST(CheckerVerdicts, AHeaderThatIsNotItsCommandLineIsNoticed) {
  Workshop shop;
  shop.change_results(R"("argv":[])", R"("argv":["certify","--tolerance","1"])");
  expect_said(shop, 1, "The header and its command line differ in --tolerance.");
}

// Values are compared, not their spelling.
TEST(CheckerVerdicts, AFlagMayBeSetWithAValue) {
  for (const char* word : {"--strict", "--strict=true", "--strict=1", "--strict=ON"}) {
    Workshop shop;
    shop.change_results(R"("argv":[])",
                        std::string(R"("strict":true,"argv":["certify",")") + word + "\"]");
    expect_said(shop, 0, "3 verdicts derived again");
  }
  for (const char* word : {"--strict=false", "--strict=0", "--strict=no", "--strict=-1"}) {
    Workshop shop;
    shop.change_results(R"("argv":[])",
                        std::string(R"("strict":true,"argv":["certify",")") + word + "\"]");
    expect_said(shop, 1, "The header and its command line differ in --strict.");
  }
}

TEST(CheckerVerdicts, AFeedToleranceOrNamesOfCasesThatTheHeaderDoesNotSayAreNoticed) {
  const auto with = [](const std::string& words, const std::string& header) {
    Workshop shop;
    shop.change_results(R"("argv":[])", header + R"("argv":["certify",)" + words + "]");
    return shop.check_verdicts();
  };
  EXPECT_NE(with(R"("--feed-tolerance","300")", "").text.find("differ in --feed-tolerance."),
            std::string::npos);
  EXPECT_NE(with(R"("--show-ids")", "").text.find("differ in --show-ids."), std::string::npos);
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

}  // namespace
}  // namespace gonogo::checker
