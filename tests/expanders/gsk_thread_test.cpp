// SPDX-License-Identifier: GPL-3.0-or-later
// G114 to G117, with X as a radius. This machine starts threads at -p.
#include <gtest/gtest.h>

#include <cmath>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

std::string readings(const std::string& settings) {
  return R"({"x_diameter":false,"readings":{)" + settings + "}}";
}

const std::string kArcPathProfile = readings(R"("gsk.thread.path":"arc")");
// R plane Y15, bottom Y-5: four turns; 18 is the surface, 17.5 and 17 the passes.
const std::string kExternal =
    "G0 X70 Z70 Y20\nG18\nG114 X0 Z0 V-20 R-5 I5 J2 K30 E30 P1 Q0.5 D3 F900\n";
// R plane Y25, bottom Y5: four turns; 4.5 is the surface, 5 and 5.5 the passes.
const std::string kInternal =
    "G0 X70 Z70 Y30\nG18\nG116 X70 Z70 V-20 R-5 I5 J2 K30 E15 P1 Q0.5 D3 F900\n";

// One pass of radius 17.5 about the origin, R plane at 0; `words` give depth, lead, run-out.
Outcome one_pass(const std::string& words, const std::string& profile = kRadiusProfile) {
  return run("G114 X0 Z0 E30 P0.5 D3 F9 " + words + "\n", profile);
}

double field(const std::string& record, const std::string& key) {
  return std::stod(record.substr(record.find(key) + key.size()));
}

TEST(GskThread, ManualExampleOfAnExternalThread) {
  const Outcome outcome = run(kExternal, kRadiusProfile);
  ASSERT_EQ(outcome.records.size(), 17u);
  EXPECT_EQ(joined({outcome.records.begin(), outcome.records.begin() + 6}),
            "rapid x=70 y=20 z=70\nrapid x=0 z=0\nrapid y=15\n"
            "arc18 c=-9,0 rot=-1 x=0 z=-18 f=900\n"
            "feed z=-17.5 f=900\n"
            "arc18 c=0,0 rot=-4 x=0 y=-5 z=-17.5 f=900\n");
  // Radius 19.5, 30 degrees clockwise of -p: Z-16.887495, X9.75. The next entry starts from the
  // safe position Z-20, X still 9.75: middle of the way to Z-18, X0.
  EXPECT_EQ(joined({outcome.records.begin() + 7, outcome.records.begin() + 12}),
            "rapid y=15\nrapid z=-20\n"
            "arc18 c=-19,4.875 rot=-1 x=0 z=-18 f=900\n"
            "feed z=-17 f=900\n"
            "arc18 c=0,0 rot=-4 x=0 y=-5 z=-17 f=900\n");
  EXPECT_EQ(joined({outcome.records.begin() + 13, outcome.records.end()}),
            "rapid y=15\nrapid z=-20\nrapid y=20\nend x=9.5 y=20 z=-20 a=0 c=0\n");
  EXPECT_NE(outcome.records[6].find(" rot=-1 x=9.75 z=-16.887495"), std::string::npos);
  EXPECT_NE(outcome.records[12].find(" rot=-1 x=9.5 z=-16.454482"), std::string::npos);
}

TEST(GskThread, ManualExampleOfAnInternalThread) {
  const Outcome outcome = run(kInternal, kRadiusProfile);
  ASSERT_EQ(outcome.records.size(), 16u);
  EXPECT_EQ(joined({outcome.records.begin() + 1, outcome.records.begin() + 5}),
            "rapid y=25\n"
            "arc18 c=67.75,70 rot=-1 x=70 z=65.5 f=900\n"
            "feed z=65 f=900\n"
            "arc18 c=70,70 rot=-4 x=70 y=5 z=65 f=900\n");
  // Radii 3 and 3.5, 30 degrees clockwise of -p of the centre; safe position 70 - (4.5 - 2).
  EXPECT_NE(outcome.records[5].find("x=71.5 z=67.401923"), std::string::npos);
  EXPECT_EQ(outcome.records[7], "rapid z=67.5");
  EXPECT_NE(outcome.records[11].find("x=71.75 z=66.968911"), std::string::npos);
  EXPECT_EQ(outcome.records.back(), "end x=71.75 y=30 z=67.5 a=0 c=0");
}

TEST(GskThread, PathOfTheProfileStartsAtPlusPAndGoesInStraight) {
  const std::string no_run_out = "G0 X70 Z70 Y20\nG114 X0 Z0 V-20 R-5 I5 E30 P1 Q0.5 D3 F900\n";
  EXPECT_EQ(run(no_run_out, kArcPathProfile).motions(),
            "rapid x=70 y=20 z=70\nrapid x=0 z=0\nrapid y=15\n"
            "arc18 c=9,0 rot=-1 x=0 z=18 f=900\n"
            "feed z=17.5 f=900\narc18 c=0,0 rot=-4 x=0 y=-5 z=17.5 f=900\nrapid y=15\nrapid z=18\n"
            "feed z=17 f=900\narc18 c=0,0 rot=-4 x=0 y=-5 z=17 f=900\nrapid y=15\nrapid z=18\n"
            "rapid y=20\n");
}

TEST(GskThread, PathOfTheProfileRunsOutWhereTheReadingSays) {
  // The reading's numbers: Z16.887495 q-9.75, Z16.454483 q-9.5; Z72.598076 and Z73.031089.
  const Outcome outside = run(kExternal, kArcPathProfile);
  EXPECT_NE(outside.records[6].find("x=-9.75 z=16.887495"), std::string::npos);
  EXPECT_NE(outside.records[12].find("x=-9.5 z=16.454482"), std::string::npos);
  const Outcome inside = run(kInternal, kArcPathProfile);
  EXPECT_NE(inside.records[5].find("x=68.5 z=72.598076"), std::string::npos);
  EXPECT_NE(inside.records[11].find("x=68.25 z=73.031088"), std::string::npos);
}

TEST(GskThread, RunOutLeavesTheHelixTangentially) {
  // The circle's centre is on the normal (q = 0), as far from the helix's end as from its own.
  for (const char* k : {"1", "30", "45", "90", "150", "200", "300", "359"}) {
    const Outcome outcome = one_pass("V-5 I5 J2 K" + std::string(k));
    const std::string& record = outcome.records[3];
    ASSERT_TRUE(record.starts_with("arc18 c=")) << record;
    const double centre = field(record, "c=");
    EXPECT_EQ(field(record, ","), 0.0);
    EXPECT_NEAR(std::hypot(field(record, "z=") - centre, field(record, "x=")),
                std::abs(centre + 17.5), 1e-8)
        << k;
    EXPECT_NEAR(std::hypot(field(record, "z="), field(record, "x=")), 19.5, 1e-8) << k;
  }
}

TEST(GskThread, RunOutWithoutAngleIsASemicircle) {
  EXPECT_EQ(one_pass("V-5 I5 J2").records[3], "arc18 c=-18.5,0 rot=1 x=0 z=-19.5 f=9");
  EXPECT_EQ(one_pass("V-5 I5 J2 K360").records[3], "arc18 c=-18.5,0 rot=1 x=0 z=-19.5 f=9");
  // To the opposite side: the circle through -17.5 and 19.5.
  EXPECT_EQ(one_pass("V-5 I5 J2 K180").records[3], "arc18 c=1,0 rot=-1 x=0 z=19.5 f=9");
  // Internal, radius 5: to 3, turning with the helix.
  EXPECT_EQ(run("G117 X0 Z0 V-5 I5 J2 E15 P0.5 D3 F9\n", kRadiusProfile).records[3],
            "arc18 c=-4,0 rot=1 x=0 z=-3 f=9");
}

TEST(GskThread, RunOutIsStraightWhereItsArcIs) {
  // Radius 35 at 60 degrees lies on the tangent at -17.5.
  EXPECT_EQ(one_pass("V-5 I5 J17.5 K60").records[3], "feed x=30.310889132 z=-17.5 f=9");
}

TEST(GskThread, RunOutIntoABoreMayLeadBeyondItsCentre) {
  // Radius 5, J7: to 2 on the other side.
  const std::string program = "G116 X0 Z0 V-5 I5 J7 E15 P0.5 D3 F9\n";
  const std::string want = "arc18 c=-1.5,0 rot=-1 x=0 z=2 f=9";
  EXPECT_EQ(run(program, kRadiusProfile).records[3], want);
  EXPECT_EQ(run(program, readings(R"("gsk.thread.runout":"polar")")).records[3], want);
}

TEST(GskThread, RunOutOfTheOtherReadings) {
  // Root of 3 and 1: 30 degrees from the normal, or from the tangent.
  EXPECT_EQ(one_pass("V-5 I5 J2 K30", readings(R"("gsk.thread.runout":"radial")")).records[3],
            "feed x=1 z=-19.232050808 f=9");
  EXPECT_EQ(one_pass("V-5 I5 J2 K30", readings(R"("gsk.thread.runout":"tangent")")).records[3],
            "feed x=1.732050808 z=-18.5 f=9");
  EXPECT_EQ(
      run("G116 X0 Z0 V-5 I5 J2 K30 E15 P0.5 D3 F9\n", readings(R"("gsk.thread.runout":"tangent")"))
          .records[3],
      "feed x=1.732050808 z=-4 f=9");
}

TEST(GskThread, RunOutDefaultsToTheParameters) {
  const std::string parameters = R"({"x_diameter":false,"parameters":{"5920":"180","5921":"2"}})";
  EXPECT_EQ(one_pass("V-5 I5", parameters).records[3], "arc18 c=1,0 rot=-1 x=0 z=19.5 f=9");
  EXPECT_EQ(one_pass("V-5 I5 K0", parameters).records[3], "arc18 c=-18.5,0 rot=1 x=0 z=-19.5 f=9");
  EXPECT_EQ(one_pass("V-5 I5 J0", parameters).records[3], "rapid y=0");
  EXPECT_EQ(one_pass("V-5 I5").records[3], "rapid y=0");
}

TEST(GskThread, LastTurnMayBePartOfOne) {
  // Clockwise from -p: a quarter turn reaches +q, a half +p.
  EXPECT_EQ(one_pass("V-5 I4").records[2], "arc18 c=0,0 rot=-2 x=17.5 y=-5 z=0 f=9");
  EXPECT_EQ(one_pass("V-5 I10").records[2], "arc18 c=0,0 rot=-1 x=0 y=-5 z=17.5 f=9");
  EXPECT_EQ(one_pass("V-5 I2").records[2], "arc18 c=0,0 rot=-3 x=0 y=-5 z=17.5 f=9");
  EXPECT_EQ(one_pass("V-5 I2.5").records[2], "arc18 c=0,0 rot=-2 x=0 y=-5 z=-17.5 f=9");
  // A sixth: 60 degrees clockwise of -p, 17.5 (-1/2, root of 3 / 2).
  EXPECT_EQ(one_pass("V-5 I30").records[2], "arc18 c=0,0 rot=-1 x=15.155444566 y=-5 z=-8.75 f=9");
}

TEST(GskThread, CounterclockwiseThreadsTurnTheOtherWay) {
  const Outcome outcome = run("G115 X0 Z0 V-5 I4 E30 P0.5 D3 F9\n", kRadiusProfile);
  EXPECT_EQ(outcome.records[0], "arc18 c=-9,0 rot=1 x=0 z=-18 f=9");
  EXPECT_EQ(outcome.records[1], "feed z=-17.5 f=9");
  EXPECT_EQ(outcome.records[2], "arc18 c=0,0 rot=2 x=-17.5 y=-5 z=0 f=9");
}

TEST(GskThread, PassesEndAtTheHeight) {
  const auto radii = [](const std::string& words) {
    std::string text;
    for (const std::string& record : run("G114 X0 Z0 V-5 I5 E30 D3 F9 " + words + "\n").records) {
      if (record.starts_with("arc18 c=0,0 ")) text += record.substr(record.find("z="), 7) + "|";
    }
    return text;
  };
  EXPECT_EQ(radii("P2"), "z=-16 f|");
  EXPECT_EQ(radii("P2 Q0"), "z=-16 f|");
  EXPECT_EQ(radii("P2 Q2"), "z=-16 f|");
  EXPECT_EQ(radii("P2 Q2.001"), "z=-16 f|");
  EXPECT_EQ(radii("P2 Q1.999"), "z=-16.0|z=-16 f|");
  EXPECT_EQ(radii("P2 Q1"), "z=-17 f|z=-16 f|");
  EXPECT_EQ(radii("P2.5 Q1"), "z=-17 f|z=-16 f|z=-15.5|");
}

TEST(GskThread, IncrementalDepthCountsFromThePlaneOfTheReading) {
  const std::string words = "V-20 R-5 I5";
  EXPECT_NE(one_pass(words).records[3].find("y=-25 "), std::string::npos);
  const Outcome other = one_pass(words, readings(R"("gsk.thread.v-from":"initial")"));
  EXPECT_EQ(other.records[3], "arc18 c=0,0 rot=-3 x=0 y=-20 z=-17.5 f=9");
}

TEST(GskThread, ModeLastsAsTheReadingSays) {
  const std::string program = "G114 X0 Z0 V-5 I5 E30 P0.5 D3 F9\nX1 Z1 V-5 I5 E30 P0.5 D3\n";
  // The first thread takes five records, the second one more for its centre.
  EXPECT_EQ(run(program, kRadiusProfile).records.size(), 5u + 6u + 1u);
  const Outcome once = run("G114 X0 Z0 V-5 I5 E30 P0.5 D3 F9\nX1 Z1 V-5\n",
                           readings(R"("gsk.thread.modal":"none")"));
  EXPECT_EQ(once.records[5], "rapid x=1 y=-5 z=1");
}

TEST(GskThread, EndsWithG80AndMotionCodes) {
  const std::string entry = "G114 X0 Z0 V-5 I5 E30 P0.5 D3 F9\n";
  for (const char* leave : {"G80", "G00"}) {
    EXPECT_EQ(run(entry + leave + " X1 Y2 Z3\n", kRadiusProfile).records[5], "rapid x=1 y=2 z=3");
  }
}

TEST(GskThread, ZeroDepthPositionsOnly) {
  EXPECT_EQ(run("G116 X1 Z2 V0 R-3 I5 E15 P1 D3\n", kRadiusProfile).motions(),
            "rapid x=1 z=2\nrapid y=-3\nrapid y=0\n");
}

TEST(GskThread, InchWordsAreConvertedAndAnglesAreNot) {
  // E1.2 = 30.48, D0.1 = 2.54: surface 17.78, pass 17.272; J0.1 = 2.54, K180.
  const Outcome outcome = run("G20 G114 X0 Z0 V-0.2 I0.2 J0.1 K180 E1.2 P0.02 D0.1 F1\n");
  EXPECT_EQ(outcome.records[2], "arc18 c=0,0 rot=-1 x=0 y=-5.08 z=-17.272 f=25.4");
  EXPECT_EQ(outcome.records[3], "arc18 c=1.27,0 rot=-1 x=0 z=19.812 f=25.4");
}

TEST(GskThread, ManyTurnsAreOneHelix) {
  // 12.345 at 0.001: 12345 turns.
  EXPECT_EQ(one_pass("V-12.345 I0.001").records[2],
            "arc18 c=0,0 rot=-12345 x=0 y=-12.345 z=-17.5 f=9");
}

}  // namespace
}  // namespace gonogo::expanders::testing
