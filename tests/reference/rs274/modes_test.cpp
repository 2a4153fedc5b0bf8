// SPDX-License-Identifier: GPL-3.0-or-later
//
// Modes, the order of words, units, the ends of a program.
#include <gtest/gtest.h>

#include <algorithm>

#include "ngc_expanding.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

TEST(NgcModes, ABlockWithAxisWordsAloneRepeatsTheMotion) {
  EXPECT_EQ(path("G0 X1\nX2\nG1 F100\nX3\nY4"),
            (Lines{"rapid x1", "rapid x2", "feed x3 f100", "feed y4 f100"}));
  EXPECT_EQ(path("G3 X2 I1 F100\nX4 I1").at(1), "arc x4 y0 c3,0 rot1 f100");
}

TEST(NgcModes, BlocksWithoutWordsOfAMotionMoveNothing) {
  EXPECT_EQ(path("G2 X2 I1 F100\nF200\nS500 T3\nG17\nN7\n\n(comment)").size(), 1U);
}

TEST(NgcModes, AWordOfAMotionNeedsAMotionMode) {
  for (const char* word : {"X1", "Y1", "Z1", "A1", "C1"}) {
    EXPECT_EQ(ending_of(word), "alarm b1 missing-word") << word;
    EXPECT_EQ(ending_of(std::string("G1 F9\nG80\n") + word), "alarm b3 missing-word") << word;
  }
  EXPECT_EQ(ending_of("G0 X1\nG80 X2"), "alarm b2 missing-word");
  EXPECT_EQ(clauses("X1"), Lines{"NGC-MOD-01"});
  EXPECT_EQ(ending_of("G0 X0\nG80\nF100\nG17"), "end x0 y0 z0 a0 c0");
}

TEST(NgcModes, TheProfileMayGiveAMotion) {
  Profile profile = ngc();
  profile.initial.motion = 1;
  EXPECT_EQ(path("X1 F100", profile), Lines{"feed x1 f100"});
}

TEST(NgcModes, POfAnotherCodeNeedsNoMotion) {
  EXPECT_EQ(ending_of("G64 P0.01\nM66 P0 L0\nM62 P1\nM50 P1"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G61 P0.01"), "alarm b1 unused-word");
  EXPECT_EQ(ending_of("M3 P1"), "alarm b1 unused-word");
}

TEST(NgcModes, TheOrderOfWordsDoesNotMatter) {
  std::vector<std::string> words = {"G1", "G91", "G20", "X1", "F5", "M3"};
  const Lines want = lines("G0 X3\nG1 G91 G20 X1 F5 M3", ngc());
  EXPECT_EQ(want, (Lines{"rapid x3", "m3", "feed x28.4 f5"}));
  std::ranges::sort(words);
  do {
    std::string block;
    for (const std::string& word : words) block += " " + word;
    EXPECT_EQ(lines("G0 X3\n" + block, ngc()), want) << block;
  } while (std::ranges::next_permutation(words).found);
}

// F comes before G20 in the order of a block: it is still in millimetres.
TEST(NgcModes, AFeedIsInTheUnitsOfTheBlocksBefore) {
  EXPECT_EQ(path("G20 G1 X1 F10\nX2 F10\nG21 X1 F10\nX2 F10"),
            (Lines{"feed x25.4 f10", "feed x50.8 f254", "feed x1 f254", "feed x2 f10"}));
}

TEST(NgcModes, AFeedInForceKeepsItsValueWhenTheUnitsChange) {
  EXPECT_EQ(path("G1 X1 F100\nG20 X1\nG21 X1"),
            (Lines{"feed x1 f100", "feed x25.4 f100", "feed x1 f100"}));
}

TEST(NgcModes, G20IsInchesOf25Point4) {
  EXPECT_EQ(path("G20 G0 X1 Y-0.5 A90"), Lines{"rapid x25.4 y-12.7 a90"});
  Profile profile = ngc();
  profile.units = Units::inch;
  EXPECT_EQ(path("G1 X1 F10", profile), Lines{"feed x25.4 f254"});
}

// A semicircle of diameter 1 inch, and the radius form of it.
TEST(NgcModes, G20HoldsForTheWordsOfArcs) {
  EXPECT_EQ(path("F100\nG20 G2 X1 I0.5"), Lines{"arc x25.4 y0 c12.7,0 rot-1 f100"});
  EXPECT_EQ(path("F100\nG20 G2 X1 R0.5"), Lines{"arc x25.4 y0 c12.7,0 rot-1 f100"});
}

TEST(NgcModes, G91IsForAxisWordsOnly) {
  EXPECT_EQ(path("G0 X1 Y1\nG91 X1 A10\nX1 A10\nG90 X5"),
            (Lines{"rapid x1 y1", "rapid x2 a10", "rapid x3 a20", "rapid x5"}));
  EXPECT_EQ(path("G0 X1\nG91 G2 X2 I1 F9").at(1), "arc x3 y0 c2,0 rot-1 f9");
}

TEST(NgcModes, G90Point1MakesCentresAbsolute) {
  const Lines want = {"rapid x1 y0", "arc x3 y0 c2,0 rot-1 f9"};
  EXPECT_EQ(path("G0 X1 Y0\nG90.1 G2 X3 I2 J0 F9"), want);
  EXPECT_EQ(path("G0 X1 Y0\nG91 G90.1 G2 X2 I2 J0 F9"), want);
  EXPECT_EQ(path("G90.1\nG0 X1 Y0\nG91.1 G2 X3 I1 F9"), want);
}

TEST(NgcModes, G90Point1NeedsBothWords) {
  EXPECT_EQ(ending_of("G90.1 G2 X2 I1 F9"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G90.1 G2 X2 J1 F9"), "alarm b1 missing-word");
}

TEST(NgcModes, MFunctionsThatStopComeAfterTheMotion) {
  EXPECT_EQ(lines("G0 X1 M3 M8\nX2 M5 M9\nX3 M0\nX4 M1\nX5 M60\nM30 X6\nX7", ngc()),
            (Lines{"m3", "m8", "rapid x1", "m5", "m9", "rapid x2", "rapid x3", "m0", "rapid x4",
                   "m1", "rapid x5", "m60", "rapid x6", "m30"}));
}

TEST(NgcModes, MFunctionsRunInTheOrderOfExecution) {
  // Outputs, the tool, the spindle, coolant, overrides; the stop after the motion.
  EXPECT_EQ(lines("M49 M9 M4 M62 P1 X1 G0", ngc()),
            (Lines{"m62", "m4", "m9", "m49", "rapid x1"}));
  EXPECT_EQ(lines("M1 M8 M3 M6 X1 G0", ngc()), (Lines{"m6", "m3", "m8", "rapid x1", "m1"}));
}

TEST(NgcModes, ABlockHasFourMFunctionsAtMost) {
  EXPECT_EQ(ending_of("M49 M9 M4 M6"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("M49 M9 M4 M6 M62 P1"), "alarm b1 duplicate-word");
}

TEST(NgcModes, MFunctionsComeBeforeTheDwell) {
  EXPECT_EQ(lines("G4 P1 M3", ngc()), (Lines{"m3", "dwell 1"}));
}

TEST(NgcModes, M2AndM30EndTheProgram) {
  EXPECT_EQ(path("G0 X1\nM2\nX2"), Lines{"rapid x1"});
  EXPECT_EQ(path("G0 X1\nM30\nX2"), Lines{"rapid x1"});
}

TEST(NgcModes, ASlashRunsUnlessBlocksAreSkipped) {
  EXPECT_EQ(path("/G0 X1"), Lines{"rapid x1"});
  Profile profile = ngc();
  profile.block_skip = true;
  EXPECT_EQ(path("/G0 X1\nG0 X2", profile), Lines{"rapid x2"});
}

TEST(NgcModes, MachinesOfThisDialectAreMills) {
  const Profile profile = ngc();
  EXPECT_FALSE(profile.x_diameter);
  EXPECT_EQ(profile.initial.plane, Plane::g17);
  EXPECT_EQ(profile.initial.motion, kNoMotion);
  EXPECT_EQ(profile.resolution(), num("0.0001"));
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
