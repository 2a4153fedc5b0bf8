// SPDX-License-Identifier: GPL-3.0-or-later
// Alarms of G114 to G117 at their boundaries, each before any motion of its block.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

// What a block of these words ends with: "" or the alarm's class, after one motion only.
std::string thread(const std::string& words, const std::string& profile = "{}") {
  const Outcome outcome = run("G0 X7 Y50\n" + words + "\n", profile);
  if (outcome.alarms == 0) return "";
  EXPECT_EQ(outcome.alarms, 1u);
  EXPECT_EQ(outcome.alarm_block, 2u);
  EXPECT_EQ(outcome.motions(), "rapid x=3.5 y=50\n");
  return outcome.alarm;
}

std::string thread_with_reading(const std::string& reading, const std::string& value,
                                const std::string& words) {
  return thread(words, R"({"readings":{")" + reading + R"(":")" + value + "\"}}");
}

TEST(GskThreadAlarm, EveryMillingBlockGivesIEPD) {
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P1 D3 F9"), "");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 E30 P1 D3 F9"), "missing-word");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 P1 D3 F9"), "missing-word");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 D3 F9"), "missing-word");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P1 F9"), "missing-word");
  const Outcome second = run("G114 X0 Z0 V-5 I5 E30 P1 D3 F9\nX0 Z0 V-5 I5 E30 P1\n");
  EXPECT_EQ(second.alarm, "missing-word");
  EXPECT_EQ(second.alarm_block, 2u);
}

TEST(GskThreadAlarm, BlocksThatMillNothingNeedNoWords) {
  EXPECT_EQ(thread("G114"), "");
  EXPECT_EQ(thread("G116 X1 Z1"), "");
}

TEST(GskThreadAlarm, WordsMustBeAboveZero) {
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I0 E30 P1 D3 F9"), "value-out-of-range");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E0 P1 D3 F9"), "value-out-of-range");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P0 D3 F9"), "value-out-of-range");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P1 D0 F9"), "value-out-of-range");
}

TEST(GskThreadAlarm, UnsignedWordsTakeNoMinus) {
  for (const char* word : {"I-5", "J-1", "K-1", "E-30", "P-1", "Q-1", "D-3"}) {
    EXPECT_EQ(thread(std::string("G114 ") + word), "value-out-of-range") << word;
  }
  EXPECT_EQ(thread("G114 R-1"), "");
}

TEST(GskThreadAlarm, HeightMayEqualTheToolRadius) {
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P3 D3 F9"), "");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P3.001 D3 F9"), "depth-exceeds-tool");
  EXPECT_EQ(thread("G117 X0 Z0 V-5 I5 E30 P3 D3 F9"), "");
  EXPECT_EQ(thread("G117 X0 Z0 V-5 I5 E30 P3.000000001 D3 F9"), "depth-exceeds-tool");
}

TEST(GskThreadAlarm, ToolMustBeSmallerThanTheBore) {
  EXPECT_EQ(thread("G116 X0 Z0 V-5 I5 E6.001 P1 D3 F9"), "");
  EXPECT_EQ(thread("G116 X0 Z0 V-5 I5 E6 P1 D3 F9"), "tool-too-large");
  EXPECT_EQ(thread("G116 X0 Z0 V-5 I5 E5.999 P1 D3 F9"), "tool-too-large");
  // Half of E is no whole count here; nothing is rounded.
  EXPECT_EQ(thread("G117 X0 Z0 V-5 I5 E6.000000001 P1 D3 F9"), "");
  // Outside there is room.
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E6 P1 D3 F9"), "");
  EXPECT_EQ(thread("G115 X0 Z0 V-5 I5 E0.001 P1 D3 F9"), "");
}

TEST(GskThreadAlarm, AngleReachesAFullCircle) {
  EXPECT_EQ(thread("G114 K360"), "");
  EXPECT_EQ(thread("G114 K360.001"), "value-out-of-range");
  EXPECT_EQ(thread_with_reading("gsk.thread.k-range", "table", "G114 K999999.999"), "");
  EXPECT_EQ(thread_with_reading("gsk.thread.k-range", "table", "G114 K1000000"),
            "value-out-of-range");
  // In inches an angle is an angle.
  EXPECT_EQ(thread("G20 G114 K360"), "");
  EXPECT_EQ(thread("G20 G114 K360.0001"), "value-out-of-range");
}

TEST(GskThreadAlarm, DirectionAsTheReadingSays) {
  EXPECT_EQ(thread("G114 X0 Z0 V-5 R0.001 I5 E30 P1 D3 F9"), "direction-conflict");
  EXPECT_EQ(thread("G114 X0 Z0 V-5 R0 I5 E30 P1 D3 F9"), "");
  EXPECT_EQ(
      thread_with_reading("gsk.thread.direction", "free", "G114 X0 Z0 V-5 R1 I5 E30 P1 D3 F9"), "");
}

TEST(GskThreadAlarm, RAsTheReadingSays) {
  const std::string words = " X0 Z0 V-5 I5 E30 P1 D3 F9";
  EXPECT_EQ(thread_with_reading("gsk.thread.r", "optional", "G116" + words), "");
  EXPECT_EQ(thread_with_reading("gsk.thread.r", "required", "G116" + words), "missing-word");
  EXPECT_EQ(thread_with_reading("gsk.thread.r", "required", "G117" + words + " R0"), "");
  EXPECT_EQ(thread_with_reading("gsk.thread.r", "required", "G114" + words), "");
}

TEST(GskThreadAlarm, CutsNeedAFeed) {
  EXPECT_EQ(thread("G114 X0 Z0 V-5 I5 E30 P1 D3"), "feed-missing");
  EXPECT_EQ(thread("G114 X0 Z0 V0 I5 E30 P1 D3"), "");
}

TEST(GskThreadAlarm, CycleCodeBesideAMotionCode) {
  EXPECT_EQ(thread("G01 G116 X0"), "conflicting-words");
  EXPECT_EQ(thread("G90 G112 X0"), "conflicting-words");
}

TEST(GskThreadAlarm, RangeEndsAreInclusive) {
  EXPECT_EQ(thread("G114 E999999.999"), "");
  EXPECT_EQ(thread("G114 E1000000"), "value-out-of-range");
  EXPECT_EQ(thread("G20 G114 J99999.9999"), "");
  EXPECT_EQ(thread("G20 G114 J100000"), "value-out-of-range");
}

}  // namespace
}  // namespace gonogo::expanders::testing
