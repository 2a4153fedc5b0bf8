// SPDX-License-Identifier: GPL-3.0-or-later
// The text of HNC programs, and the life of a subject.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "expanders/registry.hpp"
#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

using namespace std::string_literals;

TEST(HncText, ProgramHeads) {
  EXPECT_EQ(run_hnc("%\nO0230\nG00 X2\n%\nX4\n").motions(), "rapid x=1\n");
  EXPECT_EQ(run_hnc("%3341\nN1G00X2\n").motions(), "rapid x=1\n");
  EXPECT_EQ(run_hnc("O3338\nN01 G00 X2\nM30\nX4\n").motions(), "rapid x=1\nm 30\n");
}

TEST(HncText, WordsMayRunTogetherOrApart) {
  EXPECT_EQ(run_hnc("G80X-4Z-30I-8.5F 40").records[0], "rapid x=-10.5");
  EXPECT_EQ(run_hnc("g80x-4Z-30I-8.5F 40").alarm, "syntax");
}

TEST(HncText, Comments) {
  EXPECT_EQ(run_hnc("G00 (\xd6\xd0 #1) X2 ; WHILE [\n").motions(), "rapid x=1\n");
}

TEST(HncText, BlocksAreLines) {
  const Outcome outcome = run_hnc("\n\rG00 X2\r\n\r\nX4\nX6");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{3, 5, 6, 6}));
}

TEST(HncText, WhatCannotBeRead) {
  const std::string texts[] = {"X",    "X--1",    "X.",      "X1.2.3", "5",   "X1 (a",
                               "N1.5", "*",       "X1 / Y2", "% X1",   "N5.", "O0230.",
                               "N+5",  "X1 \x80", "X=1",     "X1\0"s,  "ABC"};
  for (const std::string& text : texts) {
    EXPECT_EQ(run_hnc("G00 Z1\n" + text + "\n").alarm, "syntax") << text;
  }
}

TEST(HncText, BlockSkip) {
  EXPECT_EQ(run_hnc("/G00 X2\nX4\n", R"({"block_skip":true})").motions(), "rapid x=2\n");
  EXPECT_EQ(run_hnc("/G00 X2\n").motions(), "rapid x=1\n");
}

TEST(HncText, RandomBytesEndOrderly) {
  std::mt19937 random(20261121);
  const std::string letters = "GGGXZUWRIKEQCPFJM0123456789.-+ ();/%#[\n\n\r\xff";
  for (int i = 0; i < 20'000; ++i) {
    std::string text = "G00 F9\n";
    for (std::size_t size = random() % 60; size > 0; --size) {
      text += letters[random() % letters.size()];
    }
    const Outcome outcome = Session("{}", {}, "hnc").run(text, 1'000);
    EXPECT_NE(outcome.answer, GONOGO_ERROR) << text;
    EXPECT_EQ(outcome.alarms, outcome.answer == GONOGO_ALARM ? 1u : 0u) << text;
  }
}

TEST(HncSubject, DescribesItself) {
  const gonogo_text text = find("hnc")->describe();
  const auto json = nlohmann::json::parse(text.data, text.data + text.size);
  const std::vector<std::string> features = {"basic", "arc", "g32", "g74",
                                             "g75",   "g80", "g81", "g82"};
  EXPECT_EQ(json["dialects"]["hnc21t"], features);
}

TEST(HncSubject, EveryRunStartsFromPowerOn) {
  Session session("{}", {}, "hnc");
  const std::string program = "G00 X5 Z1\nG80 X1 Z-2 F9\n";
  const std::string first = session.run(program).all();
  session.run("G20 G37 G91 G95 G55 G82 X5 Z1 I3 F2\n");
  EXPECT_EQ(session.run(program).all(), first);
}

TEST(HncSubject, StopsAtOnceWhenTheSinkSaysSo) {
  for (std::size_t most = 1; most <= 12; ++most) {
    const std::string program = "G74 Z-2 R1 Q1 F9\nG75 X-2 Z-1 I1\nM3\nG82 X-2 Z-1 F1\n";
    const Outcome outcome = Session("{}", {}, "hnc").run(program, most);
    EXPECT_EQ(outcome.answer, GONOGO_STOPPED);
    EXPECT_EQ(outcome.records.size(), most);
  }
}

}  // namespace
}  // namespace gonogo::expanders::testing
