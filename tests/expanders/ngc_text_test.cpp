// SPDX-License-Identifier: GPL-3.0-or-later
// The text of rs274 programs, and the life of a subject.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

using namespace std::string_literals;

TEST(NgcText, TapeMarks) {
  EXPECT_EQ(run_ngc("%\nG0 X2\n%\nX4\n").motions(), "rapid x=2\n");
  EXPECT_EQ(run_ngc("%\n(head)\n%\nG0 X4\n").motions(), "");
  EXPECT_EQ(run_ngc(" \n\n\t%\nG0 X4\n % \nG0 (\n").all(), run_ngc("\n\n%\nG0 X4\n%\n").all());
}

TEST(NgcText, ATapeMarkStandsFirstOrSecond) {
  for (const char* text : {"G0 X1\n%\n", "(a)\n%\n", ";\n%\n", "N1\n%\n", "/\n%\n", "O1\n%\n"}) {
    EXPECT_EQ(run_ngc(text).alarm, "syntax") << text;
  }
  EXPECT_EQ(run_ngc("/G0\n%\n", R"({"block_skip":true})").alarm, "syntax");
}

TEST(NgcText, TheEndOfAProgram) {
  constexpr const char* kNeeded = R"({"readings":{"ngc.program-end":"needed"}})";
  for (const char* text : {"", "\n", "(a)\n", "G0 X1\n", "%\nG0 X1\n", "M0\n", "(M2)\n"}) {
    EXPECT_EQ(run_ngc(text, kNeeded).alarm, "program-end") << text;
    EXPECT_EQ(run_ngc(text).alarm, "") << text;
  }
  EXPECT_EQ(run_ngc("", kNeeded).alarm_block, 1u);
  EXPECT_EQ(run_ngc("G0 X1\n\n(a)\n", kNeeded).alarm_block, 3u);
  for (const char* text : {"M2\n", "m 3 0", "G0 X1 M02\n", "%\nG0 X1\n%\n"}) {
    EXPECT_EQ(run_ngc(text, kNeeded).alarm, "") << text;
  }
}

TEST(NgcText, LineNumbers) {
  constexpr const char* kWholeNumbers = R"({"readings":{"ngc.line-number":"whole"}})";
  for (const char* number : {"N10.5", "N0.0", "N100000", "N99999999999999999999"}) {
    EXPECT_EQ(run_ngc(number + " G0 X1\n"s).motions(), "rapid x=1\n") << number;
    EXPECT_EQ(run_ngc(number + " G0 X1\n"s, kWholeNumbers).alarm, "syntax") << number;
    EXPECT_EQ(run_ngc(number + "\n"s, kWholeNumbers).alarm, "syntax") << number;
    EXPECT_EQ(run_ngc(number + " G87 X1\n"s, kWholeNumbers).answer, GONOGO_UNSUPPORTED) << number;
  }
  EXPECT_EQ(run_ngc("N99999 G0 X1\n", kWholeNumbers).motions(), "rapid x=1\n");
}

// What no text decides, as the other alternatives have it.
TEST(NgcText, OtherInterpreters) {
  const auto with = [](const std::string& reading, const std::string& program) {
    return run_ngc(program, R"({"block_skip":true,"readings":{)" + reading + "}}");
  };
  EXPECT_EQ(run_ngc("T5\nG0 X1\n").motions(), "rapid x=1\n");
  EXPECT_EQ(with(R"("ngc.missing-tool":"alarm")", "T0\nT5\n").alarm, "no-tool");
  EXPECT_EQ(with(R"("ngc.g94-feed":"none")", "F9\nG94\nG1 X1\n").alarm, "feed-missing");
  EXPECT_EQ(with(R"("ngc.feed-units":"after")", "G20 G1 X1 F10\n").records,
            run_ngc("G20\nG1 X1 F10\n").records);
  EXPECT_EQ(with(R"("ngc.block-delete":"read")", "/G0 X1\n/X\n").alarm_block, 2U);
  const std::string dwells = R"("ngc.alarm-dwell":"dwells")";
  EXPECT_EQ(with(dwells, "G4 P1 G1 X1\n").records.size(), 1U);
  EXPECT_EQ(with(dwells, "G4 P1 G81\n").records.size(), 0U);
  EXPECT_EQ(run_ngc("G4 P1 G1 X1\n").records.size(), 0U);
  EXPECT_EQ(with(R"("ngc.lone-cr":"blank")", "G0 X1\r0\r\nX2\n").motions(),
            "rapid x=10\nrapid x=2\n");
}

TEST(NgcText, Names) {
  constexpr const char* kRefused = R"({"readings":{"ngc.o-name":"syntax"}})";
  for (const char* name : {"O0002 (TEXT)", "o2", "O 0 2 (a) ; b"}) {
    EXPECT_EQ(run_ngc(name + "\nG0 X1\n"s).motions(), "rapid x=1\n") << name;
    EXPECT_EQ(run_ngc(name + "\nG0 X1\n"s, kRefused).alarm, "syntax") << name;
  }
}

TEST(NgcText, LettersAndBlanksAreFree) {
  EXPECT_EQ(run_ngc("n10g 0x 1.5 Y\t-2z+.5\n").motions(), "rapid x=1.5 y=-2 z=0.5\n");
  EXPECT_EQ(run_ngc("N 1 0 G 0 X 1 5 Y- 2 Z1\t. 5\n").motions(), "rapid x=15 y=-2 z=1.5\n");
}

TEST(NgcText, CodesMayHaveZeros) {
  EXPECT_EQ(run_ngc("G01 X1 F9\nG90.10 G00 X2 M03.0\n").motions(),
            "feed x=1 f=9\nm 3\nrapid x=2\n");
}

TEST(NgcText, Comments) {
  EXPECT_EQ(run_ngc("G0 (\xd6\xd0 #1) X2 ; O100 [\n").motions(), "rapid x=2\n");
}

TEST(NgcText, BlocksAreLines) {
  const Outcome outcome = run_ngc("\n\rG0 X2\r\n\r\nX4\nX6");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{3, 5, 6, 6}));
}

TEST(NgcText, WhatCannotBeRead) {
  const std::string texts[] = {"X",       "X--1",   "X.",      "X1.2.3",  "5",    "X1 (a",
                               "N1.",     "*",      "X1%",     "X1 / Y2", "% X1", "%12",
                               "X1 \x80", "X=1",    "X1\0"s,   "X1 @",    "$X1",  "ABC",
                               "X1 N2",   "X1(a)2", "X1e2.5.1"};
  for (const std::string& text : texts) {
    EXPECT_EQ(run_ngc("G0 Z1\n" + text + "\n").alarm, "syntax") << text;
  }
}

TEST(NgcText, OutsideConstructs) {
  for (const char* text : {"O100 sub", "o<name> call", "O1 X2", "N1 O1", "(a) O1", "#1=5", "#<a>=1",
                           "X#1", "X-#<a>", "X [1+2]", "@[1+2]", "X1 ^#1", "G33 Z1 $ 1", "xsin[30]",
                           "N5 O2 if [1]", "N9 #2=1", "[1]", "X1 Y#2"}) {
    const Outcome outcome = run_ngc("G0 Z1\n"s + text + "\n");
    EXPECT_EQ(outcome.answer, GONOGO_UNSUPPORTED) << text;
    EXPECT_EQ(outcome.motions(), "rapid z=1\n") << text;
  }
}

TEST(NgcText, BlockDelete) {
  EXPECT_EQ(run_ngc("/G0 X2\nX4\n").motions(), "rapid x=2\nrapid x=4\n");
  EXPECT_EQ(run_ngc("G0 X1\n/X2\nX4\n", R"({"block_skip":true})").motions(),
            "rapid x=1\nrapid x=4\n");
}

TEST(NgcText, RandomBytesEndOrderly) {
  std::mt19937 random(20261121);
  const std::string letters = "GGGGXYZACIJKRPFMNO0123456789.-+ ();/%#[\n\n\r\xff";
  for (int i = 0; i < 20'000; ++i) {
    std::string text = "G1 F9\n";
    for (std::size_t size = random() % 60; size > 0; --size) {
      text += letters[random() % letters.size()];
    }
    const Outcome outcome = Session("{}", {}, "ngc").run(text, 1'000);
    EXPECT_NE(outcome.answer, GONOGO_ERROR) << text;
    EXPECT_EQ(outcome.alarms, outcome.answer == GONOGO_ALARM ? 1u : 0u) << text;
  }
}

TEST(NgcSubject, DescribesItself) {
  const gonogo_text text = find("ngc")->describe();
  const auto json = nlohmann::json::parse(text.data, text.data + text.size);
  const std::vector<std::string> features = {
      "basic",  "arc",         "arc-r",       "planes",       "helix", "arc-distance", "turns",
      "lines",  "g81",         "g73",         "g83",          "g84",   "g74",          "g85",
      "g86",    "cycle-modal", "cycle-steps", "cycle-planes", "g33",   "g33.1",        "g76",
      "rotary", "feed-modes",  "linuxcnc",    "polar-words"};
  EXPECT_EQ(json["dialects"]["rs274"], features);
}

TEST(NgcSubject, EveryRunStartsFromPowerOn) {
  Session session("{}", {}, "ngc");
  const std::string program = "G0 X5 Z1\nG1 X1 Z-2 F9\n";
  const std::string first = session.run(program).all();
  session.run("G20 G18 G91 G90.1 G1 X1 F3\n");
  EXPECT_EQ(session.run(program).all(), first);
  EXPECT_EQ(session.run("X1\n").alarm, "missing-word");
}

TEST(NgcSubject, StopsAtOnceWhenTheSinkSaysSo) {
  for (std::size_t most = 1; most <= 6; ++most) {
    const std::string program = "M3 G4 P1 G0 X1 M1\nG2 X5 I2 F9\nM2\n";
    const Outcome outcome = Session("{}", {}, "ngc").run(program, most);
    EXPECT_EQ(outcome.answer, GONOGO_STOPPED);
    EXPECT_EQ(outcome.records.size(), most);
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
