// SPDX-License-Identifier: GPL-3.0-or-later
// The text of programs: blocks, comments, line ends, and what cannot be read.
#include <gtest/gtest.h>

#include <random>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

using namespace std::string_literals;

TEST(GskText, EveryLineEndCounts) {
  const Outcome outcome = run("\n\rG0 X2\r\n\r\nX4\nX6");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{3, 5, 6, 6}));
}

TEST(GskText, NumberProgramNumberAndComments) {
  EXPECT_EQ(
      run("%\nO0001(A;B)\nN0010 G00(\xd0\xc2\xe5\x8a) X2 ; G999 )(\nN20G1X4F9\n%\nX9\n").motions(),
      "rapid x=1\nfeed x=2 f=9\n");
}

TEST(GskText, SmallLettersAreNoAddresses) {
  EXPECT_EQ(run("G00 X2\ng1 x4 f9\n").alarm, "syntax");
}

TEST(GskText, BlockSkip) {
  EXPECT_EQ(run("/N1 G0 X2\n/\n").motions(), "rapid x=1\n");
  EXPECT_EQ(run("/N1 G0 X2\nX4\n", R"({"block_skip":true})").motions(), "rapid x=2\n");
}

TEST(GskText, FormsOfNumbers) {
  EXPECT_EQ(run("G000 X+2. Z-.5 Y 007\n").motions(), "rapid x=1 y=7 z=-0.5\n");
}

TEST(GskText, WhatCannotBeRead) {
  const std::string texts[] = {
      "X",   "X--1", "X.",  "X1.2.3",       "5",     "X1 (a",   "X1 )",  "N1.5", "G0 N5", "X1 / Y2",
      "X#1", "X[1]", "X=1", "\xef\xbc\x9b", "X1\0"s, "X1 \x80", "N5 N6", "% X1", "X1 *2", "N-1"};
  for (const std::string& text : texts) {
    const Outcome outcome = run("G0 Z1\n" + text + "\n");
    EXPECT_EQ(outcome.alarm, "syntax") << text;
    EXPECT_EQ(outcome.alarm_block, 2u) << text;
  }
}

TEST(GskText, SyntaxHidesTheOtherRulesOfItsBlock) {
  EXPECT_EQ(run("G999 X1 X1 Y\n").alarm, "syntax");
}

TEST(GskText, LinesUpToAMebibyte) {
  const std::string filler(1'048'576 - 6, ' ');
  EXPECT_EQ(run("G0 X2 " + filler + "\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G0 X2  " + filler + "\n").alarm, "syntax");
}

TEST(GskText, TenThousandWords) {
  std::string text;
  for (int i = 0; i < 10'000; ++i) text += "X" + std::to_string(i) + " ";
  EXPECT_EQ(run("G0 " + text).alarm, "duplicate-word");
  EXPECT_EQ(run("G0 " + text, R"({"readings":{"gsk.duplicate":"last"}})").motions(),
            "rapid x=4999.5\n");
}

TEST(GskText, TenThousandDigits) {
  const std::string nines(10'000, '9');
  const std::string zeros(10'000, '0');
  EXPECT_EQ(run("G0 X" + nines).alarm, "value-out-of-range");
  EXPECT_EQ(run("G0 X-" + nines).alarm, "value-out-of-range");
  EXPECT_EQ(run("G" + nines).alarm, "undefined-code");
  EXPECT_EQ(run("M" + nines).alarm, "value-out-of-range");
  EXPECT_EQ(run("N" + nines + " S" + nines + " T" + nines).answer, GONOGO_OK);
  EXPECT_EQ(run("G0 X" + zeros + "2." + zeros).motions(), "rapid x=1\n");
  EXPECT_EQ(run("G0 Z0." + nines).motions(), "rapid z=1\n");
}

TEST(GskText, RandomBytesEndOrderly) {
  std::mt19937 random(20261121);
  const std::string letters = "GXYZUVWRILQDPFMNO0123456789.-+ ();/%\n\r\xff";
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (std::size_t size = random() % 60; size > 0; --size)
      text += letters[random() % letters.size()];
    const Outcome outcome = Session().run(text, 1'000);
    EXPECT_NE(outcome.answer, GONOGO_ERROR) << text;
    EXPECT_EQ(outcome.alarms, outcome.answer == GONOGO_ALARM ? 1u : 0u) << text;
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
