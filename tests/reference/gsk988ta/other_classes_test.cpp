// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two readers of one rule give its alarm.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

using Classes = std::set<std::string>;

// All that the alarm of a program admits, each once.
Classes admitted(std::string_view program, const Profile& profile = {}) {
  const Lines all = admitted_classes_of(program, profile);
  Classes classes(all.begin(), all.end());
  EXPECT_EQ(classes.size(), all.size()) << program;
  return classes;
}

const std::string kPocketStart = "F100\nG110 X0 Z0 Y-5 ";
const std::string kThreadStart = "F100\nG114 X0 Z0 Y-5 I2 J1 K0 ";

TEST(GskOtherClasses, ASignIsARange) {
  const Classes sign = {"value-out-of-range", "value-sign"};
  EXPECT_EQ(admitted(kPocketStart + "I16 L0 Q5 D4"), sign);
  EXPECT_EQ(admitted(kPocketStart + "I16 L3 Q-5 D4"), sign);
  EXPECT_EQ(admitted(kThreadStart + "E24 P-1 D3"), sign);
  EXPECT_EQ(admitted("G94 X2 Z1000000 F100"), Classes{"value-out-of-range"});
}

TEST(GskOtherClasses, ANumberOfTurnsIsANumberInARange) {
  EXPECT_EQ(admitted("F100\nG112 X0 Z0 Y-5 I8 D4 L1.5"),
            (Classes{"not-an-integer", "value-out-of-range"}));
}

TEST(GskOtherClasses, ASizeThatIsLimitedByAnotherHasARange) {
  EXPECT_EQ(admitted(kPocketStart + "I4 L3 Q5 D4"),
            (Classes{"tool-too-large", "value-out-of-range"}));
  EXPECT_EQ(admitted(kPocketStart + "I16 L8 Q5 D4"),
            (Classes{"step-too-large", "value-out-of-range"}));
  EXPECT_EQ(admitted(kThreadStart + "E24 P4 D3"),
            (Classes{"depth-exceeds-tool", "value-out-of-range"}));
  EXPECT_EQ(admitted("G90 U-2 W-5 R2 F100"), (Classes{"taper-limit", "value-out-of-range"}));
}

TEST(GskOtherClasses, AFeedAndALeadAreWords) {
  EXPECT_EQ(admitted("G01 X5"), (Classes{"feed-missing", "missing-word"}));
  EXPECT_EQ(admitted("G92 X5 Z-5"), (Classes{"lead-missing", "missing-word"}));
}

TEST(GskOtherClasses, TwoCodesOfOneGroupExcludeEachOther) {
  EXPECT_EQ(admitted("G00 G01 X5 F100"), (Classes{"duplicate-word", "conflicting-words"}));
  EXPECT_EQ(admitted("G00 X5 X5"), Classes{"duplicate-word"});
}

TEST(GskOtherClasses, AnAxisOutsideThePlaneHasNoUse) {
  EXPECT_EQ(admitted("G94 X5 Z-5 Y2 F100"),
            (Classes{"axis-not-in-plane", "conflicting-words", "unused-word"}));
}

TEST(GskOtherClasses, AnArcIsWrongInItsRadiusOrItsEnd) {
  EXPECT_EQ(admitted("G02 X0 Z0 R5 F9"), (Classes{"arc-end-point", "arc-radius"}));
  EXPECT_EQ(admitted("G02 Z10.002 R5 F9"), (Classes{"arc-end-point", "arc-radius"}));
}

// The names of a rule that no text states are the catalog's, and make an advice (R7).
TEST(GskOtherClasses, AnUnstatedRuleHasItsNamesInTheCatalog) {
  EXPECT_EQ(admitted("G00 X5 F-1"), Classes{"value-sign"});
  EXPECT_EQ(admitted("G04 P-1"), Classes{"value-sign"});
}

}  // namespace
}  // namespace gonogo::reference::testing
