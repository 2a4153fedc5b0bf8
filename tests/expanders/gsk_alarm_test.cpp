// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms at their boundaries. Each is raised in its block and before any of its motion.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// What a G110 block with these words ends with: "" or the alarm's class, after one motion only.
std::string pocket(const std::string& words) {
  const Outcome outcome = run("G0 X7 Y50\nG110 X50 Z50 " + words + "\n");
  if (outcome.alarms == 0) return "";
  EXPECT_EQ(outcome.alarms, 1u);
  EXPECT_EQ(outcome.alarm_block, 2u);
  EXPECT_EQ(outcome.motions(), "rapid x=3.5 y=50\n");
  return outcome.alarm;
}

TEST(GskAlarm, ToolMustBeSmallerThanThePocket) {
  EXPECT_EQ(pocket("Y20 R-5 I4.001 L3 Q5 D4 F800"), "");
  EXPECT_EQ(pocket("Y20 R-5 I4 L3 Q5 D4 F800"), "tool-too-large");
  EXPECT_EQ(pocket("Y20 R-5 I3.999 L3 Q5 D4 F800"), "tool-too-large");
}

TEST(GskAlarm, StepMustBeSmallerThanTheToolDiameter) {
  EXPECT_EQ(pocket("Y20 R-5 I16 L7.999 Q5 D4 F800"), "");
  EXPECT_EQ(pocket("Y20 R-5 I16 L8 Q5 D4 F800"), "step-too-large");
  EXPECT_EQ(pocket("Y20 R-5 I16 L8.001 Q5 D4 F800"), "step-too-large");
}

TEST(GskAlarm, RPlaneAndDepthMustAgree) {
  EXPECT_EQ(pocket("Y20 R0.001 I16 L3 Q5 D4 F800"), "direction-conflict");
  EXPECT_EQ(pocket("Y20 R0 I16 L3 Q5 D4 F800"), "");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 F800"), "");
  EXPECT_EQ(pocket("V1 R-5 I16 L3 Q5 D4 F800"), "direction-conflict");
  EXPECT_EQ(pocket("Y45 R-5 I16 L3 Q5 D4 F800"), "");
  EXPECT_EQ(pocket("Y45.001 R-5 I16 L3 Q5 D4 F800"), "direction-conflict");
}

TEST(GskAlarm, EntryNeedsILQD) {
  EXPECT_EQ(pocket("Y20 L3 Q5 D4 F800"), "missing-word");
  EXPECT_EQ(pocket("Y20 I16 Q5 D4 F800"), "missing-word");
  EXPECT_EQ(pocket("Y20 I16 L3 D4 F800"), "missing-word");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 F800"), "missing-word");
  EXPECT_EQ(run("G110\n").alarm, "missing-word");
}

TEST(GskAlarm, PocketWordsMustBeAboveZero) {
  EXPECT_EQ(pocket("Y20 I0 L3 Q5 D4 F800"), "value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L0 Q5 D4 F800"), "value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D0 F800"), "value-out-of-range");
}

TEST(GskAlarm, ZeroIsCheckedInBlocksThatMillOnly) {
  EXPECT_EQ(run("G110 I0 L0 Q0 D0\n").answer, GONOGO_OK);
}

TEST(GskAlarm, UnsignedWordsTakeNoMinus) {
  EXPECT_EQ(pocket("Y20 I-16 L3 Q5 D4 F800"), "value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 J-1 F800"), "value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 J-0 F800"), "value-out-of-range");
}

TEST(GskAlarm, RangeEndsAreInclusive) {
  EXPECT_EQ(run("G94 Z-999999.999 F1\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G94 Z-1000000 F1\n").alarm, "value-out-of-range");
  EXPECT_EQ(run("G94 R999999.999 F1\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G94 R1000000 F1\n").alarm, "value-out-of-range");
  EXPECT_EQ(run("G20 G94 Z99999.9999 F1\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G20 G94 Z100000 F1\n").alarm, "value-out-of-range");
}

TEST(GskAlarm, RangesOfTheFineIncrementSystemAreATenth) {
  const char* fine = R"({"increment":"ISC"})";
  EXPECT_EQ(run("G94 Z99999.9999 F1\n", fine).answer, GONOGO_OK);
  EXPECT_EQ(run("G94 Z100000 F1\n", fine).alarm, "value-out-of-range");
  EXPECT_EQ(run("G20 G94 Z9999.99999 F1\n", fine).answer, GONOGO_OK);
  EXPECT_EQ(run("G20 G94 Z10000 F1\n", fine).alarm, "value-out-of-range");
}

TEST(GskAlarm, RangesDoNotHoldOutsideOfCycles) {
  EXPECT_EQ(run("G00 Z-1000000\n").records[0], "rapid z=-1000000");
}

TEST(GskAlarm, AddressTwice) {
  EXPECT_EQ(run("G00 X1 X1\n").alarm, "duplicate-word");
  EXPECT_EQ(run("G00 G01 X1\n").alarm, "duplicate-word");
  EXPECT_EQ(run("M3 M8\n").alarm, "duplicate-word");
}

TEST(GskAlarm, AbsoluteAndIncrementOfOneAxis) {
  for (const char* words : {"X1 U1", "V1 Y1", "Z1 W1"}) {
    EXPECT_EQ(run(std::string("G00 ") + words + "\n").alarm, "conflicting-words") << words;
  }
}

TEST(GskAlarm, CycleCodeBesideAMotionCode) {
  EXPECT_EQ(run("G00 G110 X0 Z0 Y-1 I3 L3 Q5 D2 F100\n").alarm, "conflicting-words");
  EXPECT_EQ(run("G94 G111 X0\n").alarm, "conflicting-words");
}

TEST(GskAlarm, CutsNeedAFeed) {
  EXPECT_EQ(run("G01 X5\n").alarm, "feed-missing");
  EXPECT_EQ(run("G01 X5 F0\n").alarm, "feed-missing");
  EXPECT_EQ(run("G02 X5 R9\n").alarm, "feed-missing");
  EXPECT_EQ(pocket("Y20 R-5 I16 L3 Q5 D4"), "feed-missing");
}

TEST(GskAlarm, FeedBelowZero) {
  EXPECT_EQ(run("G01 X5 F-1\n").alarm, "value-sign");
}

TEST(GskAlarm, CodesThatTheControlLacks) {
  for (const char* code : {"G06", "G94.5", "G118", "G999999", "G-1", "G00.0000000001"}) {
    EXPECT_EQ(run(std::string(code) + "\n").alarm, "undefined-code") << code;
  }
}

TEST(GskAlarm, CodesOfALaterVersionAreUnsupported) {
  for (const char* code :
       {"G71", "G83", "G7.1", "G41", "G55", "G32", "G26", "G2.1", "G92.2", "G53.3", "G165"}) {
    const Outcome outcome = run(std::string("G00 X2\n") + code + " X1\n");
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << code;
    EXPECT_NE(outcome.note.find(std::string(code) + " "), std::string::npos) << outcome.note;
    EXPECT_EQ(outcome.records.size(), 1u);
  }
}

TEST(GskAlarm, NothingRunsAfterIt) {
  const Outcome outcome = run("G00 X2\nG999\nX4\n");
  EXPECT_EQ(outcome.all(), "answer 1\n1 rapid x=1\nalarm undefined-code in 2\n");
}

TEST(GskAlarm, CarriesTheControlsNumber) {
  EXPECT_EQ(run("G999\n").native, "0002");
}

}  // namespace
}  // namespace gonogo::expanders::testing
