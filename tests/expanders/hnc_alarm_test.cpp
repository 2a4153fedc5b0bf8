// SPDX-License-Identifier: GPL-3.0-or-later
// Rules of all blocks, what is not covered, and which alarm of several is reported.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string hnc_alarm(const std::string& block) {
  const Outcome outcome = run_hnc("G00 Z1\n" + block + "\n");
  EXPECT_EQ(outcome.motions(), "rapid z=1\n") << block;
  EXPECT_EQ(outcome.alarm_block, outcome.alarm.empty() ? 0u : 2u) << block;
  return outcome.alarm;
}

TEST(HncAlarms, CommonRules) {
  EXPECT_EQ(hnc_alarm("G999"), "undefined-code");
  EXPECT_EQ(hnc_alarm("G54.1"), "undefined-code");
  EXPECT_EQ(hnc_alarm("G43"), "undefined-code");
  EXPECT_EQ(hnc_alarm("X1 X2"), "duplicate-word");
  EXPECT_EQ(hnc_alarm("G00 G80"), "duplicate-word");
  EXPECT_EQ(hnc_alarm("G90 G91"), "duplicate-word");
  EXPECT_EQ(hnc_alarm("G54 G55"), "duplicate-word");
  EXPECT_EQ(hnc_alarm("G04 G92 P1"), "duplicate-word");
  EXPECT_EQ(hnc_alarm("X1 U2"), "conflicting-words");
  EXPECT_EQ(hnc_alarm("G80 Z1 W2"), "conflicting-words");
  EXPECT_EQ(hnc_alarm("G17"), "plane-not-allowed");
  EXPECT_EQ(hnc_alarm("G19 X1"), "plane-not-allowed");
  EXPECT_EQ(hnc_alarm("G01 X1"), "feed-missing");
  EXPECT_EQ(hnc_alarm("F-1"), "value-sign");
  EXPECT_EQ(hnc_alarm("M3.5"), "not-an-integer");
  EXPECT_EQ(hnc_alarm("G04"), "missing-word");
  EXPECT_EQ(hnc_alarm("G04 P-1"), "value-sign");
  EXPECT_EQ(hnc_alarm("X99999999999"), "value-out-of-range");
}

TEST(HncAlarms, CyclesNeedAFeed) {
  for (const char* block : {"G74 Z-1", "G75 X-1", "G80 X-1 Z-1", "G81 X-1 Z-1"}) {
    EXPECT_EQ(hnc_alarm(block), "feed-missing") << block;
  }
}

TEST(HncAlarms, Threads) {
  EXPECT_EQ(hnc_alarm("G82 X-1 Z-1"), "lead-missing");
  EXPECT_EQ(hnc_alarm("G32 X-1 Z-1"), "lead-missing");
  EXPECT_EQ(hnc_alarm("G82 F1 J1"), "conflicting-words");
  EXPECT_EQ(hnc_alarm("G82 F0"), "value-sign");
  EXPECT_EQ(hnc_alarm("G32 J-1"), "value-sign");
  EXPECT_EQ(hnc_alarm("G82 Q-1"), "value-sign");
  EXPECT_EQ(hnc_alarm("G82 C-1"), "value-sign");
  EXPECT_EQ(hnc_alarm("G82 C1.5"), "not-an-integer");
  EXPECT_EQ(hnc_alarm("G82 X-1 Z-1 F1 C2"), "missing-word");
}

TEST(HncAlarms, RulesOfOneCommandAreNotThoseOfAnother) {
  for (const char* block : {"G80 F1 J1 Q-1 C-1 R-1 A9", "G81 C1.5 I1", "G74 C-1 K1 F1 J-1",
                            "G75 C-1 E1", "G32 A1 F1", "G82 A1 K1 Q0"}) {
    EXPECT_EQ(hnc_alarm(block), "") << block;
  }
}

TEST(HncAlarms, CodesWithoutEffect) {
  EXPECT_EQ(hnc_alarm("G18 G21 G40 G94 G96 G64 S500 T0101 D1 H2 L3 B4"), "");
}

TEST(HncAlarms, YInATurningCycle) {
  EXPECT_EQ(hnc_alarm("G80 X1 Y1 Z1 F9"), "undefined-code");
  EXPECT_EQ(run_hnc("G81 F9\nX1 Z1 V1\n").alarm, "undefined-code");
}

TEST(HncAlarms, TheFirstWordAtFaultIsReported) {
  const Outcome later = run_hnc("G82 X-1 Z-1 C-2 F-1\n");
  EXPECT_EQ(later.alarm_word, 'C');
  const Outcome earlier = run_hnc("G82 F-1 X-1 Z-1 C-2\n");
  EXPECT_EQ(earlier.alarm_word, 'F');
  EXPECT_EQ(run_hnc("G74 Z-1 Q-1 R-1 F9\n").alarm_word, 'Q');
  // Faults of words that are there come before words that lack.
  EXPECT_EQ(run_hnc("G74 R-1\nX1\n").alarm_word, 'R');
}

TEST(HncCoverage, CodesAreNamed) {
  for (const char* code : {"G28", "G29", "G41", "G42", "G46", "G52", "G53", "G65", "G70", "G71",
                           "G72", "G73", "G76", "G98", "G99", "M98", "M99"}) {
    const Outcome outcome = run_hnc("G00 Z1\n" + std::string(code) + " X1 X2 G999\n");
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << code;
    EXPECT_EQ(outcome.note, std::string(code) + " is not implemented.");
    EXPECT_EQ(outcome.records.size(), 1u);
  }
}

TEST(HncCoverage, MacrosAreNamed) {
  const char* blocks[][2] = {
      {"#1=5", "#"},          {"X#1", "#"},       {"X-[#1+2]", "["},          {"X 1 [2]", "["},
      {"IF [#1 GT 2]", "IF"}, {"ENDIF", "ENDIF"}, {"while #1 LT 9", "while"}, {"G00 Z-#3", "#"}};
  for (const auto& [block, construct] : blocks) {
    EXPECT_EQ(run_hnc(block).note, std::string(construct) + " is not implemented.") << block;
  }
}

TEST(HncCoverage, ProgramsForAMill) {
  EXPECT_EQ(run_hnc("G01 X1 Y1 F9\n").note, "Y is not implemented.");
  EXPECT_EQ(run_hnc("G91 G02 X30 Y30 R30 F300\n").answer, GONOGO_UNSUPPORTED);
  EXPECT_EQ(run_hnc("G80 X-1 Z-1 F9\nG00 V1\n").note, "V is not implemented.");
}

}  // namespace
}  // namespace gonogo::expanders::testing
