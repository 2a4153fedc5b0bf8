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

// 3-4-5: 5 mm in half a minute are 10 mm/min. Rotary axes alone turn 90 degrees in a third of a
// minute.
TEST(NgcModes, InverseTimeIsTheWayTimesF) {
  EXPECT_EQ(path("G93 G1 X3 Y4 F2\nX6 Y8 F1\nG0 X0 Y0"),
            (Lines{"feed x3 y4 f10", "feed x6 y8 f5", "rapid x0 y0"}));
  EXPECT_EQ(path("G93 G1 A90 F3\nX2 A0 F3"), (Lines{"feed a90 f270", "feed x2 a0 f6"}));
  EXPECT_EQ(path("G20 G93 G1 X1 F2"), Lines{"feed x25.4 f50.8"});
  EXPECT_EQ(ending_of("F9 G93 G1 X1\nX2"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G93 F2\nG1 X1"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G93 G1 X2 F0"), "not-covered b1 F");
  EXPECT_EQ(ending_of("G93 G2 X2 I1"), "alarm b1 feed-missing");
}

// The feeds of a program's motions, to nine decimals.
Lines feeds(const char* program) {
  Lines all;
  for (const Item& item : expand(program, ngc())) {
    const auto* record = std::get_if<Record>(&item);
    if (record != nullptr && is_motion(record->kind)) all.push_back(record->feed.decimal_text(9));
  }
  return all;
}

// 2 pi; a quarter of a turn of radius 10, 5 pi, in two minutes; 10 pi in 2/3 of one; 5 pi and 15 pi
// in a third; 5 pi and 4 across make the root of 25 pi^2 + 16; two turns that rise by 3.
TEST(NgcModes, InverseTimeCountsTheWayAlongAnArc) {
  EXPECT_EQ(feeds("G93 G2 X2 I1 F2"), Lines{"6.283185307"});
  EXPECT_EQ(feeds("G93 G3 X-10 Y10 I-10 F0.5"), Lines{"7.853981634"});
  EXPECT_EQ(feeds("G93 G2 I-5 F1.5"), Lines{"47.123889804"});
  EXPECT_EQ(feeds("G93 G2 X10 Y10 R10 F3\nG2 X0 Y0 R-10 F3"),
            (Lines{"47.123889804", "141.371669412"}));
  EXPECT_EQ(feeds("G93 G3 X-10 Y10 Z4 I-10 F1"), Lines{"16.209260009"});
  EXPECT_EQ(feeds("G93 G3 Z3 I1 P2 F1"), Lines{"12.919507360"});
  EXPECT_EQ(feeds("G20 G93 G2 X2 I1 F1"), Lines{"79.796453401"});
}

// Radii of 5 and 5.0005, of which either may count.
TEST(NgcModes, InverseTimeOfAnArcWhoseRadiiDifferIsNotRead) {
  EXPECT_EQ(path("F9 G2 X10.0005 I5").size(), 1U);
  EXPECT_EQ(ending_of("G93 G2 X10.0005 I5 F3"), "not-covered b1 F");
}

TEST(NgcModes, AnotherModeOfFeedNeedsANewF) {
  EXPECT_EQ(path("G95 G1 X1 F0.2\nG94 X2 F9"), (Lines{"feed x1 f0.2/rev", "feed x2 f9"}));
  EXPECT_EQ(ending_of("F9 G1 X1\nG95 X2"), "alarm b2 feed-missing");
  EXPECT_EQ(ending_of("G93 G1 X1 F9\nG94 X2"), "alarm b2 feed-missing");
  EXPECT_EQ(touched("F9 G1 X1\nG95 F1 X2\nM2"), Lines{});
  EXPECT_EQ(path("G95 F0.1 G99 G81 X1 Z-1 R1").at(2), "feed z-1 f0.1/rev");
}

TEST(NgcModes, ConstantSurfaceSpeedNeedsSAndASpindleThatTurns) {
  EXPECT_EQ(path("G96 D2500 S250 M3\nG1 X1 F9\nG97 S100 M5\nX2"),
            (Lines{"feed x1 f9", "feed x2 f9"}));
  EXPECT_EQ(ending_of("G96 D2500"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G96 S9 F9\nG0 X1\nG1 X2"), "alarm b3 spindle-stopped");
  EXPECT_EQ(ending_of("G97 S9 D9"), "alarm b1 unused-word");
}

// NIST 3.6.3, and LinuxCNC's page of M codes: the spindle is stopped when the change is complete.
TEST(NgcModes, AToolChangeLeavesTheSpindleStopped) {
  EXPECT_EQ(ending_of("M3 S9\nT1 M6\nG33 Z-5 K1"), "alarm b3 spindle-stopped");
  EXPECT_EQ(ending_of("M3 S9\nM6 G33 Z-5 K1"), "alarm b2 spindle-stopped");
  EXPECT_EQ(ending_of("G96 S9 F9 M4\nT1 M6\nG1 X1"), "alarm b3 spindle-stopped");
  EXPECT_EQ(ending_of("F9 M3\nT1 M6\nG84 X1 Z-1 R2"), "alarm b3 spindle-stopped");
  EXPECT_EQ(path("M3\nT1 M6\nG0 X[2+#<_spindle_on>]"), Lines{"rapid x2"});
  // M3 comes behind M6 where both are in a block, and M61 changes no tool.
  EXPECT_EQ(path("M3 M6 T1\nG0 X[2+#<_spindle_on>]"), Lines{"rapid x3"});
  EXPECT_EQ(path("T1 M6\nM4\nG0 X[2+#<_spindle_on>] Y[2+#<_spindle_cw>]"), Lines{"rapid x3 y2"});
  EXPECT_EQ(path("M3\nM61 Q2\nG0 X[2+#<_spindle_on>]"), Lines{"rapid x3"});
  // What M70 saved had a spindle that turned.
  EXPECT_EQ(ending_of("M3 M70\nT1 M6\nM72"), "not-covered b3 M");
}

// The documents: X1 moves the cutter to 0.5 from the centre.
TEST(NgcModes, UnderG7XIsADiameter) {
  EXPECT_EQ(path("G7\nG0 X1 Z1\nG91 X1\nG8\nX1"), (Lines{"rapid x0.5 z1", "rapid x1", "rapid x2"}));
  EXPECT_EQ(path("G7 G18\nG2 X4 Z2 I2 F9"), Lines{"arc x2 z2 c0,2 rot-1 f9"});
  for (const char* block : {"G8 X1", "G92 X1", "G43.1 X1", "G90.1 G2 X1 I1", "G19 G81 X1 R2"}) {
    EXPECT_EQ(ending_of("F1\nG7\n" + std::string(block)).substr(0, 14), "not-covered b3") << block;
  }
}

// A fuzzer's program, on which an expander took X1 of the repeat for a radius.
TEST(NgcModes, UnderG7XOfARepeatedCycleIsADiameter) {
  EXPECT_EQ(path("G18 G83 Q1 R0 Y0 F1\nG7 G81 R0 Y0\nX1\nG8\nX1"),
            (Lines{"rapid x0.5 z0", "rapid x1 z0"}));
}

// The documents list what M70 saves.
TEST(NgcModes, M72RestoresWhatM70Saved) {
  EXPECT_EQ(path("F9 G1 M70\nG91 G20 G18 F5 G55\nM72\nG3 X2 I1", ngc()),
            Lines{"arc x2 y0 c1,0 rot1 f9"});
  EXPECT_EQ(path("M70\nG91\nM70\nM72\nG0 X1\nX1"), (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(ending_of("M72"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("M70\nM71\nM72"), "alarm b3 missing-word");
  EXPECT_EQ(ending_of("M70\nM3\nM72"), "not-covered b3 M");
}

// F100 was written in millimetres; saved and restored is the number, in inches: 2,540 mm/min.
TEST(NgcModes, FIsRestoredAsANumberOfTheUnitsThatAreRestored) {
  EXPECT_EQ(path("F100\nG20\nM70\nF5\nM72\nG1 X1"), Lines{"feed x25.4 f2540"});
  EXPECT_EQ(path("G20 F10\nM70\nG21 F50\nM72\nG1 X1"), Lines{"feed x25.4 f254"});
  EXPECT_EQ(path("G20 F10\nG21\nM70\nF50\nM72\nG1 X1"), Lines{"feed x1 f10"});
  EXPECT_EQ(path("o1 sub\nM73\nF5\no1 endsub\nF100\nG20\no1 call\nG1 X1"),
            Lines{"feed x25.4 f2540"});
  Profile profile = ngc();
  profile.initial.feed = 100;  // of power-on: no number was written
  EXPECT_EQ(path("G20\nM70\nF5\nM72\nG1 X1", profile), Lines{"feed x25.4 f100"});
}

TEST(NgcModes, NoOverrideIsRestored) {
  for (const char* change : {"M49", "M50 P0", "M51 P0", "M52", "M53 P0"}) {
    const std::string program = std::string("M70\n") + change + "\nM72\nG0 X1";
    EXPECT_EQ(ending_of(program), "not-covered b3 M") << change;
  }
  EXPECT_EQ(path("M70\nM49\nM48\nM72\nG0 X1"), Lines{"rapid x1"});
}

TEST(NgcModes, M73RestoresWhereItsSubroutineEnds) {
  EXPECT_EQ(path("o1 sub\nM73 G91\no1 endsub\nG0 X1\no1 call\nX1"),
            (Lines{"rapid x1", "rapid x1"}));
  EXPECT_EQ(path("o1 sub\nM70 G91\no1 endsub\nG0 X1\no1 call\nX1"),
            (Lines{"rapid x1", "rapid x2"}));
  EXPECT_EQ(path("M70\no1 sub\nG91\nM70\no1 endsub\nG0 X1\no1 call\nM72\nX1"),
            (Lines{"rapid x1", "rapid x1"}));
}

// LinuxCNC 2.9 prints X5 X10 X11: in the second pass G91 is in force again.
TEST(NgcModes, M73RestoresWhereEachPassOfASubprogramEnds) {
  EXPECT_EQ(path("G91\nM98 P1 L2\nG0 X1\nM2\nO1\n#1=[#1+1]\no2 if [#1 EQ 1]\nM73\nG90\n"
                 "o2 endif\nG0 X5\nM99"),
            (Lines{"rapid x5", "rapid x10", "rapid x11"}));
  EXPECT_EQ(ending_of("M98 P1\nM2\nO1\nM73\nM3\nM99"), "not-covered b6 M73");
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
  EXPECT_EQ(lines("M49 M9 M4 M62 P1 X1 G0", ngc()), (Lines{"m62", "m4", "m9", "m49", "rapid x1"}));
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
