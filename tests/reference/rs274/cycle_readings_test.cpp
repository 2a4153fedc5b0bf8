// SPDX-License-Identifier: GPL-3.0-or-later
//
// The readings of cycles and threads, each alternative derived by hand, and when a program asks
// for one.
#include <gtest/gtest.h>

#include "ngc_trace.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

using Choice = std::pair<std::string_view, std::string_view>;

std::string under(std::initializer_list<Choice> readings, const std::string& blocks) {
  return trace("F100\n" + blocks + "\nM2", ngc(readings));
}

TEST(NgcCycleReadings, InitialLevelOfTheBlock) {
  const std::string blocks = "G0 Z10\nG99 G81 X1 Z-1 R2\nG98 X2";
  const std::string first = "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 ";
  EXPECT_EQ(under({}, blocks), first + "R2,0,10");
  EXPECT_EQ(under({{"ngc.cycle.initial", "block"}}, blocks), first + "R2,0,2");
}

TEST(NgcCycleReadings, WhatRCountsFromUnderG91) {
  const std::string start = "G0 Z10\nG91 G99 G81 X1 Z-4 R2";
  const std::string current = "R0,0,10 R0,0,12 R1,0,12 F1,0,8 R1,0,12";
  EXPECT_EQ(under({}, start), current);
  EXPECT_EQ(under({{"ngc.cycle.g91-r", "initial"}}, start), current);
  EXPECT_EQ(under({{"ngc.cycle.g91-r", "absolute"}}, start),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-2 R1,0,2");
  // Again from where the tool is, from where the series began, or nowhere else.
  EXPECT_EQ(under({}, start + "\nX1"), current + " R1,0,14 R2,0,14 F2,0,10 R2,0,14");
  EXPECT_EQ(under({{"ngc.cycle.g91-r", "initial"}}, start + "\nX1"),
            current + " R2,0,12 F2,0,8 R2,0,12");
  EXPECT_EQ(under({{"ngc.cycle.g91-r", "absolute"}}, start + "\nX1"),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-2 R1,0,2 R2,0,2 F2,0,-2 R2,0,2");
}

TEST(NgcCycleReadings, StickyLevels) {
  const Choice level = {"ngc.cycle.sticky", "level"};
  const std::string start = "G0 Z10\nG91 G99 G81 X10 Z-4 R-3\n";
  const std::string first = "R0,0,10 R10,0,10 R10,0,7 F10,0,3 R10,0,7 R20,0,7 ";
  EXPECT_EQ(under({}, start + "X10"), first + "R20,0,4 F20,0,0 R20,0,4");
  EXPECT_EQ(under({level}, start + "X10"), first + "F20,0,3 R20,0,7");
  EXPECT_EQ(under({}, start + "X10 R-1"), first + "R20,0,6 F20,0,2 R20,0,6");
  EXPECT_EQ(under({level}, start + "X10 R-1"), first + "R20,0,6 F20,0,3 R20,0,6");
  EXPECT_EQ(under({}, start + "X10 Z-2"), first + "R20,0,4 F20,0,2 R20,0,4");
  EXPECT_EQ(under({level}, start + "X10 Z-2"), first + "F20,0,5 R20,0,7");
  // Under G90 the numbers -3 and -4 are coordinates: from 7 down, or up to where they were.
  EXPECT_EQ(under({}, start + "G90 X20"), first + "R20,0,-3 F20,0,-4 R20,0,-3");
  EXPECT_EQ(under({level}, start + "G90 X20"), first + "F20,0,3 R20,0,7");
  // R 1 inch, bottom -1 inch; or 1 mm and -1 mm.
  const std::string metric = "G0 Z1\nG99 G81 X0 Z-1 R1\nG20 X0";
  EXPECT_EQ(under({}, metric), "R0,0,1 F0,0,-1 R0,0,1 R0,0,25.4 F0,0,-25.4 R0,0,25.4");
  EXPECT_EQ(under({level}, metric), "R0,0,1 F0,0,-1 R0,0,1 F0,0,-1 R0,0,1");
}

// The three cases in which the two ways part.
TEST(NgcCycleReadings, ApproachByTheInitialLevel) {
  const Choice choice = {"ngc.cycle.approach", "initial-level"};
  // Below R, with the initial level above it: slanting.
  const std::string below = "G0 Z10\nG99 G81 X1 Z0 R4\nX2 Y3 R8";
  EXPECT_EQ(under({}, below), "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R1,0,8 R2,3,8 F2,3,0 R2,3,8");
  EXPECT_EQ(under({choice}, below), "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R2,3,8 F2,3,0 R2,3,8");
  // At R under G98: slanting up and down again.
  const std::string at = "G0 Z10\nG99 G81 X1 Z0 R4\nG98 X2 Y3";
  EXPECT_EQ(under({}, at), "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R2,3,4 F2,3,0 R2,3,10");
  EXPECT_EQ(under({choice}, at),
            "R0,0,10 R1,0,10 R1,0,4 F1,0,0 R1,0,4 R2,3,10 R2,3,4 F2,3,0 R2,3,10");
  // Above R, with the initial level below it: down before it crosses.
  const std::string above = "G0 Z2\nG99 G81 X1 Z-1 R8\nX2 Y3 R5";
  EXPECT_EQ(under({}, above), "R0,0,2 R0,0,8 R1,0,8 F1,0,-1 R1,0,8 R2,3,8 R2,3,5 F2,3,-1 R2,3,5");
  EXPECT_EQ(under({choice}, above),
            "R0,0,2 R0,0,8 R1,0,8 F1,0,-1 R1,0,8 R1,0,5 R2,3,5 F2,3,-1 R2,3,5");
}

TEST(NgcCycleReadings, InitialLevelAsANumber) {
  const Choice choice = {"ngc.cycle.initial-kept", "number"};
  // The 10 mm become 10 inches, above R at 2 inches.
  const std::string units = "G0 Z10\nG98 G81 X1 Z-1 R2\nG20 X2";
  const std::string first = "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,10 R1,0,50.8 R50.8,0,50.8 ";
  EXPECT_EQ(under({}, units), first + "F50.8,0,-25.4 R50.8,0,50.8");
  EXPECT_EQ(under({choice}, units), first + "F50.8,0,-25.4 R50.8,0,254");
  // Z10 becomes X10.
  const std::string plane = "G0 X10 Y20 Z10\nG99 G81 X1 Z2 R5\nG98 G19 Y3 X1 R4";
  const std::string before = "R10,20,10 R1,20,10 R1,20,5 F1,20,2 R1,20,5 R4,20,5 R4,3,5 F1,3,5 ";
  EXPECT_EQ(under({}, plane), before + "R4,3,5");
  EXPECT_EQ(under({choice}, plane), before + "R10,3,5");
  EXPECT_EQ(under({choice, {"ngc.cycle.initial", "block"}}, plane), before + "R4,3,5");
  // A plane that was changed and changed back is another series all the same.
  const std::string back = "G0 Z10\nG99 G81 X1 Z-1 R2\nG18\nG17\nG98 X2";
  const std::string hole = "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2 R2,0,2 F2,0,-1 ";
  EXPECT_EQ(under({}, back), hole + "R2,0,2");
  EXPECT_EQ(under({choice}, back), hole + "R2,0,10");
}

TEST(NgcCycleReadings, RetractBeforeG98OrG99) {
  const std::string blocks = "G0 Z10\nG81 X1 Z-1 R2";
  EXPECT_EQ(under({}, blocks), "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2");
  EXPECT_EQ(under({{"ngc.cycle.retract-start", "initial"}}, blocks),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,10");
  EXPECT_EQ(under({{"ngc.cycle.retract-start", "initial"}}, "G99\n" + blocks),
            "R0,0,10 R1,0,10 R1,0,2 F1,0,-1 R1,0,2");
}

// Nothing else may be wrong with the block.
TEST(NgcCycleReadings, AlarmsThatAreFoundLate) {
  const Choice late = {"ngc.cycle.alarm-at", "late"};
  EXPECT_EQ(under({late}, "G83 X1 Z1 R2 Q0"), "R0,0,2 R1,0,2 !b2:value-sign");
  EXPECT_EQ(under({late}, "G83 X1 Z1 R2 Q0 L0"), "!b2:value-sign,value-out-of-range");
  EXPECT_EQ(under({late}, "G83 X1 Z3 R2 Q0"), "!b2:reference-plane,value-sign");
  EXPECT_EQ(under({late}, "G83 X1 Z1 Q0"), "!b2:value-sign,missing-word");
  // The one that is found first: P over the place, the spindle over the hole.
  EXPECT_EQ(under({late}, "G86 X1 Z1 R2"), "R0,0,2 !b2:missing-word,spindle-stopped");
  EXPECT_EQ(under({late}, "G0 Z5\nG86 X1 Z1 R2"), "R0,0,5 !b3:missing-word,spindle-stopped");
  EXPECT_EQ(under({late}, "G0 Z5\nG86 X1 Z1 R2 P1"), "R0,0,5 R1,0,5 R1,0,2 !b3:spindle-stopped");
}

// What NIST's interpreter finds as it reads the block, and the rest late.
TEST(NgcCycleReadings, AQThatIsNotAboveZeroMayBeFoundAtOnce) {
  const Choice late = {"ngc.cycle.alarm-at", "late"};
  const Choice at_once = {"ngc.cycle.alarm-at-q", "block"};
  EXPECT_EQ(under({late, at_once}, "G83 X1 Z1 R2 Q0"), "!b2:value-sign");
  EXPECT_EQ(under({late, at_once}, "G83 G4 P1.5 X1 Z1 R2 Q0"), "!b2:value-sign");
  EXPECT_EQ(under({late, at_once}, "G83 X1 Z1 R2"), "R0,0,2 !b2:missing-word");
  EXPECT_EQ(under({late, at_once}, "G0 Z5\nG86 X1 Z1 R2 P1"),
            "R0,0,5 R1,0,5 R1,0,2 !b3:spindle-stopped");
  EXPECT_EQ(under({at_once}, "G83 X1 Z1 R2 Q0"), "!b2:value-sign");
}

// NGC-CYC-27: as linuxcnc does, which dwells before it lifts the tool, and where it need not.
TEST(NgcCycleReadings, AlarmsThatAreFoundLateBehindADwell) {
  const Choice late = {"ngc.cycle.alarm-at", "late"};
  EXPECT_EQ(under({late}, "G83 G4 P1.5 X1 Z1 R2 Q0"), "D1.5 R0,0,2 R1,0,2 !b2:value-sign");
  EXPECT_EQ(under({late}, "G83 G4 P1.5 X1 Z1 R2"), "D1.5 R0,0,2 !b2:missing-word");
  EXPECT_EQ(under({late}, "G83 G4 P1.5 Z-1 R0"), "D1.5 !b2:missing-word");
  EXPECT_EQ(under({late}, "G83 G4 P0 Z-1 R0"), "!b2:missing-word");
  EXPECT_EQ(under({}, "G83 G4 P1.5 X1 Z1 R2 Q0"), "!b2:value-sign");
}

// As any P that is missing: after the lift to R.
TEST(NgcCycleReadings, ATapThatNeedsPIsRefusedLate) {
  const Choice needed = {"ngc.tap.p", "needed"};
  const Choice late = {"ngc.cycle.alarm-at", "late"};
  EXPECT_EQ(under({needed, late}, "M4\nG74 X1 Z1 R2"), "M4 R0,0,2 !b3:missing-word");
  EXPECT_EQ(under({needed}, "M4\nG74 X1 Z1 R2"), "M4 !b3:missing-word");
}

constexpr const char* kG83 = "G0 Z10\nG98 G83 X1 Z-7 R2 Q3";
constexpr const char* kOverHole = "R0,0,10 R1,0,10 R1,0,2 ";

TEST(NgcCycleReadings, WaysOutAndBackOfG83) {
  const std::string over = kOverHole;
  EXPECT_EQ(under({{"ngc.g83.return", "feed"}}, kG83),
            over + "F1,0,-1 R1,0,2 F1,0,-4 R1,0,2 F1,0,-7 R1,0,10");
  EXPECT_EQ(under({{"ngc.g83.retract", "clear"}, {"ngc.g83.return", "feed"}}, kG83),
            over + "F1,0,-1 R1,0,10 F1,0,-4 R1,0,10 F1,0,-7 R1,0,10");
}

std::string pecks_with(const std::string& clearance_levels) {
  const auto space = clearance_levels.find(' ');
  return std::string(kOverHole) + "F1,0,-1 R1,0,2 R1,0," + clearance_levels.substr(0, space) +
         " F1,0,-4 R1,0,2 R1,0," + clearance_levels.substr(space + 1) + " F1,0,-7 R1,0,10";
}

TEST(NgcCycleReadings, ClearanceOfPecks) {
  EXPECT_EQ(under({}, kG83), pecks_with("-0.746 -3.746"));
  EXPECT_EQ(under({{"ngc.peck.clearance", "one-mm"}}, kG83), pecks_with("0 -3"));
  EXPECT_EQ(under({{"ngc.peck.clearance", "tenth-mm"}}, kG83), pecks_with("-0.9 -3.9"));
  EXPECT_EQ(under({{"ngc.peck.clearance", "twentieth"}}, kG83), pecks_with("-0.85 -3.85"));
  // The number of the machine's units in those of the program.
  Profile inch = ngc({{"ngc.peck.clearance", "one-mm"}});
  inch.units = Units::inch;
  EXPECT_EQ(trace(std::string("G21 F100\n") + kG83 + "\nM2", inch), pecks_with("-0.95 -3.95"));
  EXPECT_EQ(under({{"ngc.peck.clearance", "one-mm"}}, "G20 G99 G73 X0 Z-2 R0 Q1"),
            "F0,0,-25.4 R0,0,0 F0,0,-50.8 R0,0,0");
}

TEST(NgcCycleReadings, DOfPecks) {
  const Choice has_d = {"ngc.peck.d", "clearance"};
  const std::string g83 = kG83;
  EXPECT_EQ(under({has_d}, g83 + " D0.5"), pecks_with("-0.5 -3.5"));
  EXPECT_EQ(under({has_d, {"ngc.peck.clearance", "one-mm"}}, g83 + " D0.5"),
            pecks_with("-0.5 -3.5"));
  EXPECT_EQ(under({has_d}, g83 + " D-1"), "R0,0,10 !b3:value-sign");
  // It counts in its block alone.
  EXPECT_EQ(under({has_d}, "G99 G73 X0 Z-2 R0 Q1 D0.5\nX0"),
            "F0,0,-1 R0,0,-0.5 F0,0,-2 R0,0,0 F0,0,-1 R0,0,-0.746 F0,0,-2 R0,0,0");
  EXPECT_EQ(under({has_d}, "G20 G99 G73 X0 Z-2 R0 Q1 D0.5"),
            "F0,0,-25.4 R0,0,-12.7 F0,0,-50.8 R0,0,0");
  // Ignored where nothing uses it.
  EXPECT_EQ(under({{"ngc.unused-words", "ignored"}}, g83 + " D0.5"), pecks_with("-0.746 -3.746"));
}

TEST(NgcCycleReadings, DwellOfPecks) {
  const Choice quarter = {"ngc.peck.dwell", "quarter"};
  EXPECT_EQ(under({quarter}, "G99 G73 X0 Z-2 R0 Q1"),
            "F0,0,-1 D0.25 R0,0,-0.746 F0,0,-2 D0.25 R0,0,0");
  EXPECT_EQ(under({quarter}, "G99 G83 X0 Z-2 R0 Q2"), "F0,0,-2 D0.25 R0,0,0");
}

TEST(NgcCycleReadings, EndOfG73) {
  const std::string blocks = "G0 Z10\nG98 G73 X1 Z-1 R2 Q3";
  EXPECT_EQ(under({{"ngc.g73.end", "r-plane"}}, blocks), std::string(kOverHole) + "F1,0,-1 R1,0,2");
  EXPECT_EQ(under({{"ngc.g73.end", "clear"}}, blocks), std::string(kOverHole) + "F1,0,-1 R1,0,10");
  EXPECT_EQ(under({{"ngc.g73.end", "both"}}, blocks),
            std::string(kOverHole) + "F1,0,-1 R1,0,2 R1,0,10");
}

TEST(NgcCycleReadings, POfATap) {
  const std::string in = "M3 F0,0,-1 M5 M4 ";
  const std::string out = "F0,0,0 M5 M3";
  const std::string without = "M3 G99 G84 X0 Z-1 R0";
  EXPECT_EQ(under({}, without), in + out);
  EXPECT_EQ(under({}, without + " P2"), in + "D2 " + out);
  EXPECT_EQ(under({}, without + " P0"), in + out);
  const Choice last = {"ngc.tap.p", "last"};
  EXPECT_EQ(under({last}, without), in + out);
  EXPECT_EQ(under({last}, "G99 G82 X0 Z-1 R0 P2\n" + without),
            "F0,0,-1 D2 R0,0,0 " + in + "D2 " + out);
  EXPECT_EQ(under({last}, "G99 G82 X0 Z-1 R0 P2\nX0 P3\nG0 X0\n" + without),
            "F0,0,-1 D2 R0,0,0 F0,0,-1 D3 R0,0,0 " + in + "D3 " + out);
  const Choice needed = {"ngc.tap.p", "needed"};
  EXPECT_EQ(under({needed}, without), "!b2:missing-word");
  EXPECT_EQ(under({needed}, without + " P2\nX0"), in + "D2 " + out + " F0,0,-1 M5 M4 D2 " + out);
  const Choice barred = {"ngc.tap.p", "barred"};
  EXPECT_EQ(under({barred}, without), in + out);
  EXPECT_EQ(under({barred}, without + " P2"), "!b2:unused-word");
  // Nor is the sign looked at of a word that is not read.
  EXPECT_EQ(under({barred, {"ngc.unused-words", "ignored"}}, without + " P-1"), in + out);
  // P beside G4 is that of G4.
  EXPECT_EQ(under({}, without + " G4 P2"), "M3 D2 F0,0,-1 M5 M4 D2 " + out);
  EXPECT_EQ(under({barred}, without + " G4 P2\nX0"),
            "M3 D2 F0,0,-1 M5 M4 " + out + " F0,0,-1 M5 M4 " + out);
}

TEST(NgcCycleReadings, LOfG74) {
  const std::string blocks = "M4 G99 G74 X0 Z-1 R0 L2";
  const std::string hole = "F0,0,-1 M5 M3 F0,0,0 M5 M4";
  EXPECT_EQ(under({}, blocks), "M4 " + hole + " " + hole);
  EXPECT_EQ(under({{"ngc.g74.l", "barred"}}, blocks), "!b2:unused-word");
  EXPECT_EQ(under({{"ngc.g74.l", "barred"}}, "M3 G99 G84 X0 Z-1 R0 L1"),
            "M3 F0,0,-1 M5 M4 F0,0,0 M5 M3");
}

TEST(NgcCycleReadings, KOfG33) {
  const Choice free = {"ngc.g33.k", "free"};
  EXPECT_EQ(trace("M3\nG33 Z-5 K0\nZ-6 K-2\nM2", ngc({free})), "M3 T0,0,-5@0 T0,0,-6@-2");
  EXPECT_EQ(trace("M4\nG33.1 Z-5 K0\nM2", ngc({free})), "M4 T0,0,-5@0 M3 T0,0,0@0 M4");
}

// t = tan 45 = 1, d = 1 and 2 of K = 2: the passes go from Z0 - (K - d) to Z1 + (K - d).
TEST(NgcCycleReadings, SlideOfG76) {
  const std::string blocks = "G18 M3\nG76 P2 Z-20 I-1 J1 K2 Q45";
  EXPECT_EQ(under({}, blocks),
            "M3 R1,0,-1 R-2,0,-1 T-2,0,-19@2 R1,0,-19 R0,0,-2 R-3,0,-2 T-3,0,-20@2 R0,0,-20");
  EXPECT_EQ(under({{"ngc.g76.slide", "end"}}, blocks),
            "M3 R1,0,1 R-2,0,1 T-2,0,-19@2 R1,0,-19 R0,0,0 R-3,0,0 T-3,0,-20@2 R0,0,-20");
}

TEST(NgcCycleReadings, EntryOfG76) {
  const std::string blocks = "G18 M3\nG76 P2 Z-20 I-1 J1 K2 H0 L1 E2";
  const auto with = [](const std::string& in) {
    return "M3 R1,0,0 " + in.substr(0, 1) + "0,0,0" + in.substr(1) +
           " T-2,0,-2@2 T-2,0,-20@2 R1,0,-20 R0,0,0 " + in.substr(0, 1) + "-1,0,0" + in.substr(1) +
           " T-3,0,-2@2 T-3,0,-20@2 R0,0,-20";
  };
  // The path lead of the taper: 2 sqrt(8)/2.
  EXPECT_EQ(under({}, blocks), with("T@2*sqrt(2)"));
  EXPECT_EQ(under({{"ngc.g76.entry", "feed"}}, blocks), with("F"));
  EXPECT_EQ(under({{"ngc.g76.entry", "rapid"}}, blocks), with("R"));
  EXPECT_EQ(trace(blocks + "\nM2", ngc({{"ngc.g76.entry", "feed"}})), "M3 !b2:feed-missing");
  EXPECT_EQ(trace("G18 M3\nG76 P2 Z-20 I-1 J1 K2 L2 E2\nM2", ngc({{"ngc.g76.entry", "feed"}})),
            "M3 R1,0,0 R-2,0,0 T-2,0,-18@2 T0,0,-20@2 R1,0,-20 R0,0,0 R-3,0,0 T-3,0,-18@2 "
            "T-1,0,-20@2 R0,0,-20");
}

// Also where something else is wrong with the block.
TEST(NgcCycleReadings, EntryOfG76WithoutFeedOrSpindle) {
  EXPECT_EQ(trace("G18\nG76 P2 Z-20 I-1 J1 K2 L1 E2\nM2", ngc({{"ngc.g76.entry", "feed"}})),
            "!b2:feed-missing,spindle-stopped");
}

TEST(NgcCycleReadings, G80BesideACycle) {
  const std::string hole = "F0,0,-1 R0,0,0";
  EXPECT_EQ(under({{"ngc.g80-beside", "ignored"}}, "G99 G80 G81 X0 Z-1 R0\nX0"), hole + " " + hole);
  EXPECT_EQ(under({{"ngc.g80-beside", "alarm"}}, "G99 G80 G81 X0 Z-1 R0"), "!b2:duplicate-word");
}

TEST(NgcCycleReadings, NearWholeNumbersOfHoles) {
  const std::string blocks = "G99 G91 G81 X1 Z-1 R0 L";
  const std::string two = "R1,0,0 F1,0,-1 R1,0,0 R2,0,0 F2,0,-1 R2,0,0";
  EXPECT_EQ(under({}, blocks + "2.00005"), "!b2:not-an-integer");
  for (const char* machine : {"nist", "linuxcnc"}) {
    EXPECT_EQ(under({{"ngc.whole", machine}}, blocks + "2.00005"), two);
    EXPECT_EQ(under({{"ngc.whole", machine}}, blocks + "2.0002"), "!b2:not-an-integer");
    EXPECT_EQ(under({{"ngc.whole", machine}}, blocks + "0.00005"), "!b2:value-out-of-range");
  }
}

Lines asked(const std::string& blocks) {
  return touched("F100\n" + blocks + "\nM2");
}

TEST(NgcCycleReadings, AreAskedForOnlyWhereTheyMatter) {
  EXPECT_EQ(asked("G0 Z10\nG98 G81 X1 Z-1 R2\nX2"), Lines{});
  EXPECT_EQ(asked("G0 Z10\nG99 G81 X1 Z-1 R2\nX2"), Lines{});
  EXPECT_EQ(asked("G81 X1 Z-1 R0"), Lines{});
  EXPECT_EQ(asked("G0 Z10\nG81 X1 Z-1 R2"), Lines{"ngc.cycle.retract-start"});
  EXPECT_EQ(asked("G0 Z10\nG99 G81 X1 Z-1 R2\nG98 X2"),
            (Lines{"ngc.cycle.initial", "ngc.cycle.approach"}));
  EXPECT_EQ(asked("G0 Z10\nG99 G81 X1 Z-1 R2\nX2 R4"), Lines{"ngc.cycle.approach"});
  // 10 inches are above R, and 10 mm are not.
  EXPECT_EQ(asked("G0 Z10\nG98 G81 X1 Z-1 R2\nG20 X2 R2 Z-1"),
            (Lines{"ngc.cycle.initial", "ngc.cycle.approach", "ngc.cycle.initial-kept"}));
  EXPECT_EQ(asked("G91 G99 G81 X1 Z-1 R0"), Lines{});
  EXPECT_EQ(asked("G0 Z10\nG91 G99 G81 X1 Z-1 R0"), Lines{"ngc.cycle.g91-r"});
  EXPECT_EQ(asked("G91 G99 G81 X1 Z-1 R1\nX1"), (Lines{"ngc.cycle.g91-r", "ngc.cycle.sticky"}));
}

TEST(NgcCycleReadings, OfPecksAreAskedForWhereThereAreSeveral) {
  EXPECT_EQ(asked("G0 Z10\nG98 G83 X1 Z-1 R2 Q3"), Lines{"ngc.peck.dwell"});
  EXPECT_EQ(asked("G0 Z10\nG98 G83 X1 Z-1 R2 Q2"),
            (Lines{"ngc.g83.retract", "ngc.g83.return", "ngc.peck.clearance", "ngc.peck.dwell"}));
  EXPECT_EQ(asked("G0 Z10\nG99 G83 X1 Z-1 R2 Q2"),
            (Lines{"ngc.g83.return", "ngc.peck.clearance", "ngc.peck.dwell"}));
  EXPECT_EQ(asked("G0 Z10\nG99 G73 X1 Z-1 R2 Q2"), (Lines{"ngc.peck.clearance", "ngc.peck.dwell"}));
  EXPECT_EQ(asked("G0 Z10\nG98 G73 X1 Z-1 R2 Q3"), (Lines{"ngc.peck.dwell", "ngc.g73.end"}));
}

TEST(NgcCycleReadings, OfOtherCyclesAreAskedForWhereTheyMatter) {
  EXPECT_EQ(asked("G0 Z10\nG99 G85 X1 Z-1 R2"), Lines{});
  EXPECT_EQ(asked("G0 Z10\nG98 G85 X1 Z-1 R2"), Lines{"ngc.g85.out"});
  EXPECT_EQ(asked("M3 G84 X1 Z-1 R0"), Lines{"ngc.tap.p"});
  EXPECT_EQ(asked("M4 G74 X1 Z-1 R0 P1 L2"), (Lines{"ngc.tap.p", "ngc.g74.l"}));
  EXPECT_EQ(asked("M3 G86 X1 Z-1 R0 P1"), Lines{});
  EXPECT_EQ(asked("G86 X0 Z-1 R0 P1"), Lines{});  // nothing would be moved
  EXPECT_EQ(asked("G86 X1 Z-1 R0 P1"), Lines{"ngc.cycle.alarm-at"});
  EXPECT_EQ(asked("G17\nM3\nG33.1 Z-1 K1\nG18 G76 P1 Z-5 I-1 J1 K2"), Lines{});
  EXPECT_EQ(asked("M3\nG18 G76 P1 Z-5 I-1 J1 K2 Q30 L1 E1"),
            (Lines{"ngc.g76.slide", "ngc.g76.entry"}));
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
