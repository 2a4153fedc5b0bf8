// SPDX-License-Identifier: GPL-3.0-or-later
// G158, G258, G259 in the expander of sinumerik802s.
#include <gtest/gtest.h>

#include "sinumerik_motions.hpp"
#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string moved(const std::string& program, const char* profile = "{}") {
  return moving(run_sinumerik802s(program, profile));
}

TEST(SinumerikFrames, TranslationReplacesTheOneBefore) {
  EXPECT_EQ(moved("G158 X10 Y5\nG0 X1 Y1\nG158 X3\nX0 Y0\n"), "rapid x=11 y=6\nrapid x=3 y=0\n");
  EXPECT_EQ(moved("G158 X10\nG158\nG0 X1\n"), "rapid x=1\n");
  EXPECT_EQ(moved("G70\nG158 X1\nG71\nG0 X0\n"), "rapid x=25.4\n");
}

TEST(SinumerikFrames, TranslationsAddUnderTheReading) {
  const char* additive = R"({"readings":{"sie.g158":"additive"}})";
  // The second step is turned by 90 degrees: X becomes Y.
  EXPECT_EQ(moved("G158 X1\nG258 RPL=0\nG0 X0\n", additive), "");
  EXPECT_EQ(moved("G158 X1\nG259 RPL=90\nG158 X1\nG0 X0 Y0\n", additive), "rapid x=1 y=1\n");
  EXPECT_EQ(moved("G158 X1\nG158 Y2\nG158\nG0 X5\n", additive), "rapid x=5\n");
}

// (10, 0) and the quarter turn of (5, 0); (0, 5) and that of (1, 2).
TEST(SinumerikFrames, TheTranslationAloneIsReplacedUnderTheReading) {
  const char* alone = R"({"readings":{"sie.g158":"translation-only"}})";
  EXPECT_EQ(moved("G258 RPL=90\nG158 X10\nG0 X5 Y0\n", alone), "rapid x=10 y=5\n");
  EXPECT_EQ(moved("G158 X10 Y10\nG259 RPL=90\nG158 Y5\nG0 X1 Y2\n", alone), "rapid x=-2 y=6\n");
  EXPECT_EQ(moved("G258 RPL=90\nG158 X10\nG158\nG0 X5 Y0\n", alone), "rapid x=5\n");
}

// 5 + 10 + 1; -10 + 10 + 5; and -5 - 10 along Y of the turned frame.
TEST(SinumerikFrames, AnIncrementGoesTheTranslationUnderTheReading) {
  const char* with = R"({"readings":{"sie.frame.increment":"with-translation"}})";
  EXPECT_EQ(moved("G0 X5\nG158 X10\nG91 X1\n"), "rapid x=5\nrapid x=6\n");
  EXPECT_EQ(moved("G0 X5\nG158 X10\nG91 X1\nX1\n", with), "rapid x=5\nrapid x=16\nrapid x=17\n");
  EXPECT_EQ(moved("G158 X10\nG0 X0\nG158\nG91 X5\n", with), "rapid x=10\nrapid x=5\n");
  EXPECT_EQ(moved("G158 X10\nG259 RPL=90\nG91 G0 Y-5\n", with), "rapid x=15\n");
}

TEST(SinumerikFrames, RotationIsFromTheFirstAxisTowardTheSecond) {
  EXPECT_EQ(moved("G258 RPL=90\nG0 X1\n"), "rapid y=1\n");
  EXPECT_EQ(moved("G18\nG258 RPL=90\nG0 Z1\n"), "rapid x=1\n");
  EXPECT_EQ(moved("G19\nG258 RPL=90\nG0 Y1\n"), "rapid z=1\n");
  EXPECT_EQ(moved("G258 RPL=-270\nG0 X1\n"), "rapid y=1\n");
  EXPECT_EQ(moved("G258 RPL=360\nG0 X1\n"), "rapid x=1\n");
}

TEST(SinumerikFrames, RotationsAddAboutTheShiftedZero) {
  EXPECT_EQ(moved("G158 X10\nG259 RPL=45\nG259 RPL=45\nG0 X1 Y0\n"), "rapid x=10 y=1\n");
  EXPECT_EQ(moved("G158 X10\nG258 RPL=90\nG0 X1 Y0\n"), "rapid y=1\n");
  EXPECT_EQ(
      moved("G158 X10\nG258 RPL=90\nG0 X1 Y0\n", R"({"readings":{"sie.g258":"rotation-only"}})"),
      "rapid x=10 y=1\n");
  EXPECT_EQ(moved("G258 RPL=90\nG258\nG0 X1\n"), "rapid x=1\n");
  EXPECT_EQ(moved("G259 RPL=90\nG158 X10\nG0 X1\n"), "rapid x=11\n");
}

// The way there is (2, 12) in the frame, and the chord (7, 11) lies to its right.
TEST(SinumerikFrames, StayingInATurnedFrameHasNoDirection) {
  const std::string path =
      moved("G258 RPL=45\nG0 X1 Y2\nG1 X3 Y14 F90\nG258 RPL=45\nG1 X3 Y14\nCT X=IC(7) Y=IC(11)\n");
  EXPECT_NE(path.find("rot=-1"), std::string::npos) << path;
}

// The centres of the four slots of the third example: 35 sqrt(2) / 2 = 24.748737342 from (40, 45).
TEST(SinumerikFrames, TheSlotsOfTheExample) {
  EXPECT_EQ(moved("G19 G0\nG158 Y40 Z45\nG259 RPL45\nY35 Z0\nG259 RPL90\nY35 Z0\nG259 RPL=90\n"
                  "Y35 Z0\nG259 RPL 90\nY35 Z0\n"),
            "rapid y=64.748737342 z=69.748737342\nrapid y=15.251262658\n"
            "rapid z=20.251262658\nrapid y=64.748737342\n");
}

// What is not named stays where the tool is, seen from the new frame.
TEST(SinumerikFrames, TheToolStays) {
  EXPECT_EQ(moved("G0 X5 Y3\nG158 X10\nY1\n"), "rapid x=5 y=3\nrapid y=1\n");
  // At (5, 3), turned by 90 degrees: (3, -5).
  EXPECT_EQ(moved("G0 X5 Y3\nG258 RPL=90\nX0\n"), "rapid x=5 y=3\nrapid y=0\n");
  EXPECT_EQ(moved("G0 X5 Y3\nG258 RPL=90\nG91 X1\n"), "rapid x=5 y=3\nrapid y=4\n");
}

TEST(SinumerikFrames, ArcsAndPolesTurn) {
  EXPECT_EQ(moved("G258 RPL=90\nG2 X2 I1 F9\n"), "arc17 c=0,1 rot=-1 x=0 y=2 f=9\n");
  EXPECT_EQ(moved("G158 X10\nG0 RP=1 AP=0\n"), "rapid x=11\n");
  // CT goes on along +X, which is -Y of the turned workpiece: half a circle.
  EXPECT_EQ(moved("G1 X1 F9\nG258 RPL=90\nCT X2\n"),
            "feed x=1 f=9\narc17 c=1,1 rot=1 x=1 y=2 f=9\n");
}

TEST(SinumerikFrames, OtherPlanesAreRefusedUnderARotation) {
  EXPECT_EQ(alarm_and_block("G258 RPL=90\nG18\n"), "plane-not-allowed 2");
  EXPECT_EQ(alarm_and_block("G258 RPL=90\nG17\n"), "");
  EXPECT_EQ(alarm_and_block("G258 RPL=720\nG18\n"), "");
  EXPECT_EQ(alarm_and_block("G258 RPL=90\nG258\nG18\n"), "");
  EXPECT_EQ(alarm_and_block("G258 RPL=90\nG2 X4 Z0 I2 F9\n"), "plane-not-allowed 2");
}

TEST(SinumerikFrames, StandAlone) {
  for (const char* block :
       {"G158 X1 F5", "G158 G0", "G158 X1 RPL=3", "G158 A1", "G258 X1 RPL=3", "G258 RPL=3 M3",
        "G158 G4 F1", "G158 X=IC(1)", "G158 X1 R1=2", "RPL=3", "G0 RPL=3"}) {
    EXPECT_EQ(alarm_and_block(std::string(block) + "\n"), "conflicting-words 1") << block;
  }
  EXPECT_EQ(alarm_and_block("G158 G258\n"), "duplicate-word 1");
  EXPECT_EQ(alarm_and_block("G259\n"), "missing-word 1");
  EXPECT_EQ(alarm_and_block("N10 G158 X1 ; here\n"), "");
}

TEST(SinumerikFrames, TheEqualsOfRpl) {
  const Outcome lenient = run_sinumerik802s("G258 RPL90\nG0 X1\n");
  EXPECT_EQ(moving(lenient), "rapid y=1\n");
  EXPECT_EQ(alarm_and_block("G258 RPL90\n", R"({"readings":{"sie.rpl-equals":"required"}})"),
            "syntax 1");
  EXPECT_EQ(alarm_and_block("G258 RPL=90\n", R"({"readings":{"sie.rpl-equals":"required"}})"), "");
  EXPECT_EQ(moved("G258 RPL-90.0\nG0 X1\n"), "rapid y=-1\n");
  EXPECT_EQ(alarm_and_block("G258 RPL\n"), "syntax 1");
}

TEST(SinumerikFrames, Only802SHasThem) {
  EXPECT_EQ(run_sinumerik("G158 X1\n").alarm, "undefined-code");
  EXPECT_EQ(run_sinumerik("G258 RPL=1\n").answer, GONOGO_UNSUPPORTED);
  EXPECT_EQ(Session(R"({"readings":{"sie.g158":"absolute"}})", {}, "sinumerik").outcome().create,
            GONOGO_UNSUPPORTED);
}

}  // namespace
}  // namespace gonogo::expanders::testing
