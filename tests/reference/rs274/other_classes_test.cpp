// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two readers of one rule give its alarm.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>

#include "ngc_expanding.hpp"
#include "reference/expander.hpp"

namespace gonogo::reference::testing::ngc {
namespace {

using Classes = std::set<std::string>;

// All that the alarm of a program admits, each once.
Classes admitted(std::string_view program, const Profile& profile = ngc()) {
  const Lines all = admitted_classes_of(program, profile);
  Classes classes(all.begin(), all.end());
  EXPECT_EQ(classes.size(), all.size()) << program;
  return classes;
}

const Classes kSign = {"value-sign", "value-out-of-range"};
const Classes kFraction = {"not-an-integer", "value-out-of-range"};

Classes with(Classes classes, const Classes& more) {
  classes.insert(more.begin(), more.end());
  return classes;
}

// A bound of zero is a sign and a range.
TEST(OtherClasses, OfABoundOfZero) {
  EXPECT_EQ(admitted("F100\nG81 X1 Z-1 R1 L0\n"), kSign);
  EXPECT_EQ(admitted("F100\nG81 X1 Z-1 R1 L-1\n"), kSign);
  EXPECT_EQ(admitted("F100\nG0 X1\nG2 X3 I1 P0\n"), kSign);
  EXPECT_EQ(admitted("F100\nG83 X1 Z-1 R1 Q0\n"), kSign);
  EXPECT_EQ(admitted("G4 P-1\n"), kSign);
  EXPECT_EQ(admitted("S-1\n"), kSign);
  EXPECT_EQ(admitted("G43 H-2\n"), kSign);
  EXPECT_EQ(admitted("G10 L2 P-1 X1\n"), kSign);
  EXPECT_EQ(admitted("#1=SQRT[-1]\n"), kSign);
  EXPECT_EQ(admitted("G1 X1 F0\n"), with({"feed-missing", "missing-word"}, kSign));
  EXPECT_EQ(admitted("T5\n", ngc({{"ngc.missing-tool", "alarm"}})),
            (Classes{"no-tool", "value-out-of-range"}));
  // Above the range there is no sign.
  EXPECT_EQ(admitted("G10 L2 P10 X1\n"), Classes{"value-out-of-range"});
}

TEST(OtherClasses, OfAWordThatNothingTakesAndThatHasNoSuchNumber) {
  const Classes unused = {"unused-word"};
  EXPECT_EQ(admitted("G0 X1 H-2\n"), with(unused, kSign));
  EXPECT_EQ(admitted("G0 X1 L1.2\n"), with(unused, kFraction));
  EXPECT_EQ(admitted("F100 M3\nG84 X1 Z-1 R1 P-1\n", ngc({{"ngc.tap.p", "barred"}})),
            with(unused, kSign));
  EXPECT_EQ(admitted("G0 X1 R-2\n"), unused);
  EXPECT_EQ(admitted("G0 X1 H2\n"), unused);
}

TEST(OtherClasses, OfANumberThatIsNotWhole) {
  EXPECT_EQ(admitted("F100\nG81 X1 Z-1 R1 L1.2\n"), kFraction);
  EXPECT_EQ(admitted("T24.8\n"), kFraction);
  EXPECT_EQ(admitted("M3.5\n"), with(kFraction, {"undefined-code"}));
}

TEST(OtherClasses, OfCodesThatTheLanguageLacks) {
  EXPECT_EQ(admitted("G0.5\n"), (Classes{"undefined-code", "not-an-integer"}));
  EXPECT_EQ(admitted("G69\n"), Classes{"undefined-code"});
  EXPECT_EQ(admitted("G-1\n"), with({"undefined-code"}, kSign));
  EXPECT_EQ(admitted("M200\n"), (Classes{"undefined-code", "value-out-of-range"}));
}

TEST(OtherClasses, OfTwoCodesOfOneGroup) {
  const Classes two = {"duplicate-word", "conflicting-words"};
  EXPECT_EQ(admitted("F100\nG0 G1 X1\n"), two);
  EXPECT_EQ(admitted("M3 M4\n"), two);
  // Beside a code that is unknown.
  EXPECT_EQ(admitted("G80 G0 G69\n"), with(two, {"undefined-code"}));
  // Two codes that take one axis word.
  EXPECT_EQ(admitted("G28 G0 X0\n"), two);
  EXPECT_EQ(admitted("G92 G1 X0 F9\n"), two);
  // An address that stands twice is no code.
  EXPECT_EQ(admitted("G0 X1 X2\n"), Classes{"duplicate-word"});
}

TEST(OtherClasses, OfWordsThatTheMotionDoesNotTake) {
  EXPECT_EQ(admitted("F100\nG2 X2 I1 R1\n"), (Classes{"conflicting-words", "unused-word"}));
  EXPECT_EQ(admitted("F100\nG81 X1 Z-1 R1 A5\n"),
            (Classes{"axis-not-in-plane", "unused-word", "conflicting-words"}));
  EXPECT_EQ(admitted("G80 X1\n"), (Classes{"missing-word", "unused-word"}));
  EXPECT_EQ(admitted("M3\nG33 Z-1 K1 F100\n"), (Classes{"conflicting-words", "unused-word"}));
}

TEST(OtherClasses, OfWhatIsMissingAndOfArcs) {
  EXPECT_EQ(admitted("G10 L2 X1\n"), (Classes{"missing-word", "value-out-of-range"}));
  EXPECT_EQ(admitted("G0 X#<a>\n"), (Classes{"missing-word", "value-out-of-range"}));
  EXPECT_EQ(admitted("G1 X1\n"), (Classes{"feed-missing", "missing-word"}));
  EXPECT_EQ(admitted("M3\nG33 Z-1\n"), (Classes{"lead-missing", "missing-word"}));
  EXPECT_EQ(admitted("F100\nG2 X9 R1\n"), (Classes{"arc-radius", "arc-end-point"}));
  EXPECT_EQ(admitted("F100\nG2 X9 I1\n"), (Classes{"arc-radius", "arc-end-point"}));
}

TEST(OtherClasses, OfALineNumberThatIsTooLarge) {
  EXPECT_EQ(admitted("N100000 G0 X1\n", ngc({{"ngc.line-number", "whole"}})),
            with({"syntax"}, kFraction));
}

// The rule that is broken is one, under each of its names.
TEST(OtherClasses, AreNoFurtherRulesThatAreBroken) {
  EXPECT_EQ(ending_of("F100\nG81 X1 Z-1 R1 L0\n").find(','), std::string::npos);
}

}  // namespace
}  // namespace gonogo::reference::testing::ngc
