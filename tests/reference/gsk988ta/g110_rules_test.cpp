// SPDX-License-Identifier: GPL-3.0-or-later
//
// G110 and G111: what is refused, at the boundary, one least increment below and above it; what is
// retained.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

constexpr std::string_view kDone = "end x25 y50 z50 a0 c0";

// A pocket in G18 from the initial plane Y50, down from there, with these words beside the centre.
std::string pocket(const std::string& words, const Profile& profile = {}) {
  return ending("G0 Y50\nG110 X50 Z50 F800 " + words, profile, OpenPaths::judged);
}

TEST(G110Rules, Clause02EachOfILQDIsNeededAtTheEntry) {
  EXPECT_EQ(pocket("Y20 L3 Q5 D4"), "alarm b2 missing-word");
  EXPECT_EQ(pocket("Y20 I16 Q5 D4"), "alarm b2 missing-word");
  EXPECT_EQ(pocket("Y20 I16 L3 D4"), "alarm b2 missing-word");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5"), "alarm b2 missing-word");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4"), kDone);
}

TEST(G110Rules, Clause02NamesEachMissingWord) {
  const std::vector<Item> items = expand("G110 X50 Z50 Y-1 F800");
  std::string missing;
  for (const Alarm& alarm : std::get<AlarmReport>(items.back()).alarms) {
    EXPECT_EQ(alarm.alarm, AlarmClass::missing_word);
    missing += alarm.word.text();
  }
  EXPECT_EQ(missing, "ILQD");
}

TEST(G110Rules, Clause02ILQDAreRetained) {
  const std::string entry = "G110 X50 Z50 Y-5 I16 L3 Q5 D4 F800\n";
  const Lines both = lines(entry + "X80 Z10 Y-5", {}, OpenPaths::judged);
  ASSERT_EQ(both.size(), 14U);
  EXPECT_EQ(both[10], "level d-5 c10,40 R16 r4 L3 -1 f800");
}

TEST(G110Rules, Clause02ANewWordReplacesTheRetainedOne) {
  const std::string entry = "G110 X50 Z50 Y-5 I16 L3 Q5 D4 F800\n";
  const Lines both = lines(entry + "X80 Z10 Y-2 I20 L2.5 Q1 D5", {}, OpenPaths::judged);
  ASSERT_EQ(both.size(), 19U);  // two layers now
  EXPECT_EQ(both[9], "feed y-1 f800");
  EXPECT_EQ(both[10], "level d-1 c10,40 R20 r5 L2.5 -1 f800");
}

TEST(G110Rules, Clause03IIsLargerThanD) {
  EXPECT_EQ(pocket("Y20 I3.999 L3 Q5 D4"), "alarm b2 tool-too-large");
  EXPECT_EQ(pocket("Y20 I4 L3 Q5 D4"), "alarm b2 tool-too-large");
  EXPECT_EQ(pocket("Y20 I4.001 L3 Q5 D4"), kDone);
}

TEST(G110Rules, Clause03LIsSmallerThanTwiceD) {
  EXPECT_EQ(pocket("Y20 I16 L7.999 Q5 D4"), kDone);
  EXPECT_EQ(pocket("Y20 I16 L8 Q5 D4"), "alarm b2 step-too-large");
  EXPECT_EQ(pocket("Y20 I16 L8.001 Q5 D4"), "alarm b2 step-too-large");
}

TEST(G110Rules, Clause03InTheIncrementsOfTheOtherSystems) {
  Profile isc;
  isc.increment = Increment::isc;
  EXPECT_EQ(pocket("Y20 I4.0001 L7.9999 Q5 D4", isc), kDone);
  const std::string inch = "G20 G110 X0 Z0 Y-1 Q1 F10 ";
  EXPECT_EQ(ending(inch + "I0.5 L0.1 D0.5"), "alarm b1 tool-too-large");
  EXPECT_EQ(ending(inch + "I0.5001 L0.9999 D0.5"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending(inch + "I0.6 L1 D0.5"), "alarm b1 step-too-large");
}

TEST(G110Rules, Clause03LooksAtRetainedWordsToo) {
  const std::string entry = "G110 X50 Z50 Y-5 I16 L3 Q5 D4 F800\n";
  EXPECT_EQ(ending(entry + "X50 Z50 Y-5 D16", {}, OpenPaths::judged), "alarm b2 tool-too-large");
  EXPECT_EQ(ending(entry + "X50 Z50 Y-5 D1.5", {}, OpenPaths::judged), "alarm b2 step-too-large");
}

TEST(G110Rules, Clause04RAndTheDepthHaveOneDirection) {
  const std::string words = " I16 L3 Q5 D4";
  EXPECT_EQ(pocket("V10 R-0.001" + words), "alarm b2 direction-conflict");
  EXPECT_EQ(pocket("V10 R0" + words), kDone);
  EXPECT_EQ(pocket("V10 R0.001" + words), kDone);
  EXPECT_EQ(pocket("V-10 R0.001" + words), "alarm b2 direction-conflict");
  EXPECT_EQ(pocket("V-10 R0" + words), kDone);
  EXPECT_EQ(pocket("V-10 R-0.001" + words), kDone);
  EXPECT_EQ(pocket("V10" + words), kDone);
  EXPECT_EQ(pocket("V-10" + words), kDone);
}

TEST(G110Rules, Clause04TheDirectionOfAnAbsoluteDepthIsThatFromTheRPlane) {
  // The R plane of R-5 is Y45.
  const std::string words = " R-5 I16 L3 Q5 D4";
  EXPECT_EQ(pocket("Y44.999" + words), kDone);
  EXPECT_EQ(pocket("Y45" + words), kDone);  // GSK-G110-17: no depth, no direction
  EXPECT_EQ(pocket("Y45.001" + words), "alarm b2 direction-conflict");
}

TEST(G110Rules, Com04ThePocketNeedsAFeed) {
  EXPECT_EQ(ending("G110 X50 Z50 Y-5 I16 L3 Q5 D4"), "alarm b1 feed-missing");
  EXPECT_EQ(ending("F800\nG110 X0 Z0 Y-5 I16 L3 Q5 D4"), "end x0 y0 z0 a0 c0");
}

TEST(G110Rules, Clause14ABlockThatLacksAnAxisMovesNothing) {
  const std::string entry = "G110 I16 L3 Q5 D4 F800\n";
  for (const char* words : {"X50 Z50", "X50 Y-5", "Z50 Y-5", "X50", "Z50", "Y-5", "R-5", "C90"}) {
    EXPECT_TRUE(lines(entry + words).empty()) << words;
    EXPECT_TRUE(lines(entry + words, profile_with({{"gsk.missing-axis", "skip"}})).empty())
        << words;
  }
}

TEST(G110Rules, ReadingMissingAxisPositionMovesThePlaneAxes) {
  const std::string entry = "G110 I16 L3 Q5 D4 F800\n";
  const Profile position = profile_with({{"gsk.missing-axis", "position"}});
  EXPECT_EQ(lines(entry + "X50 Z50", position), Lines{"rapid x25 z50"});
  EXPECT_EQ(lines(entry + "X50 Y-5", position), Lines{"rapid x25"});
  EXPECT_EQ(lines(entry + "W-5", position), Lines{"rapid z-5"});
  EXPECT_TRUE(lines(entry + "Y-5", position).empty());
}

// The tool stands at the origin, and R leads from there.
TEST(G110Rules, ReadingMissingAxisCurrentMillsWhereTheToolStands) {
  const std::string entry = "G110 I16 L3 Q5 D4 F800\n";
  const Profile current = profile_with({{"gsk.missing-axis", "current"}});
  const auto milled = [&](const char* words) {
    return lines(entry + words, current, OpenPaths::judged);
  };
  EXPECT_EQ(milled("X50 Y-5"),
            (Lines{"rapid x25", "rapid y0", "feed y-5 f800", "level d-5 c0,25 R16 r4 L3 -1 f800",
                   "rapid y0", "rapid x25 z0", "rapid y0"}));
  EXPECT_EQ(milled("Y-7 R-2"),
            (Lines{"rapid y-2", "feed y-7 f800", "level d-7 c0,0 R16 r4 L3 -1 f800", "rapid y-2",
                   "rapid x0 z0", "rapid y0"}));
  for (const char* words : {"X50 Z50", "X50", "R-5", "C90"}) {
    EXPECT_TRUE(milled(words).empty()) << words;
  }
  EXPECT_EQ(ending("G110 I16 L3 Q5 D4\nY-5", current), "alarm b2 feed-missing");
}

TEST(G110Rules, Clause14TheAxisWordsAreNotRetained) {
  EXPECT_EQ(lines("G110 X50 Z50 Y-5 I16 L3 Q5 D4 F800\nX60 Z60\nQ2", {}, OpenPaths::judged).size(),
            7U);
}

TEST(G110Rules, Clause16ILQDAreAboveZero) {
  EXPECT_EQ(pocket("Y20 I16 L0 Q5 D4"), "alarm b2 value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L0.001 Q5 D4"), kDone);
  EXPECT_EQ(pocket("Y20 I16 L3 Q0 D4", profile_with({{"gsk.pocket.q-zero", "alarm"}})),
            "alarm b2 value-out-of-range");
  // Y49.999: one layer of one increment.
  EXPECT_EQ(pocket("Y49.999 I16 L3 Q0.001 D4"), kDone);
  EXPECT_EQ(pocket("Y20 I0.002 L0.001 Q5 D0.001"), kDone);
}

TEST(G110Rules, Clause20AnInfeedOfZeroIsOneLayerUnderItsReading) {
  const Lines got = lines("G110 X50 Z50 Y-5 R-2 I16 L3 Q0 P1 D4 F800",
                          profile_with({{"gsk.pocket.q-zero", "one-layer"}}), OpenPaths::judged);
  EXPECT_EQ(
      got, (Lines{"rapid x25 z50", "rapid y-2", "feed y-5 f800",
                  "level d-5 c50,25 R16 r4 L3 -1 f800", "rapid y-2", "rapid x25 z50", "rapid y0"}));
}

// The layers end 5 and 7.5 below the R plane at -2: P8 is 3 beyond it.
TEST(G110Rules, Clause11PLeadsBeyondTheRPlaneUnderItsReading) {
  const std::string block = "G110 X50 Z50 Y-9.5 R-2 I16 L3 Q5 P8 D4 F800";
  const auto before_second = [&](const char* value) {
    return lines(block, profile_with({{"gsk.pocket.p-beyond", value}}), OpenPaths::judged).at(6);
  };
  EXPECT_EQ(before_second("r-plane"), "rapid y-2");
  EXPECT_EQ(before_second("literal"), "rapid y1");
}

TEST(G110Rules, Clause16ADOfZeroHasTwoAlarms) {
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D0"), "alarm b2 step-too-large value-out-of-range");
}

TEST(G110Rules, Clause16AnIOfZeroHasTwoAlarms) {
  const std::string end = pocket("Y20 I0 L3 Q5 D4");
  EXPECT_NE(end.find("value-out-of-range"), std::string::npos) << end;
  EXPECT_NE(end.find("tool-too-large"), std::string::npos) << end;
}

TEST(G110Rules, Clause16BelongsToBlocksThatMill) {
  // L0 is taken in without an alarm, and is one when the next block mills.
  EXPECT_EQ(ending("G110 I16 L0 Q5 D4 F800"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending("G110 I16 L0 Q5 D4 F800\nX50 Z50 Y-5"), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending("G110 I16 L0 Q5 D4 F800\nX0 Z0 Y-5 L3", {}, OpenPaths::judged),
            "end x0 y0 z0 a0 c0");
}

TEST(G110Rules, Mod02AnEntryBlockThatMillsNothingNeedsILQD) {
  EXPECT_EQ(ending("G110"), "alarm b1 missing-word missing-word missing-word missing-word");
  EXPECT_EQ(ending("G110 I16 L3 D4"), "alarm b1 missing-word");
  EXPECT_EQ(ending("G110 I16 L3 Q5 D4"), "end x0 y0 z0 a0 c0");
}

TEST(G110Rules, Mod02ABlockThatMillsNothingTakesItsWordsIn) {
  const Lines want = {
      "rapid x25 z50", "rapid y0",      "feed y-5 f800", "level d-5 c50,25 R16 r4 L3 -1 f800",
      "rapid y0",      "rapid x25 z50", "rapid y0"};
  EXPECT_EQ(lines("G110 I10 L1 Q1 D1\nI16 L3\nQ5 D4 F800\nX50 Z50 Y-5", {}, OpenPaths::judged),
            want);
}

TEST(G110Rules, Mod02ABlockThatMillsNothingChecksRanges) {
  const std::string entry = "G110 I16 L3 Q5 D4 F800\n";
  EXPECT_EQ(ending(entry + "X1000000"), "alarm b2 value-out-of-range");
  EXPECT_EQ(ending(entry + "Q-1"), "alarm b2 value-out-of-range");
}

TEST(G110Rules, Mod02ABlockThatMillsNothingPassesMFunctionsOn) {
  EXPECT_EQ(lines("G110 I16 L3 Q5 D4 F800\nM35"), Lines{"m35"});
}

TEST(G110Rules, Mod03RAndPHoldForTheirBlock) {
  const std::string program = "G110 X0 Z0 Y-20 R-5 P1 I16 L3 Q10 D4 F800\nX0 Z0 Y-20";
  const Lines both = lines(program, {}, OpenPaths::judged);
  ASSERT_EQ(both.size(), 24U);
  EXPECT_EQ(both[1], "rapid y-5");
  EXPECT_EQ(both[6], "rapid y-14");   // P1 above Y-15
  EXPECT_EQ(both[13], "rapid y0");    // no R
  EXPECT_EQ(both[18], "rapid y-10");  // no P
  EXPECT_EQ(lines(program, profile_with({{"gsk.pocket.R", "per-block"}}), OpenPaths::judged), both);
}

TEST(G110Rules, ReadingRModalKeepsRAndP) {
  const Lines both = lines("G110 X0 Z0 Y-20 R-5 P1 I16 L3 Q10 D4 F800\nX0 Z0 Y-20",
                           profile_with({{"gsk.pocket.R", "modal"}}), OpenPaths::judged);
  ASSERT_EQ(both.size(), 24U);
  EXPECT_EQ(Lines(both.begin() + 12, both.end()), Lines(both.begin(), both.begin() + 12));
}

TEST(G110Rules, Com06WordsThatTheCycleDoesNotUseAreCheckedAndIgnored) {
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 E7 J9"), kDone);
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 E-1"), "alarm b2 value-out-of-range");
  EXPECT_EQ(pocket("Y20 I16 L3 Q5 D4 J1000000"), "alarm b2 value-out-of-range");
}

TEST(G110Rules, BrokenRulesOfOneBlockAreAllReported) {
  // R against the depth, I = D, L = 2D, no feed; each at its word.
  EXPECT_EQ(ending("G110 R1 X50 Z50 Y-5 L8 I4 Q5 D4"),
            "alarm b1 direction-conflict step-too-large tool-too-large feed-missing");
}

}  // namespace
}  // namespace gonogo::reference::testing
