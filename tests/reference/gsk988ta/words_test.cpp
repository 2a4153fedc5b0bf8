// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a block may hold outside the cycles: GSK-COM-01, 02, 03, 06, 07. X and U words
// are diameters; records are true lengths in mm.
#include <gtest/gtest.h>

#include "expanding.hpp"
#include "reference/dialect.hpp"

namespace gonogo::reference::testing {
namespace {

TEST(Words, Com02ACodeThatTheMakerLacksIsUndefined) {
  for (const char* code : {"G6", "G77", "G118", "G999", "G94.5", "G0.1", "G110.01", "G1000",
                           "G12345678901234567890", "G0.40"}) {
    EXPECT_EQ(ending(std::string("Z1\n") + code), "alarm b2 undefined-code") << code;
  }
}

TEST(Words, Com02ACodeWithZerosAfterThePointIsTheCode) {
  EXPECT_EQ(lines("G1.0 Z1 F100"), Lines{"feed z1 f100"});
  EXPECT_EQ(lines("G1.00 Z1 F100"), Lines{"feed z1 f100"});
  EXPECT_EQ(ending("G71.000"), "not-covered b1 G71");
}

TEST(Words, Com02TextThatCannotBeReadIsASyntaxAlarmAlone) {
  for (const char* text : {"X", "X1..2", "?", "g0 X1", "(open", "X1 N5"}) {
    // F-1 would be an alarm too, if the block could be read.
    EXPECT_EQ(ending("Z1\nF-1 " + std::string(text)), "alarm b2 syntax") << text;
  }
}

TEST(Words, Com02ASyntaxAlarmHasItsPlace) {
  const std::vector<Item> items = expand("Z1\nX5 ?");
  const auto& report = std::get<AlarmReport>(items.back());
  EXPECT_EQ(report.block, 2U);
  ASSERT_EQ(report.alarms.size(), 1U);
  EXPECT_EQ(report.alarms[0].where.begin, 3U);
  EXPECT_TRUE(report.syntax.has_value());
}

TEST(Words, NoneOfTheMotionOfTheAlarmingBlockRuns) {
  EXPECT_EQ(lines("Z1\nM3 Z2\nM8 Z3 F-1\nZ4"),
            (Lines{"rapid z1", "m3", "rapid z2", "alarm b3 value-sign"}));
}

TEST(Words, AlarmsOfABlockStandInTheOrderOfTheirWords) {
  EXPECT_EQ(ending("F-1 G6 X1 X2"), "alarm b1 value-sign undefined-code duplicate-word");
  EXPECT_EQ(ending("X1 X2 G6 F-1"), "alarm b1 duplicate-word undefined-code value-sign");
}

TEST(Words, NotCoveredCodesEndTheProgramByName) {
  for (const char* code :
       {"G05", "G7.1", "G10", "G12.1", "G13.1", "G30", "G31", "G32", "G33", "G34", "G41",
        "G42", "G52",  "G53", "G55",   "G59",   "G65", "G66", "G70", "G71", "G72", "G73",
        "G74", "G75",  "G76", "G83",   "G84",   "G85", "G87", "G88", "G89"}) {
    EXPECT_EQ(lines("Z1\n" + std::string(code) + " X1 F-1\nZ2"),
              (Lines{"rapid z1", "not-covered b2 " + std::string(code)}));
  }
}

// The maker names them in chapters of their own or in the texts of its parameters.
TEST(Words, CodesThatTheMakerNamesElsewhereAreNotUndefined) {
  for (const char* code : {"G2.1",  "G3.1",  "G2.2", "G3.2",  "G6.4",  "G6.5",  "G6.6",  "G7.9",
                           "G10.9", "G25",   "G26",  "G32.1", "G32.2", "G32.3", "G51.2", "G51.3",
                           "G53.3", "G68.1", "G78",  "G92.1", "G92.2", "G165",  "G166",  "G211"}) {
    EXPECT_EQ(lines("Z1\n" + std::string(code) + " X1\nZ2"),
              (Lines{"rapid z1", "not-covered b2 " + std::string(code)}));
  }
}

TEST(Words, EveryCodeOfTheOutsideListIsNotCoveredByItsName) {
  const auto codes = outside_codes(*find_dialect("gsk988ta")->descriptor);
  ASSERT_FALSE(codes.empty());
  for (const OutsideCode& outside : codes) {
    const std::string code(outside.code);
    EXPECT_EQ(ending("Z1\n" + code), "not-covered b2 " + code);
  }
}

TEST(Words, ConstructsOfTheMacroLanguageAreNotCovered) {
  EXPECT_EQ(ending("Z1\n#100=5"), "not-covered b2 variable");
  EXPECT_EQ(ending("Z1\nG1 Z#1 F100"), "not-covered b2 variable");
  EXPECT_EQ(ending("Z1\nG1 Z[1+2] F100"), "not-covered b2 expression");
  EXPECT_EQ(ending("Z1\nGOTO 5"), "not-covered b2 control-statement");
}

TEST(Words, SubprogramsAreNotCovered) {
  EXPECT_EQ(ending("Z1\nM98 P1234"), "not-covered b2 M98");
  EXPECT_EQ(ending("Z1\nM99"), "not-covered b2 M99");
}

TEST(Words, Com01AnAxisAbsoluteAndAsAnIncrementIsAConflict) {
  for (const char* words : {"X1 U1", "U1 X1", "Y1 V1", "Z1 W1", "W0 Z0"}) {
    EXPECT_EQ(ending("G0 " + std::string(words)), "alarm b1 conflicting-words") << words;
  }
  EXPECT_EQ(ending("G0 X2 V1 W1"), "end x1 y1 z1 a0 c0");
}

TEST(Words, Com07AnAddressTwiceIsAnAlarm) {
  for (const char* words : {"X1 X1", "Z1 X1 Z1", "F1 F1", "M3 M8", "S1 S2"}) {
    EXPECT_EQ(ending("G0 " + std::string(words)), "alarm b1 duplicate-word") << words;
  }
}

TEST(Words, Com07TwoCodesOfOneGroupAreAnAlarm) {
  for (const char* codes : {"G0 G1", "G17 G18", "G20 G21", "G98 G99", "G4 G28", "G50 G28"}) {
    EXPECT_EQ(ending("F100 P1 " + std::string(codes)), "alarm b1 duplicate-word") << codes;
  }
}

TEST(Words, ReadingDuplicateLastLetsTheLaterOneWin) {
  const Profile last = profile_with({{"gsk.duplicate", "last"}});
  EXPECT_EQ(lines("X1 X2", last), Lines{"rapid x1"});
  EXPECT_EQ(lines("G0 G1 Z1 F100", last), Lines{"feed z1 f100"});
  EXPECT_EQ(lines("G1 G0 Z1 F100", last), Lines{"rapid z1"});
  EXPECT_EQ(ending("X1 U1", last), "alarm b1 conflicting-words");
}

TEST(Words, Com07Parameter3403Bit6DecidesOverTheReading) {
  Profile last = profile_with({{"gsk.duplicate", "alarm"}});
  last.parameters["3403.6"] = num("0");
  EXPECT_EQ(lines("X1 X2", last), Lines{"rapid x1"});
  Profile alarm = profile_with({{"gsk.duplicate", "last"}});
  alarm.parameters["3403.6"] = num("1");
  EXPECT_EQ(ending("X1 X2", alarm), "alarm b1 duplicate-word");
}

TEST(Words, Com15Parameter3404Bit6WantsAWordThatEndsTheProgram) {
  Profile wants;
  wants.parameters["3404.6"] = num("0");
  EXPECT_EQ(ending("G0 X2\nX4", wants), "alarm b2 program-end");
  EXPECT_EQ(lines("G0 X2\nX4", wants), (Lines{"rapid x1", "rapid x2", "alarm b2 program-end"}));
  for (const char* end : {"M30", "M2", "%"}) {
    EXPECT_EQ(ending("G0 X2\n" + std::string(end), wants), "end x1 y0 z0 a0 c0") << end;
  }
  wants.parameters["3404.6"] = num("1");
  EXPECT_EQ(ending("G0 X2", wants), "end x1 y0 z0 a0 c0");
}

// M3 before the motion, M9 behind it. A fourth is one too many.
TEST(Words, Com11UpToThreeMFunctionsMayStandInABlock) {
  const Profile three = profile_with({{"gsk.m-functions", "three"}});
  EXPECT_EQ(lines("M9 G0 X2 M8 M3", three), (Lines{"m8", "m3", "rapid x1", "m9"}));
  EXPECT_EQ(ending("G0 X2 M3 M4 M8 M9", three),
            "alarm b1 duplicate-word duplicate-word duplicate-word");
  EXPECT_EQ(ending("G0 X2 X2 M3 M8", three), "alarm b1 duplicate-word");
  Profile parameter = profile_with({{"gsk.m-functions", "one"}});
  parameter.parameters["3404.7"] = num("1");
  EXPECT_EQ(lines("M3 M8", parameter), (Lines{"m3", "m8"}));
  parameter = profile_with({{"gsk.m-functions", "three"}, {"gsk.duplicate", "last"}});
  parameter.parameters["3404.7"] = num("0");
  EXPECT_EQ(lines("M3 M8", parameter), Lines{"m8"});
}

TEST(Words, ReadingDecimalsKeepKeepsTheExactValue) {
  EXPECT_EQ(lines("X0.0001 Z1.23456789"), Lines{"rapid x0.00005 z1.23456789"});
}

TEST(Words, ReadingDecimalsNearestRoundsToTheLeastIncrement) {
  const Profile nearest = profile_with({{"gsk.decimals", "nearest"}});
  EXPECT_EQ(
      lines("X10.0014\nX10.0016\nZ-1.0014\nZ-1.0016\nZ1.001", nearest),
      (Lines{"rapid x5.0005", "rapid x5.001", "rapid z-1.001", "rapid z-1.002", "rapid z1.001"}));
  // ISB in inches has four decimals: 0.00014 is 0.0001 in = 0.00254 mm.
  EXPECT_EQ(lines("G20 Z0.00014", nearest), Lines{"rapid z0.00254"});
}

TEST(Words, ReadingDecimalsNearestInIscHasOneDecimalMore) {
  Profile nearest = profile_with({{"gsk.decimals", "nearest"}});
  nearest.increment = Increment::isc;
  EXPECT_EQ(lines("Z1.0014\nZ1.00014\nG20 Z0.00001", nearest),
            (Lines{"rapid z1.0014", "rapid z1.0001", "rapid z0.000254"}));
}

TEST(Words, ReadingDecimalsAlarmTakesAsManyAsTheIncrementHas) {
  Profile alarm = profile_with({{"gsk.decimals", "alarm"}});
  const std::string refused = "alarm b1 value-out-of-range";
  EXPECT_EQ(ending("Z1.001", alarm), "end x0 y0 z1.001 a0 c0");
  EXPECT_EQ(ending("Z1.0001", alarm), refused);
  EXPECT_EQ(ending("G20 Z0.0001", alarm), "end x0 y0 z0.00254 a0 c0");
  EXPECT_EQ(ending("G20 Z0.00001", alarm), refused);
  alarm.increment = Increment::isc;
  EXPECT_EQ(ending("Z1.0001", alarm), "end x0 y0 z1.0001 a0 c0");
  EXPECT_EQ(ending("Z1.00001", alarm), refused);
  EXPECT_EQ(ending("G20 Z0.00001", alarm), "end x0 y0 z0.000254 a0 c0");
  EXPECT_EQ(ending("G20 Z0.000001", alarm), refused);
}

TEST(Words, ReadingDecimalsIsNotAboutFeedsAndDwells) {
  for (const char* choice : {"nearest", "alarm"}) {
    const Profile profile = profile_with({{"gsk.decimals", choice}});
    EXPECT_EQ(lines("G1 Z1 F0.12345", profile), Lines{"feed z1 f0.12345"}) << choice;
    EXPECT_EQ(lines("G4 X0.12345", profile), Lines{"dwell 0.12345"}) << choice;
  }
}

TEST(Words, Com06RangesAreNotHeldOutsideTheCycles) {
  EXPECT_EQ(lines("G0 Z1000000"), Lines{"rapid z1000000"});
  EXPECT_EQ(lines("G0 Z1 M1 S1000000"), (Lines{"rapid z1", "m1"}));
}

}  // namespace
}  // namespace gonogo::reference::testing
