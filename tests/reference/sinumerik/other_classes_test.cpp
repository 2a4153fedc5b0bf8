// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-ALM-04: the classes that two readers of one rule give its alarm.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "sie_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

using Classes = std::set<std::string>;

Classes admitted(std::string_view program) {
  const Lines all = admitted_classes_of(program, sie());
  return Classes(all.begin(), all.end());
}

// Alarm 14040 says of both that the end point is wrong: a chord above twice CR, radii of 1 and 9.
TEST(SieOtherClasses, AnArcThatCannotBeHasOneAlarm) {
  const Classes arc = {"arc-radius", "arc-end-point"};
  EXPECT_EQ(admitted("F9\nG2 X11 CR=5"), arc);
  EXPECT_EQ(admitted("F9\nG2 X10 I1"), arc);
}

TEST(SieOtherClasses, ACountOrASignIsARange) {
  EXPECT_EQ(admitted("F9\nG3 X10 I5 TURN=1.5"), (Classes{"not-an-integer", "value-out-of-range"}));
  EXPECT_EQ(admitted("F9\nG3 X10 I5 TURN=-1"), (Classes{"value-out-of-range", "value-sign"}));
  EXPECT_EQ(admitted("F9\nG3 X10 I5 TURN=1000"), Classes{"value-out-of-range"});
  EXPECT_EQ(admitted("F9\nG3 I5 AR=-90"), (Classes{"value-out-of-range", "value-sign"}));
  EXPECT_EQ(admitted("F9\nG3 I5 AR=360"), Classes{"value-out-of-range"});
  EXPECT_EQ(admitted("G0 RP=-1 AP=0"), (Classes{"value-sign", "value-out-of-range"}));
}

TEST(SieOtherClasses, AFeedIsAWord) {
  EXPECT_EQ(admitted("G1 X1"), (Classes{"feed-missing", "missing-word"}));
}

// SIE-COM-03, whose other name stands in the catalog.
TEST(SieOtherClasses, NotOfAnUnstatedRule) {
  EXPECT_EQ(admitted("S-1"), Classes{"value-sign"});
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
