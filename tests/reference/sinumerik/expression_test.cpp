// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-PAR-01: R parameters and the values of words.
#include <gtest/gtest.h>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

// What X is after G0 X=...
std::string x_of(const std::string& value) {
  return line("G0 X=" + value, 0);
}

TEST(SieExpression, AssignmentsActAtOnceFromLeftToRight) {
  EXPECT_EQ(path("G0\nR1=5 X=R1 R1=6\nX=R1"), (Lines{"rapid x5", "rapid x6"}));
  EXPECT_EQ(line("G0 R1=2 R2=R1*R1 R1=R2+1 X=R1 Y=R2", 0), "rapid x5 y4");
  EXPECT_EQ(x_of("R7"), "rapid x0");
}

TEST(SieExpression, TheUsualPrecedenceHolds) {
  EXPECT_EQ(x_of("1+2*3"), "rapid x7");
  EXPECT_EQ(x_of("(1+2)*3"), "rapid x9");
  EXPECT_EQ(x_of("10-4-3"), "rapid x3");
  EXPECT_EQ(x_of("8/4/2"), "rapid x1");
  EXPECT_EQ(x_of("-2*-3"), "rapid x6");
  EXPECT_EQ(x_of("1/3"), "rapid x1/3");
}

TEST(SieExpression, FunctionsAreOfDegreesAndExact) {
  EXPECT_EQ(x_of("SIN(30)"), "rapid x0.5");
  EXPECT_EQ(x_of("10*COS(60)"), "rapid x5");
  EXPECT_EQ(x_of("TAN(45)"), "rapid x1");
  EXPECT_EQ(x_of("TAN(-30)*TAN(-30)"), "rapid x1/3");
  EXPECT_EQ(x_of("SQRT(2)*SQRT(8)"), "rapid x4");
  EXPECT_EQ(x_of("ABS(-2.5)"), "rapid x2.5");
  // 10*(5+SIN(37.5)), the sample of the manual: sin 37.5 = 0.608761429...
  EXPECT_EQ(last_motion("G0 X=10*(5+SIN(37.5))").to[Axis::x].decimal_text(9), "56.087614290");
}

TEST(SieExpression, TheValuesOfAllWordsMayBeCalculated) {
  EXPECT_EQ(path("R1=1 R9=100\nG1 X=R1+1 F=R9/4\nG2 X=AC(R1) Y=IC(-R1) CR=R1*1"),
            (Lines{"feed x2 f25", "arc x1 y-1 c1,0 rot-1 f25"}));
}

TEST(SieExpression, WhatHasNoValueIsAnAlarm) {
  EXPECT_EQ(outcome("G0 X=1/0"), "value-out-of-range X");
  EXPECT_EQ(outcome("G0 X=1/(SIN(30)-0.5)"), "value-out-of-range X");
  EXPECT_EQ(outcome("R5=SQRT(-0.001)"), "value-out-of-range R5");
  EXPECT_EQ(outcome("R5=SQRT(0)"), "end");
  EXPECT_EQ(outcome("CR=TAN(270)"), "value-out-of-range CR");
  EXPECT_EQ(clauses("R1=1/0"), Lines{"SIE-PAR-01"});
}

// SIE-MOD-02: what is ignored is a word with a value all the same.
TEST(SieExpression, WhatIsIgnoredHasAValueToo) {
  EXPECT_EQ(outcome("SPOS=SQRT(-1)"), "value-out-of-range SPOS");
  EXPECT_EQ(outcome("G0 LIMS=1/0"), "value-out-of-range LIMS");
  EXPECT_EQ(outcome("G0 X1 FFWON=TAN(90)"), "value-out-of-range FFWON");
  EXPECT_EQ(clauses("SPOS=1/0"), Lines{"SIE-PAR-01"});
  EXPECT_EQ(outcome("SPOS=SQRT(4) LIMS=R1"), "end");
}

TEST(SieExpression, TheParametersAreR0ToR999) {
  EXPECT_EQ(outcome("R0=1 R999=2"), "end");
  EXPECT_EQ(outcome("R1000=2"), "value-out-of-range R1000");
  EXPECT_EQ(outcome("G0 X=R1000"), "value-out-of-range X");
}

// R1 has 1, 2, 4, ... 2^22 digits behind the point.
TEST(SieExpression, AnEndlessValueIsNotCovered) {
  std::string program = "R1=1.5\n";
  for (int i = 0; i < 22; ++i) program += "R1=R1*R1\n";
  EXPECT_EQ(outcome_of_program(program), "not-covered expression");
  std::string deep = "R1=1\n";
  for (int i = 0; i < 2000; ++i) deep += "R1=SIN(R1)+R1\n";
  EXPECT_EQ(outcome_of_program(deep), "not-covered expression");
}

TEST(SieExpression, ALongSumIsAValue) {
  std::string sum = "0";
  for (int i = 0; i < 20'000; ++i) sum += "+0.5";
  EXPECT_EQ(x_of(sum), "rapid x10000");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
