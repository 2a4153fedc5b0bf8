// SPDX-License-Identifier: GPL-3.0-or-later
//
// One path in many shapes: moved, rounded, turned, cut up, or written as spirals.
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

Number micron(double value) {
  return Number::millionths(1000 * static_cast<std::int64_t>(std::round(value * 1000)));
}

// A point by radius and turns, to the micron.
PlanePoint polar(double radius, double turns) {
  const double angle = 2 * std::numbers::pi * turns;
  return {micron(radius * std::cos(angle)), micron(radius * std::sin(angle))};
}

TEST(RegionShapes, MovedByThirdsIsGo) {
  const PlanePoint thirds{mm("100/3"), mm("-200/3")};
  EXPECT_TRUE(is_go(moved(semicircles(i16_l3_d4()), thirds)));
  EXPECT_TRUE(is_go(moved(concentric(i16_l3_d4(), {3, 6, 9, 12}), thirds)));
}

// Every coordinate loses 1/3000: a shift of the whole path by (-1/3000, 1/3000).
TEST(RegionShapes, MovedByThirdsAndRoundedIsGo) {
  const PlanePoint thirds{mm("100/3"), mm("-200/3")};
  EXPECT_TRUE(is_go(rounded(moved(semicircles(i16_l3_d4()), thirds))));
  EXPECT_TRUE(is_go(rounded(moved(concentric(i16_l3_d4(), {3, 6, 9, 12}), thirds))));
}

TEST(RegionShapes, FarFromTheOriginIsGo) {
  const PlanePoint far{900'000, -900'000};
  EXPECT_TRUE(is_go(moved(semicircles(i16_l3_d4()), far)));
  EXPECT_TRUE(breaks(Rule::step, moved(concentric(i16_l3_d4(), {3, 9, 12}), far)));
}

TEST(RegionShapes, CirclesMayStartAnywhere) {
  Job job{i16_l3_d4(), {}};
  circle(job, 3, {mm("0.6"), mm("0.8")});
  circle(job, 6, {mm("-5/13"), mm("12/13")});
  circle(job, 9, {mm("-8/17"), mm("-15/17")});
  circle(job, 12, {0, -1});
  EXPECT_TRUE(is_go(job));
}

Job cut_up(const std::vector<PlanePoint>& directions, const std::vector<Number>& radii) {
  Job job{i16_l3_d4(), {}};
  for (const Number& radius : radii) {
    const auto at = [&radius](const PlanePoint& d) {
      return PlanePoint{radius * d.p, radius * d.q};
    };
    line_to(job, at(directions.front()));
    for (std::size_t k = 1; k <= directions.size(); ++k) {
      arc_to(job, at(directions[k % directions.size()]), {}, -1);
    }
  }
  return job;
}

const std::vector<PlanePoint> kSemicircles{{1, 0}, {-1, 0}};
// Clockwise.
const std::vector<PlanePoint> kFive{
    {1, 0}, {mm("0.6"), mm("-0.8")}, {mm("-0.8"), mm("-0.6")}, {-1, 0}, {0, 1}};

TEST(RegionShapes, CirclesInTwoHalvesAreGo) {
  EXPECT_TRUE(is_go(cut_up(kSemicircles, {3, 6, 9, 12})));
}

TEST(RegionShapes, CirclesInFivePiecesAreGo) {
  EXPECT_TRUE(is_go(cut_up(kFive, {3, 6, 9, 12})));
}

TEST(RegionShapes, CirclesInPiecesThatJustTouchAreGo) {
  Job job = cut_up(kFive, {mm("3.002"), mm("6.004"), mm("9.006"), mm("12.008")});
  job.level.pocket_radius = mm("16.008");
  EXPECT_TRUE(is_go(job));
}

// One of the five pieces of the ring of 6 is missing.
TEST(RegionShapes, APieceLeftOutBreaksStep) {
  Job job = cut_up(kFive, {3, 6, 9, 12});
  job.motions[8].is_arc = false;
  EXPECT_TRUE(breaks(Rule::step, job));
}

// The rounded ends give each piece two radii.
TEST(RegionShapes, PiecesWithRoundedEndsAreGo) {
  Job job{i16_l3_d4(), {}};
  for (const double radius : {3.0, 5.9995, 9.0, 12.0}) {
    line_to(job, polar(radius, 0.07));
    for (int k = 1; k <= 7; ++k) arc_to(job, polar(radius, 0.07 - k / 7.0), {}, -1);
  }
  EXPECT_TRUE(is_go(job));
}

TEST(RegionShapes, PiecesWithRoundedEndsAndAWideGapBreakStep) {
  Job job{i16_l3_d4(), {}};
  for (const double radius : {3.0, 5.98, 9.0, 12.0}) {  // 3.02 apart
    line_to(job, polar(radius, 0.07));
    for (int k = 1; k <= 7; ++k) arc_to(job, polar(radius, 0.07 - k / 7.0), {}, -1);
  }
  EXPECT_TRUE(breaks(Rule::step, job));
}

Job archimedean(double pitch, int pieces) {
  Job job{i16_l3_d4(1), {}};
  line_to(job, polar(0.01, 0));
  const double turns = (12 - 0.01) / pitch;
  const int count = static_cast<int>(std::ceil(turns * pieces));
  for (int k = 1; k <= count; ++k) {
    const double at = std::min(turns, static_cast<double>(k) / pieces);
    arc_to(job, polar(0.01 + pitch * at, at), {}, 1);
  }
  arc_to(job, job.motions.back().to, {}, 1);
  return job;
}

// The radius of each piece runs linearly with the angle: the true curve, to the micron.
TEST(RegionShapes, ArchimedeanSpiralIsGo) {
  EXPECT_TRUE(is_go(archimedean(2.95, 24)));
}

TEST(RegionShapes, ArchimedeanSpiralWithAWidePitchBreaksStep) {
  EXPECT_TRUE(breaks(Rule::step, archimedean(3.1, 24)));
}

// From (0.25, 0) to (12, 0) in four turns, 2.94 a turn, in one record.
Job one_record_spiral(int turns) {
  Job job{i16_l3_d4(1), {}};
  line_to(job, {mm("0.25"), 0});
  arc_to(job, {12, 0}, {}, turns);
  arc_to(job, {12, 0}, {}, 1);
  return job;
}

TEST(RegionShapes, AWholeSpiralInOneRecordIsGo) {
  EXPECT_TRUE(is_go(one_record_spiral(4)));
}

TEST(RegionShapes, AnyNumberOfWholeTurnsIsReadable) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  job.motions[1].rot = std::numeric_limits<int>::min();
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::go);
}

// 3.92 a turn.
TEST(RegionShapes, ASpiralWithTooFewTurnsBreaksStep) {
  EXPECT_TRUE(breaks(Rule::step, one_record_spiral(3)));
}

// Beside the centre, the spiral leaves E between its ends.
TEST(RegionShapes, ASpiralThatLeavesBetweenItsEndsGouges) {
  Job job = concentric(i16_l3_d4(1), {3, 6, 9, 12});
  line_to(job, {3, -10});
  arc_to(job, {3, mm("10.001")}, {3, 0}, 1);
  EXPECT_TRUE(breaks(Rule::gouge, job));
}

Job with_closing_end(const PlanePoint& end) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  job.motions.back().to = end;
  return job;
}

// Clockwise from (12, 0): q just below 0 is just past the start, q just above is nearly a turn.
TEST(RegionShapes, AnEndJustPastTheStartIsAWholeTurn) {
  EXPECT_TRUE(is_go(with_closing_end({12, mm("-0.001")})));
}

TEST(RegionShapes, AnEndJustBeforeTheStartIsAWholeTurn) {
  EXPECT_TRUE(is_go(with_closing_end({12, mm("0.001")})));
}

TEST(RegionShapes, AnEndTwoMicronsPastTheStartIsNoWholeTurn) {
  EXPECT_TRUE(breaks(Rule::cover, with_closing_end({12, mm("-0.002")})));
}

// A leftover of a micron at the rim whose whole turn would gouge is no motion at all.
TEST(RegionShapes, AMicronLongArcAtTheBorderIsNoWholeTurnThatGouges) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  arc_to(job, {12, mm("-0.001")}, {14, 0}, -1);
  EXPECT_TRUE(is_go(job));
}

TEST(RegionShapes, AnArcAboutItsOwnEndIsAGap) {
  Job job = concentric(i16_l3_d4(), {3, 6, 9, 12});
  arc_to(job, {11, 0}, {12, 0}, -1);
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::gap);
}

}  // namespace
}  // namespace gonogo::oracle::region
