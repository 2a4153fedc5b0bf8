// SPDX-License-Identifier: GPL-3.0-or-later
//
// HNC-COM-01: traverses, feeds, dwells and G32.
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

TEST(HncBasic, PowerOnIsATraverseInMmDiametersAndFeedPerMinute) {
  EXPECT_EQ(path("X10 Z5\nG01 Z6 F100"), (Lines{"rapid x5 z5", "feed z6 f100"}));
}

TEST(HncBasic, NamesTheAxesThatAreCommanded) {
  EXPECT_EQ(path("G00 X50\nZ-24\nG01 W-1 F100\nU-2"),
            (Lines{"rapid x25", "rapid z-24", "feed z-25 f100", "feed x24 f100"}));
}

TEST(HncBasic, FeedsPerRevolution) {
  EXPECT_EQ(path("G95 G01 X10 F0.2\nG94 X20"), (Lines{"feed x5 f0.2/rev", "feed x10 f0.2"}));
}

TEST(HncBasic, ACutNeedsAFeed) {
  EXPECT_EQ(ending_of("G01 X10"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("G01 X10 F0"), "alarm b1 feed-missing");
  EXPECT_EQ(ending_of("F-1"), "alarm b1 value-sign");
  Profile profile = hnc();
  profile.initial.feed = 90;
  EXPECT_EQ(path("G01 X10", profile), Lines{"feed x5 f90"});
}

TEST(HncBasic, DwellsMilliseconds) {
  EXPECT_EQ(path("G04 P4000\nG04 P0.5"), (Lines{"dwell 4", "dwell 0.0005"}));
  const Profile seconds = hnc({{"hnc.dwell.unit", "s"}});
  EXPECT_EQ(path("G04 P4\nG04 P0.5", seconds), (Lines{"dwell 4", "dwell 0.5"}));
  EXPECT_EQ(ending_of("G04"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G04 X5"), "not-covered b1 X");
  EXPECT_EQ(ending_of("G04 P0.5 Z99"), "not-covered b1 Z");
  EXPECT_EQ(ending_of("G04 P-1"), "alarm b1 value-sign");
  EXPECT_EQ(path("G04 P1000 F80\nG01 X2"), (Lines{"dwell 1", "feed x1 f80"}));
}

// The textbook's example 11.
TEST(HncBasic, G32CutsTheThreadOfTheTextbook) {
  EXPECT_EQ(path("%\nO0235\nN1 T0101\nN2 G90 G00 X50 Z120\nN3 M03 S300\nN4 G00 X29.2 Z101.5\n"
                 "N5 G32 Z19 F1.5\nN6 G00 X40\nN7 Z101.5\nN16 U-11.96\nN17 G32 W-82.5 F1.5\n"
                 "N18 G00 X40\nN21 M30\n%"),
            (Lines{"rapid x25 z120", "rapid x14.6 z101.5", "thread z19 lead1.5 start0", "rapid x20",
                   "rapid z101.5", "rapid x14.02", "thread z19 lead1.5 start0", "rapid x20"}));
}

TEST(HncBasic, G32CutsATaper) {
  EXPECT_EQ(path("G32 X20 Z-30 F2"), Lines{"thread x10 z-30 lead2 start0"});
  EXPECT_EQ(path("G32 X20 Z-30 J1"), Lines{"thread x10 z-30 lead25.4 start0"});
}

TEST(HncBasic, TheLeadOfG32HoldsWhileItIsInForce) {
  EXPECT_EQ(path("G32 F2\nZ-10\nG32 Z-20"),
            (Lines{"thread z-10 lead2 start0", "thread z-20 lead2 start0"}));
  EXPECT_EQ(ending_of("G32 Z-10 F2\nG00 Z0\nG32 Z-10"), "alarm b3 lead-missing");
}

TEST(HncBasic, G32ChecksItsLead) {
  EXPECT_EQ(ending_of("G32 Z-10"), "alarm b1 lead-missing");
  EXPECT_EQ(ending_of("G32 Z-10 F0"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G32 Z-10 F2 J2"), "alarm b1 conflicting-words");
  EXPECT_EQ(ending_of("G32"), "end x0 y0 z0 a0 c0");
}

TEST(HncBasic, OtherFormsOfG32AreNotCovered) {
  for (const char* word : {"R-2", "E1", "P90", "C2", "Q1", "K1", "I1"}) {
    EXPECT_EQ(ending_of("G32 Z-10 F2 " + std::string(word)), "not-covered b1 G32") << word;
  }
  EXPECT_EQ(path("G32 Z-10 F2 R0 E0 P0 C0 Q0 K0 I0"), Lines{"thread z-10 lead2 start0"});
  // What is not covered goes before what is wrong.
  EXPECT_EQ(ending_of("G32 Z-10 W1 F-1 R-2"), "not-covered b1 G32");
}

TEST(HncBasic, TheReadingOfTheLeadHoldsForG32) {
  EXPECT_EQ(path("G20 G32 Z-1 F2"), Lines{"thread z-25.4 lead2 start0"});
  EXPECT_EQ(path("G20 G32 Z-1 F2", hnc({{"hnc.lead.unit", "units"}})),
            Lines{"thread z-25.4 lead50.8 start0"});
}

TEST(HncBasic, MFunctionsArePassedOn) {
  EXPECT_EQ(lines("M03 X10\nX20 M05\nM30\nX30", hnc()),
            (Lines{"m3", "rapid x5", "rapid x10", "m5", "m30"}));
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
