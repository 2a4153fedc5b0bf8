// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, dimensions, feeds, dwells, M functions and common rules of the expander of sinumerik840d.
#include <gtest/gtest.h>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(SinumerikMode, TheGroove) {
  EXPECT_EQ(
      motions_and_alarm("N10 G17 S400 M3\nN20 G0 X20 Y20 Z2\nN30 G1 Z-2 F40\nN40 X80 Y80 Z-15\n"
                        "N50 G0 Z100 M30\n"),
      "m 3\nrapid x=20 y=20 z=2\nfeed z=-2 f=40\nfeed x=80 y=80 z=-15 f=40\nrapid z=100\n"
      "m 30\n");
}

TEST(SinumerikMode, RotaryAxesGoAlong) {
  EXPECT_EQ(motions_and_alarm("G1 G90 X100 Y20 Z30 A40 F100\nG91 A10\nG0 C=IC(5) A=AC(1)\n"),
            "feed x=100 y=20 z=30 a=40 f=100\nfeed a=50 f=100\nrapid a=1 c=5\n");
}

TEST(SinumerikMode, PowerOnIsG1) {
  EXPECT_EQ(motions_and_alarm("X1 F9\n"), "feed x=1 f=9\n");
  EXPECT_EQ(motions_and_alarm("X1\n", R"({"readings":{"sie.initial-motion":"g0"}})"),
            "rapid x=1\n");
}

TEST(SinumerikMode, MotionCodesAreOneGroup) {
  EXPECT_EQ(motions_and_alarm("G2 F9\nX2 I1\nG1 X3\nCIP X5 I1=4 J1=1\nX7 I1=6 J1=1\nCT\nX8\n")
                .substr(0, 30),
            "arc17 c=1,0 rot=-1 x=2 y=0 f=9");
  EXPECT_EQ(motions_and_alarm("G0 G1 X1\n"), "duplicate-word");
  EXPECT_EQ(motions_and_alarm("G1 CIP X1\n"), "duplicate-word");
  EXPECT_EQ(motions_and_alarm("CT CIP X1\n"), "duplicate-word");
}

TEST(SinumerikMode, InchesScaleLengthsOnly) {
  EXPECT_EQ(motions_and_alarm("G70 G1 X1 A1 F10\nA2\nG71 X1\n"),
            "feed x=25.4 a=1 f=10\nfeed a=2 f=10\nfeed x=1 f=10\n");
  const char* inch = R"({"readings":{"sie.g70.f":"inch"}})";
  EXPECT_EQ(motions_and_alarm("G70 G1 X1 A1 F10\nA2\nG71 X1\n", inch),
            "feed x=25.4 a=1 f=254\nfeed a=2 f=10\nfeed x=1 f=10\n");
}

TEST(SinumerikMode, FeedPerRevolution) {
  EXPECT_EQ(motions_and_alarm("G95 G1 X1 F0.2\nG94 X2 F9\n"), "feed x=1 f=0.2/rev\nfeed x=2 f=9\n");
  EXPECT_EQ(motions_and_alarm("G96 S9 G1 X1 F0.2\nG971 X2 F9\n"),
            "feed x=1 f=0.2/rev\nfeed x=2 f=9\n");
}

TEST(SinumerikMode, FeedOfBeforeTheChange) {
  const char* change = "G1 X1 F9\nG95 X2\n";
  EXPECT_EQ(motions_and_alarm(change), "feed x=1 f=9\nfeed x=2 f=9/rev\n");
  const char* deleted = R"({"readings":{"sie.feed-change":"deleted"}})";
  EXPECT_EQ(motions_and_alarm(change, deleted), "feed x=1 f=9\nfeed-missing");
  EXPECT_EQ(motions_and_alarm("G1 X1 F9\nG95 X2 F0.2\nG97 X3\n", deleted),
            "feed x=1 f=9\nfeed x=2 f=0.2/rev\nfeed x=3 f=0.2/rev\n");
}

TEST(SinumerikMode, FeedMissing) {
  EXPECT_EQ(motions_and_alarm("G1 X1\n"), "feed-missing");
  EXPECT_EQ(motions_and_alarm("G0 X1 F9\nG1 X2\nF0\nX3\n"),
            "rapid x=1\nfeed x=2 f=9\nfeed-missing");
  EXPECT_EQ(motions_and_alarm("G1 X1 F-1\n"), "value-sign");
  EXPECT_EQ(motions_and_alarm("G1\n"), "");
}

TEST(SinumerikMode, SpindleWanted) {
  const char* checked = R"({"readings":{"sie.spindle":"alarm"}})";
  EXPECT_EQ(motions_and_alarm("G1 X1 F9\n", checked), "spindle-stopped");
  EXPECT_EQ(motions_and_alarm("M3 G1 X1 F9\n", checked), "spindle-stopped");
  EXPECT_EQ(motions_and_alarm("S9 M3 G1 X1 F9\n", checked), "m 3\nfeed x=1 f=9\n");
  EXPECT_EQ(motions_and_alarm("S9 M4\nM5 G1 X1 F9\n", checked), "m 4\nspindle-stopped");
  EXPECT_EQ(motions_and_alarm("G1 X1 F9\n",
                              R"({"readings":{"sie.spindle":"alarm"},"initial":{"spindle":"3"}})"),
            "feed x=1 f=9\n");
}

TEST(SinumerikMode, Dwell) {
  EXPECT_EQ(motions_and_alarm("G4 F2.5\n"), "dwell 2.5\n");
  EXPECT_EQ(motions_and_alarm("S400\nG4 S1\n"), "dwell 0.15\n");
  EXPECT_EQ(motions_and_alarm("F9 S60\nG4 F2\nG4 S2\nG1 X1\nG4 S1\n"),
            "dwell 2\ndwell 2\nfeed x=1 f=9\ndwell 1\n");
  EXPECT_EQ(motions_and_alarm("G4\n"), "missing-word");
  EXPECT_EQ(motions_and_alarm("G4 F-1\n"), "value-sign");
  EXPECT_EQ(motions_and_alarm("G4 F1 X1\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G0 G4 F1\n"), "conflicting-words");
}

TEST(SinumerikMode, FunctionsBeforeAndAfter) {
  EXPECT_EQ(motions_and_alarm("G0 X1 M0 M8 M3\nX2 M17\nX3\n"),
            "m 8\nm 3\nrapid x=1\nm 0\nrapid x=2\nm 17\n");
  EXPECT_EQ(motions_and_alarm("M2147483648\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("M3.5\n"), "not-an-integer");
}

TEST(SinumerikMode, CodesWithoutEffect) {
  EXPECT_EQ(motions_and_alarm("G9 G40 G53 G54 G60 G500\n"), "duplicate-word");
  EXPECT_EQ(motions_and_alarm("G0 G9 G40 G53 G54 G60 G601 T5 D1 S10 H3 X1\nG64 G57 G602 X2\n"),
            "rapid x=1\nrapid x=2\n");
}

TEST(SinumerikAlarms, CommonRules) {
  for (const char* block : {"G999", "G1.5", "G-1", "G158", "G258", "LCYC99", "G999 X1 X2"}) {
    EXPECT_EQ(motions_and_alarm(block), "undefined-code") << block;
  }
  for (const char* block :
       {"G0 X1 X2", "G0 X1 X=AC(2)", "G17 G18", "F1 F2", "G90 G91", "G2 CR=1 CR=2 X1 F9"}) {
    EXPECT_EQ(motions_and_alarm(block), "duplicate-word") << block;
  }
  EXPECT_EQ(motions_and_alarm("G0 X99999999999\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("S-1\n"), "value-sign");
}

TEST(SinumerikAlarms, WordsOfOtherMotions) {
  for (const char* word : {"I1", "CR=1", "AR=1", "TURN=1", "I1=1"}) {
    EXPECT_EQ(motions_and_alarm("G0 X1 " + std::string(word)), "conflicting-words") << word;
    EXPECT_EQ(motions_and_alarm("G1 X1 F9 " + std::string(word)), "conflicting-words") << word;
  }
  EXPECT_EQ(motions_and_alarm("G2 X1 I1 I1=1 F9\n"), "conflicting-words");
}

TEST(SinumerikAlarms, FormsOfArcs) {
  EXPECT_EQ(motions_and_alarm("G2 X1 F9\n"), "missing-word");
  EXPECT_EQ(motions_and_alarm("G2 A1 F9\n"), "missing-word");
  EXPECT_EQ(motions_and_alarm("G2 X1 CR=1 I1 F9\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G2 X1 CR=1 AR=1 F9\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G2 X1 I1 AR=1 F9\n"), "conflicting-words");
  EXPECT_EQ(motions_and_alarm("G2 X1 Y1 K1 F9\n"), "axis-not-in-plane");
  EXPECT_EQ(motions_and_alarm("G2 I0 F9\n"), "arc-radius");
  EXPECT_EQ(motions_and_alarm("G2 X1 CR=0 F9\n"), "arc-radius");
  EXPECT_EQ(motions_and_alarm("G2 X9 I2 F9\n"), "arc-end-point");
  EXPECT_EQ(motions_and_alarm("G2 X2 I1\n"), "feed-missing");
  EXPECT_EQ(motions_and_alarm("G2 X2 I1 TURN=1.5 F9\n"), "not-an-integer");
  EXPECT_EQ(motions_and_alarm("G2 X2 I1 TURN=-1 F9\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("G2 X2 I1 TURN=1000 F9\n"), "value-out-of-range");
  EXPECT_EQ(motions_and_alarm("G2 X2 I1 TURN=999 F9\n"), "arc17 c=1,0 rot=-1000 x=2 y=0 f=9\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
