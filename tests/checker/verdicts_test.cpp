// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traces that are broken in one way each.
#include <gtest/gtest.h>

#include "tests/checker/workshop.hpp"

namespace gonogo::checker {
namespace {

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
  shop.depart();
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
  shop.depart();
  shop.set_verdict(kLineCase, "advice");
  expect_said(shop, 0, "3 verdicts derived again (2 GO, 1 NO-GO, 0 not covered)");
}

TEST(CheckerVerdicts, AnAdviceWhereATextStatesTheExpectationIsNoticed) {
  Workshop shop;
  shop.depart();
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
  shop.change_results(R"(["certify"])", R"(["certify","--feed-resolution","0.1"])");
  expect_said(shop, 0, "3 verdicts derived again");
}

TEST(CheckerVerdicts, AFeedThatIsRoundedTheOtherWayIsADeparture) {
  Workshop shop;
  shop.change_vectors(R"("f":"100"})", R"("f":"100.06"})");
  shop.change_results(R"("chord":null)", R"("chord":null,"feed_resolution":"0.1")");
  shop.change_results(R"(["certify"])", R"(["certify","--feed-resolution","0.1"])");
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

}  // namespace
}  // namespace gonogo::checker
