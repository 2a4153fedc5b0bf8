// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vectors that are broken in one way each.
#include <gtest/gtest.h>

#include "tests/checker/workshop.hpp"
#include "tests/has.hpp"

namespace gonogo::checker {
namespace {

void expect_fault(const std::string& from, const std::string& to, const std::string& sentence) {
  Workshop shop;
  shop.change_vectors(from, to);
  const Said said = shop.check_vectors();
  EXPECT_NE(said.exit_code, 0) << from << " -> " << to;
  EXPECT_TRUE(has(said.text, sentence));
}

TEST(CheckerVectors, WhatIsWholeHasNoFault) {
  Workshop shop;
  const Said said = shop.check_vectors();
  EXPECT_EQ(said.exit_code, 0) << said.text;
  EXPECT_TRUE(has(said.text, "3 vectors, 3 expectations, 6 records: 0 faults"));
}

TEST(CheckerVectors, AnEndThatIsNotThatOfThePathIsNoticed) {
  expect_fault(R"("end","to":{"x":"1","y":"2")", R"("end","to":{"x":"1","y":"2.000001")",
               "The end is at");
}

TEST(CheckerVectors, ACentreThatIsNotInTheMiddleIsNoticed) {
  // Radii 10 and 10.00001, which rs274 admits; with a clause of a cycle it is not.
  expect_fault(R"("to":{"x":"0","y":"10"},"f":"50"})",
               R"("to":{"x":"0","y":"10.00001"},"f":"50","clause":"GSK-G110-09"})",
               "not as far from its end");
  // 10 and 10.003: more than the 0.002 of NGC-ARC-03.
  expect_fault(R"("to":{"x":"0","y":"10"},"f":"50"})",
               R"("to":{"x":"0","y":"10.003"},"f":"50","clause":"NGC-ARC-02"})",
               "not as far from its end");
}

TEST(CheckerVectors, AnArcWithoutTurnIsNoticed) {
  expect_fault(R"("rot":-1)", R"("rot":0)", "rot of an arc is 0");
}

TEST(CheckerVectors, AnArcWithoutAnAxisOfItsPlaneIsNoticed) {
  expect_fault(R"("c":{"x":"0","y":"0"})", R"("c":{"x":"0"})", "lacks an axis");
  expect_fault(R"("plane":"G17")", R"("plane":"G18")", "lacks an axis");
}

TEST(CheckerVectors, AFeedThatIsNotAboveZeroIsNoticed) {
  expect_fault(R"("f":"100"})", R"("f":"0"})", "no feed above zero");
}

TEST(CheckerVectors, LinesThatDoNotAscendAreNoticed) {
  expect_fault(R"({"k":"feed","b":2)", R"({"k":"feed","b":4)", "do not ascend");
}

TEST(CheckerVectors, ALineThatTheProgramDoesNotHaveIsNoticed) {
  expect_fault(R"({"k":"m","b":3)", R"({"k":"m","b":4)", "has no such line");
  expect_fault(R"("class":"feed-missing","b":2)", R"("class":"feed-missing","b":4)",
               "The alarm is in line 4 of 3");
}

TEST(CheckerVectors, MotionOfTheAlarmsLineIsNoticed) {
  expect_fault(R"("class":"feed-missing","b":2)", R"("class":"feed-missing","b":1)",
               "stands before the alarm");
}

TEST(CheckerVectors, AnUnknownAlarmClassIsNoticed) {
  expect_fault("feed-missing", "feed-absent", "alarm class feed-absent is unknown");
}

TEST(CheckerVectors, WhatFollowsTheEndIsNoticed) {
  expect_fault(R"("f":"50"},)", R"("f":"50"},{"k":"end","to":{"x":"0"}},)",
               "A record follows the end");
}

TEST(CheckerVectors, AnExpectationWithoutAnEndingIsNoticed) {
  expect_fault(R"(,
{"k":"end","to":{"x":"1","y":"2","z":"0","a":"0","c":"0"}})",
               "", "none or several");
}

TEST(CheckerVectors, AnUnknownKeyIsNoticed) {
  expect_fault(R"("comment":"a line")", R"("comment":"a line","remark":"x")", "unknown key");
}

TEST(CheckerVectors, ANumberThatIsNoneIsNoticed) {
  expect_fault(R"("f":"100")", R"("f":"1e2")", "is no number of a vector");
  expect_fault(R"("f":"100")", R"("f":100)", "stands in quotes");
}

TEST(CheckerVectors, IdsThatAreRetiredOrThereTwiceAreNoticed) {
  expect_fault("tiny.arc.000001", "tiny.old.000001", "retired");
  expect_fault("tiny.arc.000001", "tiny.line.000001", "there twice");
  expect_fault("tiny.arc.000001", "tiny.arc.1", "not of the form");
}

TEST(CheckerVectors, ReadingsThatDoNotExcludeEachOtherAreNoticed) {
  const std::string one =
      R"({"when":{"ngc.arc-tolerance":"nist"},"records":[],"not_covered":true},)";
  expect_fault(R"("no feed","program":"G0 X1\nG1 Y2\nX3\n","expect":[)",
               R"("no feed","program":"G0 X1\nG1 Y2\nX3\n","expect":[)" + one, "do not exclude");
}

TEST(CheckerVectors, AnUnknownReadingIsNoticed) {
  expect_fault(R"("profile":{})", R"("profile":{"readings":{"ngc.none":"x"}})",
               "The reading ngc.none is unknown");
}

TEST(CheckerVectors, AnUnknownDialectIsNoticed) {
  expect_fault(R"("dialect":"rs274","cycle")", R"("dialect":"rs275","cycle")",
               "dialect is unknown");
}

}  // namespace
}  // namespace gonogo::checker
