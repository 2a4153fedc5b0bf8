// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two readers of one rule give its alarm.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "hnc_expanding.hpp"
#include "reference/expander.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

using Classes = std::set<std::string>;

// All that the alarm of a program admits, each once.
Classes admitted(std::string_view program, const Profile& profile = hnc()) {
  const Lines all = admitted_classes_of(program, profile);
  Classes classes(all.begin(), all.end());
  EXPECT_EQ(classes.size(), all.size()) << program;
  return classes;
}

TEST(HncOtherClasses, ASignIsARange) {
  const Classes sign = {"value-sign", "value-out-of-range"};
  EXPECT_EQ(admitted("G74 Z-10 Q0 F50"), sign);
  EXPECT_EQ(admitted("G74 Z-10 R-1 Q3 F50"), sign);
  EXPECT_EQ(admitted("G75 X-10 Q-3 F50"), sign);
  EXPECT_EQ(admitted("G82 X20 Z-10 Q-1 F2"), sign);
  EXPECT_EQ(admitted("G82 X20 Z-10 C-1 F2"), sign);
}

TEST(HncOtherClasses, ACountIsANumberInARange) {
  const Classes fraction = {"not-an-integer", "value-out-of-range"};
  EXPECT_EQ(admitted("G75 X-10 Z-2 I1.5 F50"), fraction);
  EXPECT_EQ(admitted("G82 X20 Z-10 C1.5 P90 F2"), fraction);
  // A count that is none at all has the wrong sign, too.
  const Classes none = {"not-an-integer", "value-out-of-range", "value-sign"};
  EXPECT_EQ(admitted("G75 X-10 Z-2 I0 F50"), none);
  EXPECT_EQ(admitted("G75 X-10 Z-2 I-1 F50"), none);
}

TEST(HncOtherClasses, HalfARunOutLacksAWord) {
  EXPECT_EQ(admitted("G82 X20 Z-10 R-2 F2"), (Classes{"retract-pair", "missing-word"}));
  EXPECT_EQ(admitted("G82 X20 Z-10 R-1 E21 F2"), (Classes{"retract-ratio", "value-out-of-range"}));
}

TEST(HncOtherClasses, AnAddressThatTheControlLacksIsAWordWithoutUse) {
  EXPECT_EQ(admitted("G82 X20 Z-10 Q5 F2", hnc({{"hnc.g82.q", "alarm"}})),
            (Classes{"undefined-code", "unused-word", "conflicting-words"}));
  EXPECT_EQ(admitted("G999"), Classes{"undefined-code"});
}

TEST(HncOtherClasses, AFeedAndALeadAreWords) {
  EXPECT_EQ(admitted("G80 X20 Z-10"), (Classes{"feed-missing", "missing-word"}));
  EXPECT_EQ(admitted("G82 X20 Z-10"), (Classes{"lead-missing", "missing-word"}));
  EXPECT_EQ(admitted("G32 Z-10"), (Classes{"lead-missing", "missing-word"}));
}

TEST(HncOtherClasses, AnArcIsWrongInItsRadiusOrItsEnd) {
  EXPECT_EQ(admitted("G02 X0 Z0 R5 F9"), (Classes{"arc-end-point", "arc-radius"}));
  EXPECT_EQ(admitted("G02 Z10.002 R5 F9"), (Classes{"arc-end-point", "arc-radius"}));
}

// The names of a rule that no text states are the catalog's, and make an advice (R7).
TEST(HncOtherClasses, AnUnstatedRuleHasItsNamesInTheCatalog) {
  EXPECT_EQ(admitted("G32 Z-10 F0"), Classes{"value-sign"});
  EXPECT_EQ(admitted("G04 P-1"), Classes{"value-sign"});
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
