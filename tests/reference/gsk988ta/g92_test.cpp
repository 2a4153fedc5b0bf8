// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

// The manual's thread without its run-out: A X65 Z5, C X58.7 Z-28.
TEST(G92, CutsAThread) {
  EXPECT_EQ(lines_after("G0 X65 Z5", "G92 X58.7 Z-28 F3"),
            (Lines{"rapid x29.35", "thread x29.35 z-28 lead3 start0", "rapid x32.5", "rapid z5"}));
}

TEST(G92, NamesTheClauseOfEachMotion) {
  EXPECT_EQ(clauses_of("G92 X58.7 Z-28 F3"),
            (Lines{"GSK-G92-02", "GSK-G92-03", "GSK-G92-04", "GSK-G92-05"}));
}

TEST(G92, RetainsWordsAndLead) {
  EXPECT_EQ(lines_after("G0 X65 Z5", "G92 X58.7 Z-28 F3\nX57.7").at(5),
            "thread x28.85 z-28 lead3 start0");
  EXPECT_EQ(lines_after("G0 X65 Z5", "G92 X58.7 Z-28 F3\nG00 X65\nG92 X57.7 Z-28").at(6),
            "thread x28.85 z-28 lead3 start0");
}

// R is a true length: B lies 5 mm of radius beyond C on X.
TEST(G92, CutsATaper) {
  const Lines got = lines_after("G0 X65 Z5", "G92 X60 Z-28 R-5 F3");
  EXPECT_EQ(got.at(0), "rapid x25");
  EXPECT_EQ(got.at(1), "thread x30 z-28 lead3 start0");
}

TEST(G92, LimitsAnOppositeTaperToTheTravel) {
  EXPECT_EQ(ending("G0 X100\nG92 X60 Z-28 R20 F3"), "end x50 y0 z0 a0 c0");
  EXPECT_EQ(ending("G0 X100\nG92 X60 Z-28 R20.001 F3"), "alarm b2 taper-limit");
}

TEST(G92, NeedsALead) {
  EXPECT_EQ(ending("G92 X60 Z-28"), "alarm b1 lead-missing");
  EXPECT_EQ(ending("G92 X60 Z-28 F0"), "alarm b1 lead-missing");
  EXPECT_EQ(ending("F200\nG92 X60 Z-28"), "alarm b2 lead-missing");
}

TEST(G92, KeepsItsLeadApartFromTheFeed) {
  EXPECT_EQ(lines_after("G00 X60", "F200\nG92 X58 Z-28 F3\nG01 Z0").back(), "feed z0 f200");
  EXPECT_EQ(ending("G92 X58 Z-28 F3\nG01 Z1"), "alarm b2 feed-missing");
}

TEST(G92, TakesItsLeadInABlockThatCutsNothing) {
  EXPECT_EQ(lines_after("G00 X60", "G92 F2\nG04 P1 F3\nX58 Z-28").back(), "rapid z0");
  EXPECT_EQ(lines_after("G00 X60", "G92 F2\nG04 P1 F3\nX58 Z-28").at(2),
            "thread x29 z-28 lead3 start0");
}

TEST(G92, SharesOneFWordUnderItsReading) {
  const Profile profile = profile_with({{"gsk.g92.lead", "feed"}});
  EXPECT_EQ(lines_after("G00 X60", "F2\nG92 X58 Z-28", profile).at(1),
            "thread x29 z-28 lead2 start0");
  EXPECT_EQ(lines_after("G00 X60", "F200\nG92 X58 Z-28 F3\nG01 Z1", profile).back(), "feed z1 f3");
}

TEST(G92, TakesTheLeadInInch) {
  EXPECT_EQ(lines("G20\nG92 X2 Z-1 F0.1").at(1), "thread x25.4 z-25.4 lead2.54 start0");
}

TEST(G92, DoesNotCoverARunOut) {
  EXPECT_EQ(ending("G0 X65 Z5\nG92 X58.7 Z-28 F3 J3 K1"), "not-covered b2 G92");
  EXPECT_EQ(ending("G92 X58.7 Z-28 F3 K1"), "not-covered b1 G92");
  const auto items = expand("G92 X58.7 Z-28 F3 J3 K1");
  EXPECT_NE(std::get<NotCovered>(items.back()).message.find("J above 0"), std::string::npos);
}

TEST(G92, RunsOutByTheParameterUnlessJOrKSayNo) {
  Profile profile;
  profile.parameters["5130"] = 10;
  EXPECT_EQ(ending("G92 X58 Z-28 F3", profile), "not-covered b1 G92");
  EXPECT_EQ(lines("G92 X58 Z-28 F3 J0 K0\nX57", profile).size(), 8U);
}

TEST(G92, DoesNotCoverOtherForms) {
  EXPECT_EQ(ending("G92 X58 Z-28 F3 P1"), "not-covered b1 G92");
  EXPECT_EQ(ending("G92 X58 Z-28 F3 L2"), "not-covered b1 G92");
  EXPECT_EQ(ending("G92 X58 Z-28 F3 Q90"), "not-covered b1 G92");
  EXPECT_EQ(ending("G92 X58 Z-28 I8"), "not-covered b1 G92");  // threads to the inch
  EXPECT_EQ(ending("G92 X58 Z-28 F3 P0 L1 Q0"), "end x0 y0 z0 a0 c0");
}

TEST(G92, RefusesAxesOutsideThePlane) {
  EXPECT_EQ(ending("G92 X58 Y1 F3"), "alarm b1 axis-not-in-plane");
}

TEST(G92, CutsNothingWithoutWords) {
  EXPECT_EQ(lines("G92 F3"), Lines{});
  EXPECT_EQ(lines("G92 F3\nX10 Z-5").at(1), "thread x5 z-5 lead3 start0");
}

}  // namespace
}  // namespace gonogo::reference::testing
