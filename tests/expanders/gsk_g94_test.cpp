// SPDX-License-Identifier: GPL-3.0-or-later
// G94. X words are diameters unless a test says otherwise: X130 is x=65.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(GskG94, FaceCycleGoesByBAndCAndDAndBack) {
  // The manual's example: A (130, 5), B (130, 0), C (0, 0), D (0, 5).
  const Outcome outcome = run("G00 X130 Z5 M3 S500;\nG94 X0 Z0 F200;\n");
  EXPECT_EQ(outcome.motions(),
            "m 3\n"
            "rapid x=65 z=5\n"
            "rapid z=0\n"
            "feed x=0 z=0 f=200\n"
            "feed z=5 f=200\n"
            "rapid x=65\n");
  EXPECT_EQ(outcome.answer, GONOGO_OK);
  EXPECT_EQ(outcome.records.back(), "end x=65 y=0 z=5 a=0 c=0");
}

TEST(GskG94, RepeatsWithNewWordsAndFeed) {
  // A (130, 5), B (130, -110), C (120, -110), D (120, 5).
  const Outcome outcome = run("G00 X130 Z5\nG94 X0 Z0 F200\nX120 Z-110 F300\n");
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "rapid z=-110\n"
            "feed x=60 z=-110 f=300\n"
            "feed z=5 f=300\n"
            "rapid x=65\n");
}

TEST(GskG94, TaperPassesOfTheManualEndOnTheDrawing) {
  // Passes X108 to X60 by 12, R-10 to R-50: B at Z-30 + R, C at Z-30, from A (120, 0).
  const Outcome outcome =
      run("G00 X120 Z0\nG94 X108 Z-30 R-10 F300\nX96 R-20\nX84 R-30\nX72 R-40\n"
          "X60 R-50\nM30\n");
  std::string expected = "rapid x=60 z=0\n";
  const char* passes[][2] = {
      {"54", "-40"}, {"48", "-50"}, {"42", "-60"}, {"36", "-70"}, {"30", "-80"}};
  for (const auto& [x, b] : passes) {
    expected += std::string("rapid z=") + b + "\nfeed x=" + x +
                " z=-30 f=300\nfeed z=0 f=300\nrapid x=60\n";
  }
  EXPECT_EQ(outcome.motions(), expected + "m 30\n");
}

TEST(GskG94, AllMotionsOfACycleCarryItsBlock) {
  const Outcome outcome = run("G00 X130 Z5\n\n\nG94 X0 Z0 F200\n");
  EXPECT_EQ(outcome.blocks, (std::vector<std::size_t>{1, 4, 4, 4, 4, 4}));
}

TEST(GskG94, IncrementsCountFromTheStart) {
  // U-20 of a diameter is 10; C = (40, -5).
  const Outcome outcome = run("G00 X100 Z5\nG94 U-20 W-10 F100\nU-40\n");
  EXPECT_EQ(joined({outcome.records.begin() + 1, outcome.records.end() - 1}),
            "rapid z=-5\nfeed x=40 z=-5 f=100\nfeed z=5 f=100\nrapid x=50\n"
            "rapid z=-5\nfeed x=30 z=-5 f=100\nfeed z=5 f=100\nrapid x=50\n");
}

TEST(GskG94, G17PositionsInXAndTakesTheTaperAsATrueLength) {
  // X is a diameter: C_x = 20, B_x = 20 + R 3 = 23 (word 46).
  const Outcome outcome = run("G17 G00 X60 Y5\nG94 X40 Y-8 R3 F50\n");
  EXPECT_EQ(joined({outcome.records.begin() + 1, outcome.records.end() - 1}),
            "rapid x=23\nfeed x=20 y=-8 f=50\nfeed x=30 f=50\nrapid y=5\n");
}

TEST(GskG94, G19PositionsInYAndCutsInZ) {
  const Outcome outcome = run("G19 G00 Y10 Z20\nG94 Y2 Z4 F50\n");
  EXPECT_EQ(joined({outcome.records.begin() + 1, outcome.records.end() - 1}),
            "rapid y=2\nfeed y=2 z=4 f=50\nfeed y=10 f=50\nrapid z=20\n");
}

TEST(GskG94, TaperAgainstTheTravelMayEqualIt) {
  // Travel -10, R10: B = A, so the approach has no length.
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R10 F50\n");
  EXPECT_EQ(outcome.motions(), "rapid x=50 z=0\nfeed x=40 z=-10 f=50\nfeed z=0 f=50\nrapid x=50\n");
}

constexpr const char* kLimited = R"({"readings":{"gsk.g94.taper-limit":"alarm"}})";

TEST(GskG94, TaperOneIncrementBeyondTheTravelAlarms) {
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R10.001 F50\n", kLimited);
  EXPECT_EQ(outcome.alarm, "taper-limit");
  EXPECT_EQ(outcome.alarm_word, 'R');
  EXPECT_EQ(outcome.alarm_block, 2u);
  EXPECT_EQ(outcome.motions(), "rapid x=50 z=0\n");
}

TEST(GskG94, TaperLimitOfG17HalvesTheDiameterTravel) {
  // U-20 is 10 true: R10 passes, R10.001 does not.
  EXPECT_EQ(run("G17 G00 X60\nG94 U-20 Y-8 R10 F50\n").answer, GONOGO_OK);
  EXPECT_EQ(run("G17 G00 X60\nG94 U-20 Y-8 R10.001 F50\n", kLimited).alarm, "taper-limit");
  EXPECT_EQ(run("G17 G00 X60\nG94 U-20 Y-8 R10.001 F50\n").answer, GONOGO_OK);
}

TEST(GskG94, TaperWithTheTravelHasNoLimit) {
  EXPECT_EQ(run("G00 X100 Z0\nG94 X80 Z-10 R-500 F50\n").answer, GONOGO_OK);
}

TEST(GskG94, ZeroTravelTakesAnyTaper) {
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 W0 R7 F50\n");
  EXPECT_EQ(outcome.motions(), "rapid x=50 z=0\nrapid z=7\nfeed x=40 z=0 f=50\nrapid x=50\n");
}

TEST(GskG94, TaperAloneRuns) {
  const Outcome outcome = run("G00 X100 Z0\nG94 R7 F50\n");
  EXPECT_EQ(outcome.motions(), "rapid x=50 z=0\nrapid z=7\nfeed x=50 z=0 f=50\n");
}

TEST(GskG94, BlockWithoutAxisOrTaperDoesNothing) {
  EXPECT_EQ(run("G00 X100 Z0\nG94 F50\nM8\nS500\n").motions(), "rapid x=50 z=0\nm 8\n");
}

TEST(GskG94, AnotherMotionCodeClearsEndPointAndTaper) {
  // After G00 the cycle starts afresh: no R, Z missing is zero travel.
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R-5 F50\nG00\nG94 X60\n");
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "feed x=30 z=0 f=50\nrapid x=50\n");
}

TEST(GskG94, NonModalCodeClearsButTheCycleStays) {
  // G28 without axes moves nothing; then only X is known.
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R-5 F50\nG28\nX60\n");
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "feed x=30 z=0 f=50\nrapid x=50\n");
}

TEST(GskG94, DwellKeepsEndPointAndTaper) {
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R-5 F50\nG04 P500\nX60\n");
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "dwell 0.5\nrapid z=-15\nfeed x=30 z=-10 f=50\nfeed z=0 f=50\nrapid x=50\n");
}

TEST(GskG94, WrittenAgainItKeepsEndPointAndTaper) {
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 R-5 F50\nG94 X60\n");
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "rapid z=-15\nfeed x=30 z=-10 f=50\nfeed z=0 f=50\nrapid x=50\n");
}

TEST(GskG94, WordOffThePlaneAlarms) {
  for (const char* word : {"Y5", "V5", "C30", "H30"}) {
    const Outcome outcome = run(std::string("G00 X100 Z0\nG94 X80 Z-10 F50 ") + word + "\n");
    EXPECT_EQ(outcome.alarm, "axis-not-in-plane") << word;
    EXPECT_EQ(outcome.alarm_word, word[0]);
    EXPECT_EQ(outcome.records.size(), 1u);
  }
}

TEST(GskG94, WordsAreKeptAsMillimetresAndWaitForTheirPlane) {
  // In G17 X is p and Y q: X80 (retained) is the end in p, Y is zero travel. Back in G18 Z-10
  // holds.
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10 F50\nG17 G20 Y1\n", kRadiusProfile);
  EXPECT_EQ(joined({outcome.records.begin() + 5, outcome.records.end() - 1}),
            "rapid x=80\nfeed x=80 y=25.4 f=50\nfeed x=100 f=50\nrapid y=0\n");
}

TEST(GskG94, NeedsAFeed) {
  const Outcome outcome = run("G00 X100 Z0\nG94 X80 Z-10\n");
  EXPECT_EQ(outcome.alarm, "feed-missing");
  EXPECT_EQ(outcome.records.size(), 1u);
}

}  // namespace
}  // namespace gonogo::expanders::testing
