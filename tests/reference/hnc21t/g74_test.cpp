// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "hnc_expanding.hpp"

namespace gonogo::reference::testing::hnc {
namespace {

// F-4 R-3 becomes feed z-4, rapid z-3.
Lines along_z(std::initializer_list<const char*> points, const std::string& f) {
  Lines want;
  for (const std::string point : points) {
    want.push_back(point[0] == 'F' ? "feed z" + point.substr(1) + " f" + f
                                   : "rapid z" + point.substr(1));
  }
  return want;
}

// A Z2, pecks of 6 to Z-17: ends at 2 - 6k, the last one short.
TEST(G74, PecksToTheBottom) {
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 Z-17 R1 Q6 F50"),
            along_z({"F-4", "R-3", "F-10", "R-9", "F-16", "R-15", "F-17", "R2"}, "50"));
}

// A Z10, 70 deep in pecks of 5: 14 pecks and 13 withdrawals, no more at the exact multiple.
TEST(G74, AnExactMultipleHasNoExtraPeck) {
  const Lines got = cycle("G00 X0 Z10", "G74 Z-60 R1 Q5 F1000");
  ASSERT_EQ(got.size(), 28U);
  EXPECT_EQ(Lines(got.begin(), got.begin() + 6),
            along_z({"F5", "R6", "F0", "R1", "F-5", "R-4"}, "1000"));
  EXPECT_EQ(Lines(got.end() - 4, got.end()), along_z({"F-55", "R-54", "F-60", "R10"}, "1000"));
}

TEST(G74, AStepAboveAMultipleIsOnePeckMore) {
  EXPECT_EQ(path("G74 Z-10 R1 Q5 F50"), along_z({"F-5", "R-4", "F-10", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-10.001 R1 Q5 F50"),
            along_z({"F-5", "R-4", "F-10", "R-9", "F-10.001", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-9.999 R1 Q5 F50"), along_z({"F-5", "R-4", "F-9.999", "R0"}, "50"));
}

TEST(G74, DrillsInOneWithoutAWithdrawal) {
  const Lines want = along_z({"F-17", "R2"}, "50");
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 Z-17 Q6 F50"), want);
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 Z-17 R0 Q6 F50"), want);
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 Z-17 F50"), want);
}

TEST(G74, APeckAtLeastAsDeepAsTheHoleIsOne) {
  EXPECT_EQ(path("G74 Z-17 R1 Q17 F50"), along_z({"F-17", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-17 R1 Q100 F50"), along_z({"F-17", "R0"}, "50"));
}

TEST(G74, DrillsTowardsPlusZ) {
  EXPECT_EQ(path("G74 Z7 R1 Q3 F50"), along_z({"F3", "R2", "F6", "R5", "F7", "R0"}, "50"));
}

// W-19 from A Z2.
TEST(G74, TakesIncrementsFromA) {
  const Lines want = cycle("G00 X0 Z2", "G74 Z-17 R1 Q6 F50");
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 W-19 R1 Q6 F50"), want);
  EXPECT_EQ(cycle("G00 X0 Z2", "G91 G74 Z-19 R1 Q6 F50"), want);
}

TEST(G74, XAndUHaveNoEffect) {
  const Lines want = path("G74 Z-17 R1 Q6 F50");
  EXPECT_EQ(path("G74 X30 Z-17 R1 Q6 F50"), want);
  EXPECT_EQ(path("G74 U30 Z-17 R1 Q6 F50"), want);
  EXPECT_EQ(ending_of("G00 X10\nG74 X30 Z-17 F50"), "end x5 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G74 X30 U1 Z-17 F50"), "alarm b1 conflicting-words");
}

TEST(G74, XIsNoZ) {
  EXPECT_EQ(ending_of("G74 X30 F50"), "alarm b1 missing-word");
  EXPECT_EQ(path("G74 X30 F50", hnc({{"hnc.missing-axis", "none"}})), along_z({"F0", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-5 F50\nX30", hnc({{"hnc.missing-axis", "keep"}})),
            along_z({"F-5", "R0", "F-5", "R0"}, "50"));
}

TEST(G74, AHoleWithoutDepthGoesNowhere) {
  EXPECT_EQ(path("G74 Z0 R1 Q6 F50"), along_z({"F0", "R0"}, "50"));
}

// An inherited R withdraws; R0 ends that.
TEST(G74, RetainsItsWords) {
  EXPECT_EQ(path("G74 Z-10 R1 Q6 F50\nZ-8"),
            along_z({"F-6", "R-5", "F-10", "R0", "F-6", "R-5", "F-8", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-10 R1 Q6 F50\nZ-8 R0"),
            along_z({"F-6", "R-5", "F-10", "R0", "F-8", "R0"}, "50"));
}

TEST(G74, ChecksTheSignsOfItsWords) {
  EXPECT_EQ(ending_of("G74 Z-10 R-0.001 Q6 F50"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G74 Z-10 R1 Q0 F50"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G74 Z-10 R1 Q-6 F50"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G74 Z-10 Q-6 F50"), "alarm b1 value-sign");
  EXPECT_EQ(ending_of("G74 R-1 Q-1"), "alarm b1 value-sign value-sign");
}

TEST(G74, AWithdrawalNeedsAPeck) {
  EXPECT_EQ(ending_of("G74 Z-10 R1 F50"), "alarm b1 missing-word");
  EXPECT_EQ(ending_of("G74 R1 F50"), "end x0 y0 z0 a0 c0");
  EXPECT_EQ(ending_of("G74 R1 F50\nZ-10 Q5"), "end x0 y0 z0 a0 c0");
}

TEST(G74, NeedsAFeed) {
  EXPECT_EQ(ending_of("G74 Z-10"), "alarm b1 feed-missing");
}

TEST(G74, NamesTheClauseOfEachMotion) {
  EXPECT_EQ(clauses("G74 Z-10 R1 Q5 F50"),
            (Lines{"HNC-G74-02", "HNC-G74-02", "HNC-G74-02", "HNC-G74-02"}));
  EXPECT_EQ(clauses("G74 Z-10 F50"), (Lines{"HNC-G74-03", "HNC-G74-03"}));
}

// From the withdrawn point a peck of 6 gains 5: ends at 6, 11, 16, 17 below A.
TEST(G74, CountsFromTheWithdrawnPointUnderItsReading) {
  const Profile withdrawn = hnc({{"hnc.peck.from", "withdrawn"}});
  EXPECT_EQ(cycle("G00 Z2", "G74 Z-15 R1 Q6 F50", withdrawn),
            along_z({"F-4", "R-3", "F-9", "R-8", "F-14", "R-13", "F-15", "R2"}, "50"));
  // 6 + 5 + 5 is the bottom itself.
  EXPECT_EQ(path("G74 Z-16 R1 Q6 F50", withdrawn),
            along_z({"F-6", "R-5", "F-11", "R-10", "F-16", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-6 R1 Q6 F50", withdrawn), along_z({"F-6", "R0"}, "50"));
}

TEST(G74, AWithdrawalOfAPeckNeverArrivesUnderThatReading) {
  const Profile withdrawn = hnc({{"hnc.peck.from", "withdrawn"}});
  EXPECT_EQ(ending_of("G74 Z-16 R6 Q6 F50", withdrawn), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending_of("G74 Z-16 R7 Q6 F50", withdrawn), "alarm b1 value-out-of-range");
  EXPECT_EQ(ending_of("G74 Z-16 R5.999 Q6 F50", withdrawn), "end x0 y0 z0 a0 c0");
}

TEST(G74, WithdrawsAtTheFeedUnderItsReading) {
  EXPECT_EQ(path("G74 Z-10 R1 Q5 F50", hnc({{"hnc.peck.withdraw", "feed"}})),
            along_z({"F-5", "F-4", "F-10", "R0"}, "50"));
}

// A withdrawal of 8 after a peck of 5 ends 3 above A, after the second 2 below.
TEST(G74, MayWithdrawAboveA) {
  EXPECT_EQ(path("G74 Z-15 R8 Q5 F50"), along_z({"F-5", "R3", "F-10", "R-2", "F-15", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-15 R8 Q5 F50", hnc({{"hnc.peck.clamp", "start"}})),
            along_z({"F-5", "R0", "F-10", "R-2", "F-15", "R0"}, "50"));
}

// To Z-17 at a traverse, then 6 further; from A the other way to 7, then 3 further.
TEST(G74, ApproachesAtATraverseUnderItsReading) {
  const Profile on = hnc({{"hnc.g74.mode3", "on"}});
  const Lines want = along_z({"R-17", "F-23", "R2"}, "50");
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 Z-17 Q6 F50", on), want);
  EXPECT_EQ(cycle("G00 X0 Z2", "G74 W-19 R0 Q6 F50", on), want);
  EXPECT_EQ(path("G74 Z7 Q3 F50", on), along_z({"R7", "F10", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-10 Q6 F50\nZ-8", on),
            along_z({"R-10", "F-16", "R0", "R-8", "F-14", "R0"}, "50"));
  EXPECT_EQ(ending_of("G74 Z0 Q6 F50", on), "alarm b1 direction-conflict");
  // Without a depth of a peck, and with a withdrawal, it is as before.
  EXPECT_EQ(path("G74 Z-17 F50", on), along_z({"F-17", "R0"}, "50"));
  EXPECT_EQ(path("G74 Z-10 R1 Q6 F50", on), along_z({"F-6", "R-5", "F-10", "R0"}, "50"));
}

TEST(G74, AsksItsReadingsOnlyWhereTheyMatter) {
  EXPECT_EQ(touched("G74 Z-10 F50"), Lines{});
  EXPECT_EQ(touched("G74 Z-10 Q5 F50"), Lines{"hnc.g74.mode3"});
  EXPECT_EQ(touched("G74 Z-5 R1 Q5 F50"), Lines{});
  EXPECT_EQ(touched("G74 Z-9 R1 Q5 F50"), Lines{"hnc.peck.withdraw"});  // 2 Q - R
  EXPECT_EQ(touched("G74 Z-9.001 R1 Q5 F50"), (Lines{"hnc.peck.from", "hnc.peck.withdraw"}));
  EXPECT_EQ(touched("G74 Z-15 R5 Q5 F50"), (Lines{"hnc.peck.from", "hnc.peck.withdraw"}));
  EXPECT_EQ(touched("G74 Z-15 R5.001 Q5 F50"),
            (Lines{"hnc.peck.from", "hnc.peck.withdraw", "hnc.peck.clamp"}));
}

TEST(G74, PecksAreLengthsInTheUnitsInForce) {
  EXPECT_EQ(path("G20 G74 Z-2 R0.5 Q1 F10"), along_z({"F-25.4", "R-12.7", "F-50.8", "R0"}, "254"));
}

TEST(G74, FollowsAThousandMillionPecks) {
  EXPECT_EQ(ending_of("G00 X0 Z2\nG74 Z-8 R0.1 Q0.000000009 F50\n"), "not-covered b2 G74");
  EXPECT_EQ(ending_of("G00 X20 Z2\nG75 X0 R0.1 Q0.000000009 F50\n"), "not-covered b2 G75");
  // An alarm of the block goes first.
  EXPECT_EQ(ending_of("G00 X0 Z2\nG74 Z-8 R0.1 Q0.000000009\n"), "alarm b2 feed-missing");
}

}  // namespace
}  // namespace gonogo::reference::testing::hnc
