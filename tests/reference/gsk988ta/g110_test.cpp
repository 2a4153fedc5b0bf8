// SPDX-License-Identifier: GPL-3.0-or-later
//
// G110 and G111: the path, clause by clause. X words are diameters, records true lengths: the
// centre X50 Z50 is (x25, z50).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "expanding.hpp"

namespace gonogo::reference::testing {
namespace {

Lines operator+(Lines a, const Lines& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// The example of the manual: initial plane Y50, R plane Y45, bottom Y20 in five layers of 5;
// I - D = 12 and L/2 = 1.5.
const std::string kExample =
    "N100 G18 G0 X70 Z70 Y50\nN110 G110 X50 Z50 Y20 R-5 I16 L3 Q5 P1 D4 F800\n";
const Lines kArrival = {"rapid x35 y50 z70", "rapid x25 z50", "rapid y45"};
const Lines kBack = {"rapid y45", "rapid x25 z50"};

// A layer: semicircles over ends at alternating sides of the centre, each about the middle of its
// chord, and the full circle of radius 12.
Lines example_layer(const char* rot) {
  const std::pair<const char*, const char*> ends_and_centres[] = {
      {"51.5", "50.75"}, {"47", "49.25"},   {"54.5", "50.75"}, {"44", "49.25"}, {"57.5", "50.75"},
      {"41", "49.25"},   {"60.5", "50.75"}, {"38", "49.25"},   {"38", "50"}};
  Lines layer;
  for (const auto& [end, centre] : ends_and_centres) {
    layer.push_back(fmt::format("arc x25 z{} c{},25 rot{} f800", end, centre, rot));
  }
  return layer;
}

Lines example(const char* rot) {
  Lines want = kArrival + Lines{"feed y40 f800"} + example_layer(rot) + kBack;
  // 1 above the last depth, then Q + P down to the next.
  for (const auto& [above, depth] : {std::pair{41, 35}, {36, 30}, {31, 25}, {26, 20}}) {
    want = want + Lines{fmt::format("rapid y{}", above), fmt::format("feed y{} f800", depth)} +
           example_layer(rot) + kBack;
  }
  return want + Lines{"rapid y50"};
}

TEST(G110, TheWorkedExampleOfTheManual) {
  EXPECT_EQ(lines(kExample), example("-1"));
}

TEST(G110, G111TurnsTheOtherWay) {
  std::string program = kExample;
  program.replace(program.find("G110"), 4, "G111");
  EXPECT_EQ(lines(program), example("1"));
}

TEST(G110, EachRecordNamesItsClause) {
  // Two layers, one arc each (I - D = L/2 = 1 needs one semicircle and the circle).
  const Lines want = {"GSK-G110-06", "GSK-G110-07", "GSK-G110-08", "GSK-G110-09", "GSK-G110-09",
                      "GSK-G110-10", "GSK-G110-10", "GSK-G110-11", "GSK-G110-11", "GSK-G110-09",
                      "GSK-G110-09", "GSK-G110-10", "GSK-G110-10", "GSK-G110-13"};
  EXPECT_EQ(clauses_of("G110 X0 Z0 Y-2 I3 L2 Q1 D2 F100"), want);
}

// The levels of the example, as the judge sees them: nothing is said of the path in between.
TEST(G110, Clause09ThePathOfALevelIsOpen) {
  const Lines want =
      kArrival + Lines{"feed y40 f800", "level d40 c50,25 R16 r4 L3 -1 f800"} + kBack +
      Lines{"rapid y41", "feed y35 f800", "level d35 c50,25 R16 r4 L3 -1 f800"} + kBack +
      Lines{"rapid y36", "feed y30 f800", "level d30 c50,25 R16 r4 L3 -1 f800"} + kBack +
      Lines{"rapid y31", "feed y25 f800", "level d25 c50,25 R16 r4 L3 -1 f800"} + kBack +
      Lines{"rapid y26", "feed y20 f800", "level d20 c50,25 R16 r4 L3 -1 f800"} + kBack +
      Lines{"rapid y50"};
  EXPECT_EQ(judged(kExample), want);
}

TEST(G110, ReadingPathSemicirclesIsThePathShown) {
  const Profile given = profile_with({{"gsk.pocket.path", "semicircles"}});
  EXPECT_EQ(lines(kExample, given), lines(kExample));
  EXPECT_EQ(judged(kExample, given), lines(kExample));
}

TEST(G110, ReadingPathConcentricHasCirclesOfRadiusL2LAndSoOn) {
  // 3, 6, 9, 12, each reached by a straight feed along p.
  const Profile given = profile_with({{"gsk.pocket.path", "concentric"}});
  const Lines path = lines(kExample, given);
  ASSERT_GE(path.size(), 12U);
  const Lines want = {"feed x25 z53 f800", "arc x25 z53 c50,25 rot-1 f800",
                      "feed x25 z56 f800", "arc x25 z56 c50,25 rot-1 f800",
                      "feed x25 z59 f800", "arc x25 z59 c50,25 rot-1 f800",
                      "feed x25 z62 f800", "arc x25 z62 c50,25 rot-1 f800"};
  EXPECT_EQ(Lines(path.begin() + 4, path.begin() + 12), want);
  EXPECT_EQ(judged(kExample, given), path);
}

TEST(G110, Clause09TheLastStepIsShorter) {
  // I - D = 8, L/2 = 1.5: ends at 1.5, -3, 4.5, -6, 7.5, -8, the last centre at -0.25.
  const Lines path = lines("G17 G110 X0 Y0 Z-1 I10 L3 Q1 D2 F100");
  const Lines want = {"arc x1.5 y0 c0.75,0 rot-1 f100", "arc x-3 y0 c-0.75,0 rot-1 f100",
                      "arc x4.5 y0 c0.75,0 rot-1 f100", "arc x-6 y0 c-0.75,0 rot-1 f100",
                      "arc x7.5 y0 c0.75,0 rot-1 f100", "arc x-8 y0 c-0.25,0 rot-1 f100",
                      "arc x-8 y0 c0,0 rot-1 f100"};
  ASSERT_GE(path.size(), 10U);
  EXPECT_EQ(Lines(path.begin() + 3, path.begin() + 10), want);
}

TEST(G110, Clause09TheLastCircleOfTheConcentricPathIsTheBorder) {
  // I - D = 8: circles of 3, 6 and 8.
  const Lines path = lines("G17 G110 X0 Y0 Z-1 I10 L3 Q1 D2 F100",
                           profile_with({{"gsk.pocket.path", "concentric"}}));
  const Lines want = {"feed x3 y0 f100", "arc x3 y0 c0,0 rot-1 f100",
                      "feed x6 y0 f100", "arc x6 y0 c0,0 rot-1 f100",
                      "feed x8 y0 f100", "arc x8 y0 c0,0 rot-1 f100"};
  ASSERT_GE(path.size(), 9U);
  EXPECT_EQ(Lines(path.begin() + 3, path.begin() + 9), want);
}

// The motions along d of a program in G18: without X and Z.
Lines depths(std::string_view program, const Profile& profile = {}) {
  Lines along_d;
  for (const std::string& line : judged(program, profile)) {
    if (line.starts_with("rapid y") || line.starts_with("feed y")) along_d.push_back(line);
  }
  return along_d;
}
const std::string kPocketWords = " X0 Z0 I16 L3 D4 F800 ";

TEST(G110, Clause08TheLastLayerTakesWhatRemains) {
  // 23 below Y45 by 5: Y40, 35, 30, 25, and 22.
  const Lines want = {
      "rapid y50", "rapid y45", "feed y40 f800", "rapid y45", "rapid y41", "feed y35 f800",
      "rapid y45", "rapid y36", "feed y30 f800", "rapid y45", "rapid y31", "feed y25 f800",
      "rapid y45", "rapid y26", "feed y22 f800", "rapid y45", "rapid y50"};
  EXPECT_EQ(depths("G0 Y50\nG110 Y22 R-5 Q5 P1" + kPocketWords), want);
}

TEST(G110, Clause08ALayerThatReachesTheBottomIsTheOnlyOne) {
  const Lines want = {"rapid y0", "feed y-5 f800", "rapid y0", "rapid y0"};
  for (const char* q : {"5", "5.001", "999999.999"}) {
    EXPECT_EQ(depths("G110 Y-5 Q" + std::string(q) + kPocketWords), want) << q;
  }
  // One increment less: a second layer of that increment.
  const Lines two = {"rapid y0",      "feed y-4.999 f800", "rapid y0", "rapid y-4.999",
                     "feed y-5 f800", "rapid y0",          "rapid y0"};
  EXPECT_EQ(depths("G110 Y-5 Q4.999" + kPocketWords), two);
}

TEST(G110, Clause01TheAbsoluteDepthIsTheBottom) {
  EXPECT_EQ(depths("G0 Y50\nG110 Y20 R-5 Q100" + kPocketWords),
            (Lines{"rapid y50", "rapid y45", "feed y20 f800", "rapid y45", "rapid y50"}));
}

TEST(G110, Clause01TheIncrementalDepthCountsFromTheRPlane) {
  EXPECT_EQ(depths("G0 Y50\nG110 V-20 R-5 Q100" + kPocketWords),
            (Lines{"rapid y50", "rapid y45", "feed y25 f800", "rapid y45", "rapid y50"}));
}

TEST(G110, Clause01WithoutRTheIncrementalDepthCountsFromTheInitialPlane) {
  EXPECT_EQ(depths("G0 Y50\nG110 V-20 Q100" + kPocketWords),
            (Lines{"rapid y50", "rapid y50", "feed y30 f800", "rapid y50", "rapid y50"}));
}

TEST(G110, Clause01TheCentreMayBeGivenByIncrements) {
  // From (x35, z70): U-20 is 10 of radius.
  EXPECT_EQ(judged("G0 X70 Z70\nG110 U-20 W-20 Y-1 I16 L3 Q5 D4 F800")[1], "rapid x25 z50");
}

TEST(G110, Clause06OtherAxesArePositionedWithTheCentre) {
  EXPECT_EQ(judged("G110 X50 Z50 C90 Y-1 I16 L3 Q5 D4 F800")[0], "rapid x25 z50 c90");
  EXPECT_EQ(judged("G0 C10\nG110 X50 Z50 H-30 Y-1 I16 L3 Q5 D4 F800")[1], "rapid x25 z50 c-20");
}

TEST(G110, Clause10TheWayBackNamesThePlaneAxesAlone) {
  EXPECT_EQ(judged("G110 X50 Z50 C90 Y-1 I16 L3 Q5 D4 F800")[5], "rapid x25 z50");
}

TEST(G110, Clause11POnlySaysHowFar) {
  EXPECT_EQ(depths("G110 Y-10 Q5 P-1" + kPocketWords), depths("G110 Y-10 Q5 P1" + kPocketWords));
}

TEST(G110, Clause11TheApproachNeverPassesTheRPlane) {
  // The first depth is 5 below the R plane.
  const auto approach = [](const char* p) {
    return depths("G0 Y50\nG110 Y30 R-5 Q5" + kPocketWords + "P" + p)[4];
  };
  EXPECT_EQ(approach("4.999"), "rapid y44.999");
  EXPECT_EQ(approach("5"), "rapid y45");
  EXPECT_EQ(approach("5.001"), "rapid y45");
  EXPECT_EQ(approach("500"), "rapid y45");
}

TEST(G110, Clause11WithoutPTheApproachGoesToTheLastDepth) {
  EXPECT_EQ(depths("G110 Y-10 Q5" + kPocketWords)[3], "rapid y-5");
}

TEST(G110, ReadingPOmittedIsTheClearanceWherePIsLeftOut) {
  const Profile one = profile_with({{"gsk.pocket.p-omitted", "1"}});
  EXPECT_EQ(depths("G110 Y-10 Q5" + kPocketWords, one)[3], "rapid y-4");
  EXPECT_EQ(depths("G110 Y-10 Q5 P2" + kPocketWords, one)[3], "rapid y-3");
  EXPECT_EQ(depths("G110 Y-10 Q5 P0" + kPocketWords, one)[3], "rapid y-5");
}

TEST(G110, APocketMayLeadTheOtherWay) {
  // R up to Y5, bottom at Y15; the clearance is on the side of the R plane.
  EXPECT_EQ(depths("G110 Y15 R5 Q5 P1" + kPocketWords),
            (Lines{"rapid y5", "feed y10 f800", "rapid y5", "rapid y9", "feed y15 f800", "rapid y5",
                   "rapid y0"}));
}

TEST(G110, Clause13TheToolEndsAtTheInitialPlane) {
  EXPECT_EQ(ending(kExample), "end x25 y50 z50 a0 c0");
  EXPECT_EQ(ending(kExample, profile_with({{"gsk.pocket.end", "initial"}})),
            "end x25 y50 z50 a0 c0");
}

TEST(G110, ReadingEndRPlaneLeavesOutTheLastRetract) {
  const Profile r_plane = profile_with({{"gsk.pocket.end", "r-plane"}});
  Lines want = example("-1");
  want.pop_back();
  EXPECT_EQ(lines(kExample, r_plane), want);
  EXPECT_EQ(ending(kExample, r_plane), "end x25 y45 z50 a0 c0");
}

TEST(G110, InG17) {
  EXPECT_EQ(
      judged("G17 G0 X70 Y70 Z50\nG110 X50 Y50 Z20 R-5 I16 L3 Q100 D4 F800"),
      (Lines{"rapid x35 y70 z50", "rapid x25 y50", "rapid z45", "feed z20 f800",
             "level d20 c25,50 R16 r4 L3 -1 f800", "rapid z45", "rapid x25 y50", "rapid z50"}));
}

TEST(G110, InG17TheFirstSemicircleLiesOnX) {
  // L/2 is a true length: the end word would be X53.
  EXPECT_EQ(lines("G17 G110 X50 Y50 Z-1 I16 L3 Q5 D4 F800")[3],
            "arc x26.5 y50 c25.75,50 rot-1 f800");
}

TEST(G110, Clause18InG19TheDepthWordIsADiameter) {
  // X40 is 20; R-5 is a true length.
  EXPECT_EQ(
      judged("G19 G0 X100 Y70 Z70\nG110 Y50 Z50 X40 R-5 I16 L3 Q100 D4 F800"),
      (Lines{"rapid x50 y70 z70", "rapid y50 z50", "rapid x45", "feed x20 f800",
             "level d20 c50,50 R16 r4 L3 -1 f800", "rapid x45", "rapid y50 z50", "rapid x50"}));
}

const std::string kG19 = "G19 G0 X100\nG110 Y0 Z0 I16 L3 Q100 D4 F800 R-5 ";

TEST(G110, Clause18UMinus20IsTenDeep) {
  EXPECT_EQ(judged(kG19 + "U-20")[3], "feed x35 f800");
}

TEST(G110, ReadingXDepthDiameterIsTheDefault) {
  const Profile diameter = profile_with({{"gsk.x-depth", "diameter"}});
  EXPECT_EQ(judged(kG19 + "U-20", diameter), judged(kG19 + "U-20"));
}

TEST(G110, ReadingXDepthRadiusTakesTheDepthWordAsItStands) {
  const Profile radius = profile_with({{"gsk.x-depth", "radius"}});
  EXPECT_EQ(judged(kG19 + "U-20", radius)[3], "feed x25 f800");
  EXPECT_EQ(judged(kG19 + "X40", radius)[3], "feed x40 f800");
  // X that is not the depth stays a diameter.
  EXPECT_EQ(judged("G110 X50 Z50 Y-1 I16 L3 Q5 D4 F800", radius)[0], "rapid x25 z50");
}

TEST(G110, InRadiusProgrammingTheDepthWordIsALength) {
  Profile profile;
  profile.x_diameter = false;
  EXPECT_EQ(judged(kG19 + "U-20", profile)[3], "feed x75 f800");
}

TEST(G110, Clause17APocketWithoutDepthIsOnlyPositioned) {
  const Lines want = {"rapid y50", "rapid x25 z50", "rapid y45", "rapid y50"};
  EXPECT_EQ(judged("G0 Y50\nG110 X50 Z50 Y45 R-5 I16 L3 Q5 D4 F800"), want);
  EXPECT_EQ(judged("G0 Y50\nG110 X50 Z50 V0 R-5 I16 L3 Q5 D4"), want);  // and needs no feed
  EXPECT_EQ(judged("G0 Y50\nG110 X50 Z50 Y45 R-5 I16 L3 Q5 D4",
                   profile_with({{"gsk.zero-depth", "no-cut"}})),
            want);
}

TEST(G110, Clause17ItEndsAtTheInitialPlane) {
  EXPECT_EQ(ending("G0 Y50\nG110 X50 Z50 Y45 R-5 I16 L3 Q5 D4"), "end x25 y50 z50 a0 c0");
}

TEST(G110, ReadingZeroDepthAlarmRefusesIt) {
  const Profile alarm = profile_with({{"gsk.zero-depth", "alarm"}});
  const std::string start = "G0 Y50\nG110 X50 Z50 R-5 I16 L3 Q5 D4 F800 ";
  EXPECT_TRUE(ending(start + "Y45", alarm).starts_with("alarm b2"));
  EXPECT_TRUE(ending(start + "V0", alarm).starts_with("alarm b2"));
  EXPECT_EQ(ending(start + "Y44.999", alarm), "end x25 y50 z50 a0 c0");
}

TEST(G110, InInchesAllLengthsAreInInches) {
  // I1 = 25.4, L0.1 = 2.54, Q0.2 = 5.08, D0.25 = 6.35, F10 = 254, Z-0.1 = -2.54.
  EXPECT_EQ(judged("G20 G17 G110 X2 Y1 Z-0.1 I1 L0.1 Q0.2 D0.25 F10"),
            (Lines{"rapid x25.4 y25.4", "rapid z0", "feed z-2.54 f254",
                   "level d-2.54 c25.4,25.4 R25.4 r6.35 L2.54 -1 f254", "rapid z0",
                   "rapid x25.4 y25.4", "rapid z0"}));
}

TEST(G110, InFeedPerRevolution) {
  EXPECT_EQ(judged("G99 G17 G110 X0 Y0 Z-1 I16 L3 Q5 D4 F0.2")[2], "feed z-1 f0.2/rev");
}

TEST(G110, EachRecordBelongsToItsBlock) {
  for (const Item& item : expand("\n\n" + kExample)) {
    const auto& record = std::get<Record>(item);
    if (record.kind == RecordKind::end) continue;
    EXPECT_EQ(record.block, record.to[Axis::x] == num("35") ? 3U : 4U) << line_of(item);
  }
}

TEST(G110, APocketOfAHundredMillionLayersComesOutOneByOne) {
  // 100,000 mm by 0.001: only the first items are asked for.
  const std::string program = "G17 G110 X0 Y0 W-100000 I16 L3 Q0.001 D4 F800";
  const Profile profile;
  grammar::MemorySource bytes(program);
  grammar::LineSource source(bytes);
  Expander expander(profile, source, OpenPaths::judged);
  Lines first;
  for (int i = 0; i < 4; ++i) first.push_back(line_of(*expander.next()));
  EXPECT_EQ(first, (Lines{"rapid x0 y0", "rapid z0", "feed z-0.001 f800",
                          "level d-0.001 c0,0 R16 r4 L3 -1 f800"}));
}

}  // namespace
}  // namespace gonogo::reference::testing
