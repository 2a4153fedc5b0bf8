// SPDX-License-Identifier: GPL-3.0-or-later
// G82 and G32. Words X are diameters.
#include <gtest/gtest.h>

#include "harness.hpp"

namespace gonogo::expanders::testing {
namespace {

TEST(HncG82, StraightThreadOfTheMakersExample) {
  // A (35, 104).
  EXPECT_EQ(after_first(run_hnc("G55 G90 G00 X35 Z104\nG82 X29.2 Z56 F1.5\nG82 X28.6 Z56\n")),
            "rapid x=14.6\nthread x=14.6 z=56 lead=1.5 start=0\nrapid x=17.5\nrapid z=104\n"
            "rapid x=14.3\nthread x=14.3 z=56 lead=1.5 start=0\nrapid x=17.5\nrapid z=104\n");
}

TEST(HncG82, RepeatsWithoutTheCode) {
  // A (60, -24), C 49.1, 48.5.
  EXPECT_EQ(after_first(run_hnc("G00 X60 Z-24\nG82 X49.1 Z-46 F2\nX48.5 Z-46\n")),
            "rapid x=24.55\nthread x=24.55 z=-46 lead=2 start=0\nrapid x=30\nrapid z=-24\n"
            "rapid x=24.25\nthread x=24.25 z=-46 lead=2 start=0\nrapid x=30\nrapid z=-24\n");
}

TEST(HncG82, RunsOutBeyondTheEnd) {
  // A (35, 5), C (29.2, -40), C' = (29.2 + 2.6, -42).
  EXPECT_EQ(after_first(run_hnc("G00 X35 Z5\nG82 X29.2 Z-40 R-2 E1.3 F1.5\n")),
            "rapid x=14.6\nthread x=14.6 z=-40 lead=1.5 start=0\n"
            "thread x=15.9 z=-42 lead=1.5 start=0\nrapid x=17.5\nrapid z=5\n");
}

TEST(HncG82, TaperWithRunOut) {
  // A (36, 4), B_x = 30 - 2.5, C' = (32.6, -42).
  EXPECT_EQ(after_first(run_hnc("G00 X36 Z4\nG82 X30 Z-40 I-1.25 R-2 E1.3 F1.5\n")),
            "rapid x=13.75\nthread x=15 z=-40 lead=1.5 start=0\n"
            "thread x=16.3 z=-42 lead=1.5 start=0\nrapid x=18\nrapid z=4\n");
}

TEST(HncG82, IncrementalTaper) {
  // A (80, 62): C = (48.1, 12), B_x = 38.1; then C_x 47.5, B_x 37.5.
  EXPECT_EQ(run_hnc("G92 X80 Z62\nG91 G82 X-31.9 Z-50 I-5 F2\nX-32.5 Z-50\n").motions(),
            "rapid x=19.05\nthread x=24.05 z=12 lead=2 start=0\nrapid x=40\nrapid z=62\n"
            "rapid x=18.75\nthread x=23.75 z=12 lead=2 start=0\nrapid x=40\nrapid z=62\n");
}

// The spindle angles of the threads of a program.
std::string starts(const std::string& words, const char* profile = "{}") {
  std::string angles;
  for (const std::string& record : run_hnc("G82 X-2 Z-4 F3 " + words, profile).records) {
    if (record.starts_with("thread")) angles += record.substr(record.find("start=") + 6) + " ";
  }
  return angles;
}

TEST(HncG82, SeveralStartsAreSeveralPasses) {
  EXPECT_EQ(starts("C2 P180"), "0 180 ");
  // 4 * 100 = 400 = 40.
  EXPECT_EQ(starts("C5 P100"), "0 100 200 300 40 ");
  EXPECT_EQ(starts("C3 P-90.5"), "0 269.5 179 ");
  EXPECT_EQ(starts("C3 P0"), "0 0 0 ");
  EXPECT_EQ(starts("C2 P180", R"({"readings":{"hnc.g82.starts":"one"}})"), "0 ");
}

TEST(HncG82, OneStartBeginsAtItsAngle) {
  EXPECT_EQ(starts("P45"), "45 ");
  EXPECT_EQ(starts("C0 P-90"), "270 ");
  EXPECT_EQ(starts("C1 P720"), "0 ");
  EXPECT_EQ(starts("C1"), "0 ");
}

TEST(HncG82, RunOutKeepsTheStart) {
  EXPECT_EQ(starts("C2 P90 R-1 E1"), "0 0 90 90 ");
}

TEST(HncG82, EveryPassGoesFromStartToStart) {
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F3 C2 P90\n").motions(),
            "rapid x=-1\nthread x=-1 z=-4 lead=3 start=0\nrapid x=0\nrapid z=0\n"
            "rapid x=-1\nthread x=-1 z=-4 lead=3 start=90\nrapid x=0\nrapid z=0\n");
}

TEST(HncG82, InchLead) {
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 J0.1\n").records[1], "thread x=-1 z=-4 lead=2.54 start=0");
  // J replaces F, F replaces J.
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2\nX-2 Z-4 J1\nX-2 Z-4 F3\n").records[5],
            "thread x=-1 z=-4 lead=25.4 start=0");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2\nX-2 Z-4 J1\nX-2 Z-4 F3\n").records[9],
            "thread x=-1 z=-4 lead=3 start=0");
}

TEST(HncG82, LeadInInchPrograms) {
  EXPECT_EQ(run_hnc("G20 G82 X-2 Z-4 F2\n").records[1], "thread x=-25.4 z=-101.6 lead=2 start=0");
  const char* units = R"({"readings":{"hnc.lead.unit":"units"}})";
  EXPECT_EQ(run_hnc("G20 G82 X-2 Z-4 F2\n", units).records[1],
            "thread x=-25.4 z=-101.6 lead=50.8 start=0");
  EXPECT_EQ(run_hnc("G20 G82 X-2 Z-4 J2\n", units).records[1],
            "thread x=-25.4 z=-101.6 lead=50.8 start=0");
}

TEST(HncG82, RatioOfTwentyPasses) {
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R-1 E20\n").alarm, "");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R-1 E20.001\n").alarm, "retract-ratio");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R0 E1\n").alarm, "retract-ratio");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R-1 E0\n").alarm, "");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R0 E0\n").alarm, "");
}

TEST(HncG82, LongAxisIsThatOfTheLongerTravel) {
  // I5 against a travel of 4 along Z: X is long; equal: Z is.
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 I5 F2 R20 E1\n").alarm, "");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 I5 F2 R20.001 E1\n").alarm, "retract-ratio");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 I-4 F2 R20.001 E1\n").alarm, "");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 I-4 F2 R1 E20.001\n").alarm, "retract-ratio");
}

TEST(HncG82, RunOutNeedsBothWords) {
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R-1\n").alarm, "retract-pair");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 E1\n").alarm, "retract-pair");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 F2 R0\n").alarm, "");
  // E of the block before is in force.
  EXPECT_EQ(run_hnc("G82 E1\nX-2 Z-4 F2 R-1\n").alarm, "");
}

TEST(HncG82, ExitInTheThread) {
  EXPECT_EQ(
      run_hnc("G82 X-2 Z-4 R-1 E1 P9 F2\n", R"({"readings":{"hnc.g82.exit":"feed"}})").motions(),
      "rapid x=-1\nthread x=-1 z=-4 lead=2 start=9\nthread x=0 z=-5 lead=2 start=9\nrapid z=0\n");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 P9 F2\n", R"({"readings":{"hnc.g82.exit":"feed"}})").records[2],
            "thread x=0 lead=2 start=9");
}

TEST(HncG82, RunOutAsDiameter) {
  const char* diameter = R"({"readings":{"hnc.g82.e-scale":"diameter"}})";
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 R-1 E1 F2\n", diameter).records[2],
            "thread x=-0.5 z=-5 lead=2 start=0");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 R-1 E40 F2\n", diameter).alarm, "");
  EXPECT_EQ(run_hnc("G82 X-2 Z-4 R-1 E40.002 F2\n", diameter).alarm, "retract-ratio");
  EXPECT_EQ(run_hnc("G37 G82 X-1 Z-4 R-1 E1 F2\n", diameter).records[2],
            "thread x=0 z=-5 lead=2 start=0");
}

TEST(HncG32, CutsFromThePosition) {
  const Outcome outcome = run_hnc(
      "G90 G00 X29.2 Z101.5\nG32 Z19 F1.5\nG00 X40\nG00 U-11.96\nG32 W-82.5 J0.1\nU4 W-2\n");
  EXPECT_EQ(after_first(outcome),
            "thread z=19 lead=1.5 start=0\nrapid x=20\nrapid x=14.02\n"
            "thread z=-63.5 lead=2.54 start=0\nthread x=16.02 z=-65.5 lead=2.54 start=0\n");
}

TEST(HncG32, LeadIsItsOwn) {
  EXPECT_EQ(run_hnc("G01 X2 F9\nG32 Z-4\n").alarm, "lead-missing");
  EXPECT_EQ(run_hnc("G32 X2 F9\nG01 Z-4\n").alarm, "feed-missing");
  EXPECT_EQ(run_hnc("G32 X2 F9\nG82 X1 Z-4\n").alarm, "lead-missing");
  EXPECT_EQ(run_hnc("G32 F9\nM3\nZ-4\n").motions(), "m 3\nthread z=-4 lead=9 start=0\n");
}

TEST(HncG32, WordsWithoutAPathHere) {
  EXPECT_EQ(run_hnc("G32 Z-4 R-1 E1 F2\n").note, "G32 is not implemented.");
  EXPECT_EQ(run_hnc("G32 Z-4 P1 F2\n").answer, GONOGO_UNSUPPORTED);
  EXPECT_EQ(run_hnc("G32 Z-4 R0 E0 P0 C0 Q0 K0 I0 F2\n").answer, GONOGO_OK);
  EXPECT_EQ(run_hnc("G32 Z-4 F2\nG04 P10\n").motions(), "thread z=-4 lead=2 start=0\ndwell 0.01\n");
  EXPECT_EQ(run_hnc("G04 P2.5\n", R"({"readings":{"hnc.dwell.unit":"s"}})").motions(),
            "dwell 2.5\n");
}

}  // namespace
}  // namespace gonogo::expanders::testing
