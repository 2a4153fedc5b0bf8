// SPDX-License-Identifier: GPL-3.0-or-later
//
// G112 and G113. G18 throughout unless said: p = Z, q = X (a diameter in words), d = Y.
#include <gtest/gtest.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

constexpr const char* kStart = "G00 X140 Z70 Y30\n";

Lines after_start(const std::string& block, const Profile& profile = {},
                  OpenPaths open_paths = OpenPaths::shown) {
  Lines all = lines(kStart + block, profile, open_paths);
  all.erase(all.begin());
  return all;
}

std::string end_after_start(const std::string& block, const Profile& profile = {}) {
  return ending(kStart + block, profile);
}

// The manual's example: I - D = 4, semicircles of radius 2 round Z72, five turns down 10 mm.
TEST(G112, MillsTheManualsExample) {
  EXPECT_EQ(
      after_start("G18\nG112 X140 Z70 Y20 I8 L5 D4 F200"),
      (Lines{"rapid x70 z70", "rapid y30", "arc x70 z74 c72,70 rot-1 f200",
             "arc x70 y20 z74 c70,70 rot-5 f200", "arc x70 z70 c72,70 rot-1 f200", "rapid y30"}));
}

TEST(G112, NamesTheClauseOfEachMotion) {
  Lines clauses = clauses_of("G112 X140 Z70 Y20 I8 L5 D4 F200");
  EXPECT_EQ(clauses, (Lines{"GSK-G112-03", "GSK-G112-03", "GSK-G112-04", "GSK-G112-05",
                            "GSK-G112-06", "GSK-G112-07"}));
}

TEST(G113, TurnsTheOtherWay) {
  const Lines got = after_start("G113 X140 Z70 Y20 I8 L5 D4 F200");
  EXPECT_EQ(got.at(2), "arc x70 z74 c72,70 rot1 f200");
  EXPECT_EQ(got.at(3), "arc x70 y20 z74 c70,70 rot5 f200");
  EXPECT_EQ(got.at(4), "arc x70 z70 c72,70 rot1 f200");
}

// R leads to Y25, the increment V-10 from there to Y15, and the tool returns to Y30.
TEST(G112, CountsTheDepthIncrementFromTheRPlane) {
  const Lines got = after_start("G112 X140 Z70 V-10 R-5 I8 D4 F200");
  EXPECT_EQ(got.at(1), "rapid y25");
  EXPECT_EQ(got.at(3), "arc x70 y15 z74 c70,70 rot-1 f200");
  EXPECT_EQ(got.back(), "rapid y30");
}

TEST(G112, PassesOnTheClampBeforeTheMotion) {
  const Lines got = after_start("G112 X140 Z70 Y20 I8 D4 F200 M35");
  EXPECT_EQ(got.at(0), "m35");
  EXPECT_EQ(got.at(1), "rapid x70 z70");
}

TEST(G112, PassesOnTheClampOfABlockThatMillsNothing) {
  EXPECT_EQ(after_start("G112 I8 D4 M35"), (Lines{"m35"}));
}

TEST(G112, PositionsCWithTheCentre) {
  EXPECT_EQ(after_start("G112 X140 Z70 Y20 C90 I8 D4 F200").at(0), "rapid x70 z70 c90");
}

TEST(G112, TakesLOfItsBlockAndOneWithoutIt) {
  const Lines got = after_start("G112 X140 Z70 Y20 I8 L5 D4 F200\nX140 Z70 Y20");
  EXPECT_EQ(got.at(9), "arc x70 y20 z74 c70,70 rot-1 f200");
}

TEST(G112, RetainsLUnderItsReading) {
  const Lines got = after_start("G112 X140 Z70 Y20 I8 L5 D4 F200\nX140 Z70 Y20",
                                profile_with({{"gsk.helix.L", "modal"}}));
  EXPECT_EQ(got.at(9), "arc x70 y20 z74 c70,70 rot-5 f200");
}

TEST(G112, AddsAFlatTurnUnderItsReading) {
  const Lines got =
      after_start("G112 X140 Z70 Y20 I8 L2 D4 F200", profile_with({{"gsk.helix.flat", "on"}}));
  EXPECT_EQ(got.at(3), "arc x70 y20 z74 c70,70 rot-2 f200");
  EXPECT_EQ(got.at(4), "arc x70 z74 c70,70 rot-1 f200");
  EXPECT_EQ(got.at(5), "arc x70 z70 c72,70 rot-1 f200");
}

TEST(G112, FeedsBackUnderItsReading) {
  const std::string block = "G112 X140 Z70 Y20 R-2 I8 L2 D4 F200";
  EXPECT_EQ(after_start(block, profile_with({{"gsk.helix.return", "rapid"}})).back(), "rapid y30");
  EXPECT_EQ(after_start(block, profile_with({{"gsk.helix.return", "feed"}})).back(),
            "feed y30 f200");
}

TEST(G112, LeavesTheSideOfItsEntryToTheJudge) {
  EXPECT_EQ(
      after_start("G113 X140 Z70 Y20 R-2 I8 L5 D4 F200", {}, OpenPaths::judged),
      (Lines{"rapid x70 z70", "rapid y28", "helix d28..20 c70,70 r4 turns5 +1 f200", "rapid y30"}));
}

TEST(G112, GivesTheJudgeThePathOfANamedSide) {
  const Profile profile = profile_with({{"gsk.helix.entry-side", "+p"}});
  const std::string block = "G112 X140 Z70 Y20 I8 L5 D4 F200";
  EXPECT_EQ(after_start(block, profile, OpenPaths::judged), after_start(block));
}

TEST(G112, PositionsOverAPocketWithoutDepthAndNeedsNoFeed) {
  EXPECT_EQ(after_start("G112 X140 Z70 Y25 R-5 I8 D4"),
            (Lines{"rapid x70 z70", "rapid y25", "rapid y30"}));
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 I8 D4"), "alarm b2 feed-missing");
}

TEST(G112, MillsNothingWithoutAllThreeAxes) {
  EXPECT_EQ(after_start("G112 X140 Z70 I8 D4 F200\nX140 Y20"), Lines{});
}

TEST(G112, PositionsThePlaneAxesUnderItsReading) {
  EXPECT_EQ(
      after_start("G112 X10 Y20 I8 D4 F200", profile_with({{"gsk.missing-axis", "position"}})),
      (Lines{"rapid x5"}));
}

TEST(G112, NeedsIAndDOnEntryOnly) {
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 F200"), "alarm b2 missing-word missing-word");
  EXPECT_EQ(end_after_start("G112 I8"), "alarm b2 missing-word");
  EXPECT_EQ(end_after_start("G112 I8 D4\nX140 Z70 Y20 F200"), "end x70 y30 z70 a0 c0");
}

TEST(G112, NeedsALargerPocketThanTool) {
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 I4.001 D4 F200"), "end x70 y30 z70 a0 c0");
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 I4 D4 F200"), "alarm b2 tool-too-large");
}

TEST(G112, NeedsWordsAboveZeroWhereItMills) {
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 I8 D0 F200"), "alarm b2 value-out-of-range");
  EXPECT_EQ(end_after_start("G112 I8 D0 F200"), "end x70 y30 z70 a0 c0");
}

TEST(G112, RefusesAnRThatLeadsAway) {
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 R0.001 I8 D4 F200"), "alarm b2 direction-conflict");
  EXPECT_EQ(end_after_start("G112 X140 Z70 Y20 R0 I8 D4 F200"), "end x70 y30 z70 a0 c0");
}

TEST(G112, TakesWholeTurnsFrom1To99999) {
  const std::string site = "G112 X140 Z70 Y20 I8 D4 F200 ";
  EXPECT_EQ(after_start(site + "L99999").at(3), "arc x70 y20 z74 c70,70 rot-99999 f200");
  EXPECT_EQ(after_start(site + "L2.000").at(3), "arc x70 y20 z74 c70,70 rot-2 f200");
  EXPECT_EQ(end_after_start(site + "L100000"), "alarm b2 value-out-of-range");
  EXPECT_EQ(end_after_start(site + "L0"), "alarm b2 value-out-of-range");
  EXPECT_EQ(end_after_start(site + "L1.5"), "alarm b2 not-an-integer");
  EXPECT_EQ(end_after_start(site + "L0.5"), "alarm b2 not-an-integer value-out-of-range");
  EXPECT_EQ(end_after_start("G112 I8 D4 L0"), "alarm b2 value-out-of-range");
}

// Inch: lengths times 25.4, L not.
TEST(G112, CountsTurnsInInchToo) {
  const Lines got = lines("G20\nG112 X0 Z0 Y-1 I2 L3 D1 F10");
  EXPECT_EQ(got.at(3), "arc x0 y-25.4 z25.4 c0,0 rot-3 f254");
}

TEST(G112, KeepsIAndDToG113AndBack) {
  const Lines got = after_start("G112 I8 D4 F200\nG113 X140 Z70 Y20");
  EXPECT_EQ(got.at(3), "arc x70 y20 z74 c70,70 rot1 f200");
  EXPECT_EQ(
      ending("G112 I8 D4 F200\nG113 X140 Z70 Y20", profile_with({{"gsk.pocket.pair", "each"}})),
      "alarm b2 missing-word missing-word");
}

TEST(G112, IsEnteredAnewFromG110) {
  EXPECT_EQ(ending("G110 I8 L3 Q5 D4 F200\nG112 X140 Z70 Y-20"),
            "alarm b2 missing-word missing-word");
}

// The initial plane is Y30, where G110 left the tool, not Y50 where G110 began.
TEST(G112, TakesItsInitialPlaneWhereItIsEntered) {
  const Lines got =
      lines("G00 Y50\nG110 I8 L3 Q5 D4\nG28 V-20\nG112 X0 Z0 Y-40 R-5 I8 D4 F200", [] {
        Profile profile;
        profile.reference_point[Axis::y] = 30;
        return profile;
      }());
  EXPECT_EQ(got.at(4), "rapid y25");
  EXPECT_EQ(got.back(), "rapid y30");
}

// G17: p = X, q = Y, d = Z. G19: p = Y, q = Z, d = X, a diameter as depth too.
TEST(G112, LiesInEachPlane) {
  EXPECT_EQ(lines("G17 G112 X20 Y5 Z-4 I8 D4 F200").at(2), "arc x14 y5 c12,5 rot-1 f200");
  EXPECT_EQ(lines("G19 G112 Y5 Z7 X-20 I8 D4 F200").at(2), "arc y9 z7 c7,7 rot-1 f200");
  EXPECT_EQ(lines("G19 G112 Y5 Z7 X-20 I8 D4 F200").at(3), "arc x-10 y9 z7 c5,7 rot-1 f200");
}

}  // namespace
}  // namespace gonogo::reference::testing
