// SPDX-License-Identifier: GPL-3.0-or-later
// How the expander of sinumerik840d reads lines.
#include <gtest/gtest.h>

#include "sinumerik_outcomes.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(SinumerikText, WordsMayTouch) {
  EXPECT_EQ(motions_and_alarm("G0X10Y20\n"), "rapid x=10 y=20\n");
  EXPECT_EQ(motions_and_alarm("R125=3R126=4G0X=R125Y=R126\n"), "rapid x=3 y=4\n");
  EXPECT_EQ(motions_and_alarm("G2X10CR=5F100\n"), "arc17 c=5,0 rot=-1 x=10 y=0 f=100\n");
  EXPECT_EQ(motions_and_alarm("CIPX10\n"), "");  // a name of the owner's: not implemented
}

TEST(SinumerikText, NumbersOfOneLetter) {
  EXPECT_EQ(motions_and_alarm("g00 x-.5 y+2. z=3 A= -4\n"), "rapid x=-0.5 y=2 z=3 a=-4\n");
  EXPECT_EQ(motions_and_alarm("G0 X 10 Y\t-2\n"), "rapid x=10 y=-2\n");
  for (const char* word : {"X", "X-", "X- 1", "X.", "X--1", "X1.2.3", "G=1", "L=5", "R5", "R5 3",
                           "X(5)", "#1", "X1 N5"}) {
    EXPECT_EQ(motions_and_alarm(word), "syntax") << word;
  }
}

TEST(SinumerikText, NamesNeedTheirEqualsSign) {
  for (const char* word : {"CR5", "CR 5", "AR90", "AP5", "RP5", "TURN2", "CR", "cr-5"}) {
    EXPECT_EQ(motions_and_alarm("G2 X10 F9 " + std::string(word)), "syntax") << word;
  }
  EXPECT_EQ(motions_and_alarm("G2 X10 F9 cr = 5"), "arc17 c=5,0 rot=-1 x=10 y=0 f=9\n");
}

TEST(SinumerikText, NamesMayBeginWithAnUnderscore) {
  EXPECT_EQ(motions_and_alarm("_CALL"), "");
  EXPECT_EQ(motions_and_alarm("_"), "syntax");
}

TEST(SinumerikText, HeadsOfLines) {
  EXPECT_EQ(
      motions_and_alarm("%_N_PART_MPF\n;$PATH=/_N_WKS_DIR\nN10 G0 X1\n:20 X2\n/N30 X3\n/8 N40 X4\n"
                        "N50 AGAIN: X5\nEND_1: X6\n"),
      "rapid x=1\nrapid x=2\nrapid x=3\nrapid x=4\nrapid x=5\nrapid x=6\n");
  EXPECT_EQ(motions_and_alarm("%_N_\xFF_MPF\nG0 X1\n"), "syntax");
  EXPECT_EQ(motions_and_alarm("%\n%_N_A_MPF\nN5\n%\nG0 X1\n%_N_B_SPF\nX2\n"), "rapid x=1\n");
  EXPECT_EQ(motions_and_alarm("%_N_PART_MPF ; \xFF\nG0 X1\n"), "rapid x=1\n");
  for (const char* line : {"N", "N-1", "N1.5", "N=1", "X1 / Y1", "/10 X1", "N10 / X1"}) {
    EXPECT_EQ(motions_and_alarm(line), "syntax") << line;
  }
}

TEST(SinumerikText, BlocksMayBeSkipped) {
  EXPECT_EQ(motions_and_alarm("/G0 X1\n/3 N5 G0 X2\nG0 X3\n", R"({"block_skip":true})"),
            "rapid x=3\n");
}

TEST(SinumerikText, AmpersandsAndWhatIsNotPrintedAreBlanks) {
  EXPECT_EQ(motions_and_alarm("\x02G0&X1\x7FY=&2&\x1A\n&\n"), "rapid x=1 y=2\n");
  EXPECT_EQ(motions_and_alarm("%_N_\x02_MPF\nMSG(\x03)\nG0 X1\n"), "rapid x=1\n");
  EXPECT_EQ(motions_and_alarm("G0 X1&2\n"), "syntax");
}

TEST(SinumerikText, CommentsHoldAnything) {
  EXPECT_EQ(motions_and_alarm("G0 X1 ; (\xE5\x88\x80 \xB5\xB6 \"\n; X2\n\n"), "rapid x=1\n");
  EXPECT_EQ(motions_and_alarm("G0 X1 (comment)\n"), "syntax");
  EXPECT_EQ(motions_and_alarm("G0 X\xE2\x80\x93"
                              "1\n"),
            "syntax");
  EXPECT_EQ(motions_and_alarm("G0 X1\xFF\n"), "syntax");
}

TEST(SinumerikText, CallsThatAreIgnored) {
  const Outcome outcome =
      run_sinumerik("MSG(\"A ; ) \xE5\x88\x80\")\nG0 SOFT X1 LIMS=3000 H5=12\n");
  EXPECT_EQ(outcome.motions(), "rapid x=1\n");
  EXPECT_EQ(outcome.note, "LIMS is ignored.");
  EXPECT_EQ(motions_and_alarm("MSG(\"A\"\n"), "syntax");
  EXPECT_EQ(motions_and_alarm("MSG(\"A)\n"), "syntax");
}

TEST(SinumerikText, LineEnds) {
  const Outcome outcome = run_sinumerik("\nG0 X1\r\n\rX2");
  EXPECT_EQ(outcome.motions(), "rapid x=1\nrapid x=2\n");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{2, 4, 4}));
}

TEST(SinumerikText, LongLines) {
  EXPECT_EQ(motions_and_alarm("G0 X1 " + std::string(100'000, ' ') + "Y1\n"), "rapid x=1 y=1\n");
  EXPECT_EQ(motions_and_alarm("G0 X1 " + std::string(std::size_t{1} << 20, ' ') + "\n"), "syntax");
}

TEST(SinumerikText, WhatIsNotImplemented) {
  for (const char* block :
       {"G41", "G505", "G153 X1", "TRANS X1", "CYCLE81(1,2)", "LCYC840", "L10", "P2", "B5", "X1=5",
        "S2=100", "M2=3", "RPL45", "RPL=45", "RND=2", "G0 X1 FGROUP(X,Y)", "G2 X1 X2 TRANS"}) {
    const Outcome outcome = run_sinumerik(block);
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << block;
    EXPECT_NE(outcome.note.find("is not implemented"), std::string::npos) << block;
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
