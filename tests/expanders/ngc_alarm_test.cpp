// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms of the expander of rs274, and what it does not cover.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string ngc_alarm(const std::string& block, const char* profile = "{}") {
  return run_ngc("F9\n" + block + "\n", profile).alarm;
}

TEST(NgcAlarm, SpeedsAndToolsBelowZeroAndAborts) {
  EXPECT_EQ(ngc_alarm("S-1"), "value-sign");
  EXPECT_EQ(ngc_alarm("M61 Q-1"), "value-sign");
  EXPECT_EQ(ngc_alarm("M62"), "missing-word");
  EXPECT_EQ(ngc_alarm("M66 P0 E0"), "conflicting-words");
  EXPECT_EQ(ngc_alarm("M66 P0 L1 Q0"), "value-sign");
  EXPECT_EQ(ngc_alarm("M66 P0 L1"), "missing-word");
  EXPECT_EQ(ngc_alarm("M66 E0 L3 Q1"), "conflicting-words");
  EXPECT_EQ(ngc_alarm("M67 Q1"), "missing-word");
  EXPECT_EQ(ngc_alarm("T-1"), "value-sign");
  EXPECT_EQ(ngc_alarm("T1.5"), "not-an-integer");
  EXPECT_EQ(ngc_alarm("S1.5 T0"), "");
  EXPECT_EQ(ngc_alarm("G0 X1 ( Abort, no part)"), "program-end");
  EXPECT_EQ(ngc_alarm("(abort, no part)(note) G0 X1"), "");
}

TEST(NgcAlarm, AnAxisWordNeedsAMotionCode) {
  for (const char* block : {"X1", "A1", "G80 X1", "G4 P1 X1", "G1\nG80\nY1"}) {
    EXPECT_EQ(ngc_alarm(block), "missing-word") << block;
  }
}

TEST(NgcAlarm, AFeed) {
  EXPECT_EQ(ngc_alarm("F0 G1 X1"), "feed-missing");
  EXPECT_EQ(ngc_alarm("F0 G2 X2 I1"), "feed-missing");
  EXPECT_EQ(ngc_alarm("F-1"), "value-sign");
  EXPECT_EQ(run_ngc("G1 X0\n").alarm, "feed-missing");
  EXPECT_EQ(run_ngc("G1\nG0 X1\n").alarm, "feed-missing");
}

TEST(NgcAlarm, MotionCodesAlone) {
  constexpr const char* kNeedsAxis = R"({"readings":{"ngc.bare-motion":"missing-word"}})";
  for (const char* block : {"G0", "G1", "G1 G4 P1", "G0 G17"}) {
    EXPECT_EQ(ngc_alarm(block), "") << block;
    EXPECT_EQ(ngc_alarm(block, kNeedsAxis), "missing-word") << block;
  }
  EXPECT_EQ(ngc_alarm("G1 X1\nG4 P1", kNeedsAxis), "");
}

TEST(NgcAlarm, WordsThatNothingUses) {
  constexpr const char* kIgnored = R"({"readings":{"ngc.unused-words":"ignored"}})";
  for (const char* block :
       {"G0 X1 I2",    "G0 X1 R2",     "G0 X1 L2",    "G1 X1 P2",     "I1",           "R1",
        "P1",          "S100 I2",      "G17 I2",      "M3 S100 P2",   "G61 P1",       "T1 H1",
        "G40 D1",      "G4 P1 Q1",     "M50 Q1",      "M67 E0 P1 Q1", "M68 E0 Q1 L0", "M61 Q0 L0",
        "G2 X2 I1 Q1", "G2 X2 I1\nP2", "G2 X2 I1\nR2"}) {
    EXPECT_EQ(ngc_alarm(block), "unused-word") << block;
    EXPECT_EQ(ngc_alarm(block, kIgnored), "") << block;
  }
  for (const char* block :
       {"G64 P0.1 Q0.1", "M66 P0 L3 Q1", "M66 E0 L0", "M67 E0 Q1", "M61 Q0", "M62 P1", "M53 P1"}) {
    EXPECT_EQ(ngc_alarm(block), "") << block;
  }
}

TEST(NgcAlarm, CentresAlone) {
  constexpr const char* kUnused = R"({"readings":{"ngc.arc-words-alone":"alarm"}})";
  EXPECT_EQ(run_ngc("G2 X2 I1 F9\nI1\n").motions(),
            "arc17 c=1,0 rot=-1 x=2 y=0 f=9\narc17 c=3,0 rot=-1 x=2 y=0 f=9\n");
  EXPECT_EQ(ngc_alarm("G2 X2 I1\nI1", kUnused), "unused-word");
  EXPECT_EQ(ngc_alarm("G2 X2 I1\nX2 I1", kUnused), "");
}

TEST(NgcAlarm, G80BesideAMotion) {
  constexpr const char* kForgotten = R"({"readings":{"ngc.g80-beside":"ignored"}})";
  EXPECT_EQ(run_ngc("G80 G0 X1\nX2\nG1 G80 X3 F9\n", kForgotten).motions(),
            "rapid x=1\nrapid x=2\nfeed x=3 f=9\n");
  EXPECT_EQ(ngc_alarm("G0 X1\nG80 G80\nX2", kForgotten), "missing-word");
  EXPECT_EQ(ngc_alarm("G80 G0 G1 X1", kForgotten), "duplicate-word");
  EXPECT_EQ(ngc_alarm("G00 G17 G21 G40 G49 G80 G90"), "duplicate-word");
}

TEST(NgcAlarm, UnknownCodes) {
  for (const char* block : {"G6", "G1.1", "G100", "G-1", "G5.1", "G38", "G999 X1 X2", "M10", "M17",
                            "M74", "M200", "M-1"}) {
    EXPECT_EQ(ngc_alarm(block), "undefined-code") << block;
  }
}

TEST(NgcAlarm, Twice) {
  for (const char* block : {"G1 X1 X2", "G0 G1 X1", "G17 G18", "G90 G91", "G20 G21", "G2 G80",
                            "G4 G4 P1", "F1 F2", "S1 S2", "G61 G64", "G90.1 G91.1", "G54 G54"}) {
    EXPECT_EQ(ngc_alarm(block), "duplicate-word") << block;
  }
  EXPECT_EQ(ngc_alarm("M3 M8"), "");
  EXPECT_EQ(ngc_alarm("G90 G90.1"), "");
}

TEST(NgcAlarm, WordsOfAnArc) {
  EXPECT_EQ(ngc_alarm("G2 X2 R1 I1"), "conflicting-words");
  EXPECT_EQ(ngc_alarm("G2 X2"), "missing-word");
  EXPECT_EQ(ngc_alarm("G2"), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 Z1 R1"), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 R1"), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 X2 K1"), "axis-not-in-plane");
  EXPECT_EQ(ngc_alarm("G18 G2 X2 I1 J1"), "axis-not-in-plane");
  EXPECT_EQ(ngc_alarm("G19 G2 Y2 I1"), "axis-not-in-plane");
  EXPECT_EQ(ngc_alarm("G90.1 G2 X2 I1"), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 X0 R1"), "arc-end-point");
  EXPECT_EQ(ngc_alarm("G2 X3 R1"), "arc-radius");
}

TEST(NgcAlarm, FullCirclesMayNeedAWord) {
  constexpr const char* kNeeded = R"({"readings":{"ngc.full-circle-words":"needed"}})";
  EXPECT_EQ(ngc_alarm("G2 I1", kNeeded), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 Z1 I1", kNeeded), "missing-word");
  EXPECT_EQ(ngc_alarm("G2 Y0 I1", kNeeded), "");
  EXPECT_EQ(ngc_alarm("G2 I1"), "");
}

TEST(NgcAlarm, Turns) {
  EXPECT_EQ(ngc_alarm("G2 X2 I1 P0"), "value-sign");
  EXPECT_EQ(ngc_alarm("G2 X2 I1 P-1"), "value-sign");
  EXPECT_EQ(ngc_alarm("G2 X2 I1 P1.5"), "not-an-integer");
  EXPECT_EQ(ngc_alarm("G2 X2 R1 P0.5"), "not-an-integer");
}

TEST(NgcAlarm, Dwell) {
  EXPECT_EQ(ngc_alarm("G4"), "missing-word");
  EXPECT_EQ(ngc_alarm("G4 P-1"), "value-sign");
}

TEST(NgcAlarm, TooLarge) {
  EXPECT_EQ(ngc_alarm("G0 X99999999999999999999"), "value-out-of-range");
  EXPECT_EQ(ngc_alarm("G91 G0 X3000000000\nX3000000000"), "value-out-of-range");
  EXPECT_EQ(ngc_alarm("G0 X2000000000\nG2 X0 R3000000000 Y4000000000"), "value-out-of-range");
}

TEST(NgcAlarm, NothingOfTheBlockMoves) {
  EXPECT_EQ(run_ngc("G0 X1\nG4 P1 M3 G1 X2\nX3\n").all(),
            "answer 1\n1 rapid x=1\nalarm feed-missing in 2\n");
}

TEST(NgcCoverage, OutsideGoesBeforeAlarms) {
  for (const char* block :
       {"G5 X1",  "G87 Z1", "G38.2 Z1", "G88 X1 X2", "G17.1",    "G41",   "G42.1",
        "G43 H1", "G55",    "G59.3",    "G10 L2",    "G28",      "G30.1", "G53 G0 X1",
        "G92 X0", "G92.2",  "G51",      "G7 X1",     "G55 G999", "G0 B1", "U1",
        "V1 F-1", "W1",     "M98 P1",   "M99",       "M100",     "M199"}) {
    const Outcome outcome = run_ngc(std::string("G0 X1\n") + block + "\n");
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << block;
    EXPECT_EQ(outcome.motions(), "rapid x=1\n") << block;
    EXPECT_EQ(outcome.alarms, 0u) << block;
  }
}

TEST(NgcCoverage, NamesTheCode) {
  EXPECT_EQ(run_ngc("G38.2\n").note, "G38.2 is not implemented.");
  EXPECT_EQ(run_ngc("G87\n").note, "G87 is not implemented.");
  EXPECT_EQ(run_ngc("B1\n").note, "B is not implemented.");
  EXPECT_EQ(run_ngc("M98\n").note, "M98 is not implemented.");
}

}  // namespace
}  // namespace gonogo::expanders::testing
