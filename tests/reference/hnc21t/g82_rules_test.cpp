// SPDX-License-Identifier: GPL-3.0-or-later
//
// G82, its rules.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

TEST(G82Rules, NeedsALead) {
  EXPECT_EQ(ending_of("G82 X20 Z-10"), "alarm b1 lead-missing");
  EXPECT_EQ(ending_of("F200\nG82 X20 Z-10"), "alarm b2 lead-missing");
  EXPECT_EQ(ending_of("G82 F2\nX20 Z-10"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2\nG00 X0\nG82 X20 Z-10"), "alarm b3 lead-missing");
  EXPECT_EQ(ending_of("G32 Z-10 F2\nG82 X20 Z-10"), "alarm b2 lead-missing");
}

TEST(G82Rules, ALeadIsAboveZero) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 F0"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F-1"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G82 X20 Z-10 J0"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G82 J-1"), "alarm b1 value-sign");
}

TEST(G82Rules, FAndJExcludeEachOther) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2 J2"), "alarm b1 conflicting-words");
  EXPECT_EQ(ending_of("G82 J2 F2"), "alarm b1 conflicting-words");
}

TEST(G82Rules, RAndEAreGivenBothOrNeither) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-2 F2"), "alarm b1 retract-pair");
  EXPECT_EQ(ending_of("G82 X20 Z-10 E1 F2"), "alarm b1 retract-pair");
  EXPECT_EQ(ending_of("G82 R-2 F2"), kEndAtOrigin);  // cuts nothing
  EXPECT_EQ(ending_of("G82 R-2 F2\nX20 Z-10 E1"), kEndAtOrigin);
}

TEST(G82Rules, ARunOutOfZeroIsNone) {
  const Lines plain = path("G82 X20 Z-10 F2");
  EXPECT_EQ(path("G82 X20 Z-10 R0 F2"), plain);
  EXPECT_EQ(path("G82 X20 Z-10 E0 F2"), plain);
  EXPECT_EQ(path("G82 X20 Z-10 R0 E0 F2"), plain);
}

// The long axis is Z: abs(E) <= 20 abs(R).
TEST(G82Rules, TheRatioIsAtMost20) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E2 F2"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E2.001 F2"), "alarm b1 retract-ratio");
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E-2.001 F2"), "alarm b1 retract-ratio");
  EXPECT_EQ(ending_of("G82 X20 Z-10 R0 E1 F2"), "alarm b1 retract-ratio");
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-100 E0.001 F2"), kEndAtOrigin);
}

// I 10.001 against a travel of 10: X is the long axis, abs(R) <= 20 abs(E). With equal travels it
// is Z.
TEST(G82Rules, TheLongAxisIsThatOfTheLongerTravel) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 I10.001 R-2 E0.1 F2"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 I10.001 R-2.001 E0.1 F2"), "alarm b1 retract-ratio");
  EXPECT_EQ(ending_of("G82 X20 Z-10 I-10.001 R-0.1 E5 F2"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 I10 R-2.001 E0.1 F2"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 I10 R-0.1 E2.001 F2"), "alarm b1 retract-ratio");
}

// E 4 as a diameter is 2 along X.
TEST(G82Rules, TheRatioTakesEAsItIsMeant) {
  const Profile diameter = hnc({{"hnc.g82.e-scale", "diameter"}});
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E4 F2"), "alarm b1 retract-ratio");
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E4 F2", diameter), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 R-0.1 E4.001 F2", diameter), "alarm b1 retract-ratio");
}

TEST(G82Rules, QIsNotNegative) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 Q-1 F2"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G82 Q-0.001"), "alarm b1 value-sign");
  EXPECT_EQ(path("G82 X20 Z-10 Q5 R-1 E1 F2"), path("G82 X20 Z-10 Q0 R-1 E1 F2"));
}

TEST(G82Rules, CIsAWholeNumberThatIsNotNegative) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 C-1 F2"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G82 X20 Z-10 C1.5 P90 F2"), "alarm b1 not-an-integer");
  EXPECT_EQ(ending_of("G82 X20 Z-10 C-1.5 F2"), "alarm b1 value-sign not-an-integer");
  EXPECT_EQ(ending_of("G82 C1.5"), "alarm b1 not-an-integer");
  EXPECT_EQ(ending_of("G82 X20 Z-10 C2.0 P90 F2"), kEndAtOrigin);
}

TEST(G82Rules, SeveralStartsNeedP) {
  EXPECT_EQ(ending_of("G82 X20 Z-10 C2 F2"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G82 C2 F2"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 C2 F2\nX20 Z-10 P120"), kEndAtOrigin);
}

TEST(G82Rules, NeedsBothAxes) {
  EXPECT_EQ(ending_of("G82 X20 F2"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2\nZ-10"), "alarm b2 missing-word");
}

// Eight threads to the inch are 25.4 / 8 = 3.175 mm each; a lead of 8 inches is 203.2 mm; F0.1
// under G20 is 0.1 mm or 2.54 mm.
TEST(G82Rules, ALeadIsMeantAsItsReadingSays) {
  struct Meaning {
    std::string_view value, f, j;
  };
  for (const Meaning& meaning :
       {Meaning{"mm", "0.1", "203.2"}, Meaning{"units", "2.54", "203.2"},
        Meaning{"tpi", "0.1", "3.175"}, Meaning{"units-tpi", "2.54", "3.175"}}) {
    const Profile profile = hnc({{"hnc.lead.unit", meaning.value}});
    EXPECT_EQ(path("G20 G32 Z-1 F0.1", profile).front(),
              "thread z-25.4 lead" + std::string(meaning.f) + " start0");
    EXPECT_EQ(path("G32 Z-1 J8", profile).front(),
              "thread z-1 lead" + std::string(meaning.j) + " start0");
    EXPECT_EQ(path("G32 Z-1 F1.5", profile).front(), "thread z-1 lead1.5 start0");
  }
  EXPECT_EQ(touched("G82 X20 Z-10 F2"), Lines{"hnc.g82.exit"});
}

// A block that lacks an axis may do nothing: it needs no lead, but what is written wrong is wrong.
TEST(G82Rules, ABlockWithoutAnAxisMayDoNothing) {
  const Profile profile = hnc({{"hnc.missing-axis", "nothing"}});
  EXPECT_EQ(ending_of("G82 X20", profile), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 C-1", profile), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G80 Z-5", profile), kEndAtOrigin);
  EXPECT_EQ(ending_of("G74 X5", profile), kEndAtOrigin);
  EXPECT_EQ(ending_of("G75 Z-5 I2", profile), kEndAtOrigin);
  EXPECT_EQ(path("G80 X20 F50\nX20 Z-10", profile).size(), 4U);
}

// Q comes with the versions 7.11 and 4.03.
TEST(G82Rules, AnOlderControlLacksQ) {
  const Profile older = hnc({{"hnc.g82.q", "alarm"}});
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2 Q20"), kEndAtOrigin);
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2 Q20", older), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2 Q-1", older), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G82 Q0 F2", older), "alarm b1 undefined-code");
  EXPECT_EQ(ending_of("G82 X20 Z-10 F2", older), kEndAtOrigin);
  EXPECT_EQ(ending_of("G74 Z-10 R1 Q3 F50", older), kEndAtOrigin);
  EXPECT_EQ(touched("G82 X20 Z-10 F2 Q20"), (Lines{"hnc.g82.q", "hnc.g82.exit"}));
}

TEST(G82Rules, EveryBrokenRuleIsReportedInTheOrderOfItsWord) {
  EXPECT_EQ(ending_of("G82 Q-1 X20 C1.5 Z-10 R-2 F0"),
            "alarm b1 value-sign not-an-integer retract-pair value-sign");
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
