// SPDX-License-Identifier: GPL-3.0-or-later
//
// What LCYC75 is told to the judge as, and the path that is shown for it. The pocket is 60 by 40
// about (60, 40), corners of 8, tool of radius 5; less the allowance of 0.75 it is 58.5 by 38.5
// with corners of 7.25, and the tool's centre reaches 24.25 by 14.25 about the middle,
// corners 2.25.
#include <gtest/gtest.h>

#include <algorithm>

#include "s802_expanding.hpp"

namespace gonogo::reference::testing::sie {
namespace {

Lines judged(std::string_view changes, std::string_view before = "") {
  Lines all = lines(pocket_program(changes, before), s802(), OpenPaths::judged);
  std::erase_if(all, [](const std::string& line) { return line.starts_with('m') && line < "mi"; });
  return all;
}
PocketMilling pocket(std::string_view changes, const Profile& profile = s802()) {
  return pockets(pocket_program(changes), profile).at(0);
}
std::size_t arcs(std::string_view changes) {
  const Lines all = path(pocket_program(changes), s802());
  return static_cast<std::size_t>(
      std::ranges::count_if(all, [](const std::string& line) { return line.starts_with("arc"); }));
}

TEST(Lcyc75Item, RoughingLeavesTheAllowances) {
  EXPECT_EQ(judged(""), (Lines{"rapid x60 y40 z5", "rapid z2",
                               "milling d2..-7.5 c60,40 58.5x38.5 R7.25 r5 Q4 -1 depth f120 "
                               "plane f300"}));
  const PocketMilling rough = pocket("");
  EXPECT_FALSE(rough.finishing);
  EXPECT_FALSE(rough.contour_only);
  EXPECT_EQ(rough.allowance, Number(0));
  EXPECT_EQ(rough.reference_plane, Number(0));
  EXPECT_EQ(rough.retract, Number(5));
  EXPECT_EQ(clause_name(rough.clause), "SIE-LC75-04");
}

TEST(Lcyc75Item, FinishingTakesTheProgrammedPocket) {
  EXPECT_EQ(judged("R127=2 R126=3").back(),
            "milling d2..-8 c60,40 60x40 R8 r5 Q4 +1 depth f120 plane f300");
  const PocketMilling finish = pocket("R127=2");
  EXPECT_TRUE(finish.finishing);
  EXPECT_TRUE(finish.one_level);
  EXPECT_EQ(finish.allowance, num("0.75"));
  EXPECT_EQ(finish.rough_floor, num("-7.5"));
  EXPECT_FALSE(pocket("R127=2", s802({{"sie.finish.levels", "split"}})).one_level);
}

// SIE-LC75-13: the way from R101 down is of the path, which is shown with the one of roughing.
TEST(Lcyc75Item, OfFinishingTheApproachEndsAtR101) {
  EXPECT_EQ(judged("R127=2"), (Lines{"rapid x60 y40 z5",
                                     "milling d2..-8 c60,40 60x40 R8 r5 Q4 -1 depth f120 plane "
                                     "f300"}));
  const Lines shown = path(pocket_program("R127=2"), s802());
  EXPECT_EQ(Lines(shown.begin(), shown.begin() + 3),
            (Lines{"rapid x60 y40 z5", "rapid z2", "feed z-4 f120"}));
}

TEST(Lcyc75Item, OnlyAnAllowanceInThePlaneAloneLeavesTheFloorOut) {
  EXPECT_TRUE(pocket("R127=2 R124=0.001 R125=0").contour_only);
  EXPECT_FALSE(pocket("R127=2 R124=0.75 R125=0.5").contour_only);
  EXPECT_FALSE(pocket("R127=2 R124=0 R125=0").contour_only);
  EXPECT_FALSE(pocket("R127=2 R124=0 R125=0.5").contour_only);
}

TEST(Lcyc75Item, TheRoughFloorIsNotAboveTheReferencePlane) {
  EXPECT_EQ(pocket("R127=2 R125=100").rough_floor, Number(0));
  EXPECT_EQ(pocket("R127=2 R125=0").rough_floor, Number(-8));
}

TEST(Lcyc75Item, CornersAreNotBelowTheToolAndNotAboveWhatFits) {
  EXPECT_EQ(pocket("R120=3").corner_radius, Number(5));
  EXPECT_EQ(pocket("R120=5.75").corner_radius, Number(5));
  EXPECT_EQ(pocket("R120=30").corner_radius, num("19.25"));
  EXPECT_EQ(pocket("R127=2 R120=0").corner_radius, Number(5));
  EXPECT_EQ(pocket("R127=2 R120=30").corner_radius, Number(20));
}

TEST(Lcyc75Item, FeedsAreThoseOfTheParametersInTheFeedModeInForce) {
  EXPECT_EQ(judged("G95 R122=0.1 R123=0.2").back(),
            "milling d2..-7.5 c60,40 58.5x38.5 R7.25 r5 Q4 -1 depth f0.1/rev plane f0.2/rev");
}

TEST(Lcyc75Item, LiesInThePlaneInForce) {
  EXPECT_EQ(judged("", "G18"), (Lines{"rapid x40 y5 z60", "rapid y2", judged("").back()}));
  EXPECT_EQ(pockets(pocket_program("", "G19"), s802()).at(0).plane, Plane::g19);
}

TEST(Lcyc75Item, LiesInTheFrame) {
  EXPECT_EQ(judged("G158 X1 Y2 Z10"),
            (Lines{"rapid x61 y42 z15", "rapid z12",
                   "milling d12..2.5 c61,42 58.5x38.5 R7.25 r5 Q4 -1 depth f120 plane f300"}));
  // A quarter turn takes (60, 40) to (-40, 60).
  const PocketMilling turned = pocket("G258 RPL=90");
  EXPECT_EQ(turned.centre, (std::array<Number, 2>{-40, 60}));
  EXPECT_EQ(turned.direction, (std::array<Number, 2>{0, 1}));
  EXPECT_EQ(turned.length, num("58.5"));
}

TEST(Lcyc75Item, ParametersStayForTheNextCall) {
  const auto both = pockets(pocket_program() + "R127=2\nLCYC75\n", s802());
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1].length, Number(60));
  EXPECT_TRUE(both[1].finishing);
}

// Radius 35 about (40, 45) at 45, 135, 225 and 315 degrees: 35 sqrt(2)/2 off in both axes.
TEST(Lcyc75Item, TheFourSlotsLieExactly) {
  const auto slots = pockets(slots_program(), s802());
  ASSERT_EQ(slots.size(), 4U);
  const std::array<std::array<int, 2>, 4> signs = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const Number p = signs[i][0];
    const Number q = signs[i][1];
    const Number half_root = num("1/2");
    EXPECT_EQ(slots[i].centre[0], Number::root(40, p * num("35/2"), 2)) << i;
    EXPECT_EQ(slots[i].centre[1], Number::root(45, q * num("35/2"), 2)) << i;
    EXPECT_EQ(slots[i].direction[0], Number::root(0, p * half_root, 2)) << i;
    EXPECT_EQ(slots[i].direction[1], Number::root(0, q * half_root, 2)) << i;
    EXPECT_EQ(slots[i].length, Number(30));
    EXPECT_EQ(slots[i].width, Number(15));
    EXPECT_EQ(slots[i].corner_radius, num("7.5"));
  }
  EXPECT_EQ(slots[0].centre[0].decimal_text(9), "64.748737342");
  EXPECT_EQ(slots[1].centre[0].decimal_text(9), "15.251262658");
}

// Absolute the last G158 is (-40, -45): Y20 Z50 is (-20, 5). Additive it brings the zero back.
TEST(Lcyc75Item, AfterTheSlotsTheReadingsOfG158EndElsewhere) {
  const auto last_move = [](const Profile& profile) {
    const Lines all = path(slots_program(), profile);
    return all.back();
  };
  EXPECT_EQ(last_move(s802()), "rapid x5 y-20 z5");
  EXPECT_EQ(last_move(s802({{"sie.g158", "additive"}})), "rapid x5 y20 z50");
}

// Clockwise: from the right side to (+a, -b). The tool's radius apart: 14.25 by 4.25, 19.25 by
// 9.25, 24.25 by 14.25.
TEST(Lcyc75Path, GoesFromInsideOut) {
  const Lines all = path(pocket_program(), s802());
  const Lines level = {"feed z-3.75 f120",        "feed x74.25 y40 f300",
                       "feed x74.25 y35.75 f300", "feed x45.75 y35.75 f300",
                       "feed x45.75 y44.25 f300", "feed x74.25 y44.25 f300",
                       "feed x74.25 y40 f300",    "feed x79.25 y40 f300",
                       "feed x79.25 y30.75 f300", "feed x40.75 y30.75 f300",
                       "feed x40.75 y49.25 f300", "feed x79.25 y49.25 f300",
                       "feed x79.25 y40 f300",    "feed x84.25 y40 f300",
                       "feed x84.25 y28 f300",    "arc x82 y25.75 c82,28 rot-1 f300",
                       "feed x38 y25.75 f300",    "arc x35.75 y28 c38,28 rot-1 f300",
                       "feed x35.75 y52 f300",    "arc x38 y54.25 c38,52 rot-1 f300",
                       "feed x82 y54.25 f300",    "arc x84.25 y52 c82,52 rot-1 f300",
                       "feed x84.25 y40 f300",    "feed x60 y40 f300"};
  ASSERT_EQ(all.size(), 2 + 2 * level.size() + 1);
  EXPECT_EQ(Lines(all.begin() + 2, all.begin() + 26), level);
  EXPECT_EQ(all[26], "feed z-7.5 f120");
  EXPECT_EQ(all.back(), "rapid z5");
}

TEST(Lcyc75Path, CounterclockwiseTurnsTheOtherWay) {
  const Lines all = path(pocket_program("R126=3"), s802());
  EXPECT_EQ(all[4], "feed x74.25 y44.25 f300");
  EXPECT_EQ(all[17], "arc x82 y54.25 c82,52 rot1 f300");
}

TEST(Lcyc75Path, FinishingMillsTheContourAtEveryLevel) {
  // Two levels of four corners; above the floor nothing but the contour.
  EXPECT_EQ(arcs("R127=2 R125=0"), 8U);
  EXPECT_EQ(arcs("R127=2"), 8U);
  EXPECT_EQ(arcs("R127=2 R124=0"), 4U);
  const Lines contour = path(pocket_program("R127=2 R125=0"), s802());
  EXPECT_EQ(contour[2], "feed z-4 f120");
  EXPECT_EQ(contour[3], "feed x85 y40 f300");
  EXPECT_EQ(contour[14], "feed z-8 f120");
  EXPECT_EQ(contour[15], "feed x85 y40 f300");
  // The innermost pass of the floor, 25 - 15 by 15 - 15.
  const Lines both = path(pocket_program("R127=2"), s802());
  EXPECT_EQ(both[15], "feed x70 y40 f300");
}

TEST(Lcyc75Path, WhereTheToolReachesALineItGoesForthAndBack) {
  const Lines expected = {"rapid x60 y40 z5",     "rapid z2",
                          "feed z-7.5 f120",      "feed x84.25 y40 f300",
                          "feed x35.75 y40 f300", "feed x84.25 y40 f300",
                          "feed x60 y40 f300",    "rapid z5"};
  EXPECT_EQ(path(pocket_program("R119=11.5 R121=8"), s802()), expected);
}

TEST(Lcyc75Path, WhereTheToolReachesAPointItGoesDown) {
  const Lines expected = {"rapid x60 y40 z5", "rapid z2", "feed z-3.75 f120", "feed z-7.5 f120",
                          "rapid z5"};
  EXPECT_EQ(path(pocket_program("R118=11.5 R119=11.5"), s802()), expected);
}

TEST(Lcyc75Path, ItEndsAboveTheCentre) {
  EXPECT_EQ(ending(pocket_program(), s802()), "end x60 y40 z5 a0 c0");
  const auto after = expand(pocket_program() + "G91 G0 X1 Z1", s802(), OpenPaths::judged);
  EXPECT_EQ(line_of(after[after.size() - 2]), "rapid x61 z6");
}

TEST(Lcyc75Path, LeavesFeedMotionAndPlaneAsTheyWere) {
  EXPECT_EQ(path(pocket_program("", "G1 G18") + "X5", s802()).back(), "feed x5 f200");
  EXPECT_EQ(path(pocket_program("", "G0") + "X5", s802()).back(), "rapid x5");
  EXPECT_EQ(outcome_of_program(pocket_program() + "CT X5 Y5", s802()), "arc-tangent X");
}

TEST(Lcyc75Path, InATurnedFrameArcsAndLinesTurn) {
  // A quarter turn about (0, 0): (60 + u, 40 + v) lies at (-40 - v, 60 + u).
  const Lines all = path(pocket_program("G258 RPL=90"), s802());
  EXPECT_EQ(all[0], "rapid x-40 y60 z5");
  EXPECT_EQ(all[16], "feed x-28 y84.25 f300");
  EXPECT_EQ(all[17], "arc x-25.75 y82 c-28,82 rot-1 f300");
}

TEST(Lcyc75Path, AtSeventeenDegreesItComesBackToTheCentre) {
  // 60 cos 17 - 40 sin 17 = 45.683417, 60 sin 17 + 40 cos 17 = 55.794493
  const Record home = [&] {
    Record found;
    for (const Item& item : expand(pocket_program("G258 RPL=17"), s802())) {
      const auto* record = std::get_if<Record>(&item);
      if (record != nullptr && record->kind == RecordKind::feed) found = *record;
    }
    return found;
  }();
  EXPECT_EQ(home.to[Axis::x].decimal_text(6), "45.683417");
  EXPECT_EQ(home.to[Axis::y].decimal_text(6), "55.794493");
}

}  // namespace
}  // namespace gonogo::reference::testing::sie
