// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is just reached is reached; and the same answers from the sets of circles alone.
#include <algorithm>

#include "oracle/region/border_pieces.hpp"
#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

TEST(PocketEquality, AnIslandOfNoWidthIsGo) {
  const Pocket job = sides_apart("20.002");
  EXPECT_TRUE(is_go(job));
  EXPECT_FALSE(judge(job).by_filter);  // the points where three borders meet are beyond intervals
}

TEST(PocketEquality, AnIslandOfANanometreBreaksCover) {
  const Pocket job = sides_apart("20.002000002");
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::cover, job, verdict));
  EXPECT_LE(verdict.finding->deviation, mm("0.001000001"));
}

// All lines within E by the whole tolerance: the sides of the area are just reached.
TEST(PocketEquality, ThePathOneToleranceShortIsGo) {
  Pocket job = pocket("60", "40", "8", "5", "0.001");
  contour_parallel(job, 4);
  job.level.area = pocket("60", "40", "8", "5", "0").level.area;
  EXPECT_TRUE(is_go(job));
}

TEST(PocketEquality, ThePathANanometreShorterBreaksCover) {
  Pocket job = pocket("60", "40", "8", "5", "0.001000001");
  contour_parallel(job, 4);
  job.level.area = pocket("60", "40", "8", "5", "0").level.area;
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// Sharp corners of E: the tool's circle about a point 0.001 inside in both axes misses the corner.
TEST(PocketEquality, ASharpCornerOneToleranceShortOnBothAxesBreaksCover) {
  Pocket job = pocket("60", "40", "5", "5", "0.001");
  contour_parallel(job, 4);
  job.level.area = pocket("60", "40", "5", "5", "0").level.area;
  EXPECT_TRUE(breaks(Rule::cover, job));
}

// Corners of the tool's radius: the bands of the lines are wider than the corners. Only the lower
// side is short.
Pocket with_lower_side_at(std::string_view q) {
  Pocket job = pocket("60", "40", "5", "5", "0");
  contour_parallel(job, 4);
  for (LevelMotion& motion : job.motions) {
    for (PlanePoint* end : {&motion.from, &motion.to}) {
      if (end->q == Number(-15)) end->q = mm(q);
    }
  }
  return job;
}

TEST(PocketEquality, OneSideOneToleranceShortIsGoAndANanometreMoreIsNot) {
  EXPECT_TRUE(is_go(with_lower_side_at("-14.999")));
  EXPECT_TRUE(breaks(Rule::cover, with_lower_side_at("-14.998999999")));
}

// Which borders need no walk: an arc about a corner of the core, as far as it leads away from it.
std::size_t pieces_to_walk(const RoundedRectangle& area, const PlanePoint& centre,
                           const PlanePoint& a, const PlanePoint& b) {
  const Rounding outward;
  LevelMotion motion;
  motion.is_arc = true;
  motion.rot = 1;
  motion.centre = centre;
  motion.from = centre + a;
  motion.to = centre + b;
  Path path{{make_arc(motion, {})}, {}};
  path.arcs[0].capped_a = true;
  const Target target{area, std::nullopt, 5, Number()};
  const auto bands = make_bands(path, target.reach, 1e-3);
  EXPECT_EQ(bands->bands.size(), 2U);  // the sector, and the disc about the end without a line
  EXPECT_EQ(bands->points.at(0).p, motion.to.p);
  std::vector<BorderPiece> pieces;
  append_border(bands->bands.back(), false, target, enclose(area), pieces);
  return pieces.size();
}

TEST(PocketBorders, OnlyAnArcThatLeadsAwayFromItsCornerIsOutside) {
  const RoundedRectangle rectangle{20, 10, 8};
  EXPECT_EQ(pieces_to_walk(rectangle, {20, 10}, {3, 0}, {0, 3}), 0U);
  EXPECT_GT(pieces_to_walk(rectangle, {20, 10}, {3, 0}, {-3, 0}), 0U);
  EXPECT_GT(pieces_to_walk(rectangle, {20, 10}, {0, -3}, {0, 3}), 0U);
  EXPECT_GT(pieces_to_walk(rectangle, {20, -10}, {3, 0}, {0, 3}), 0U);
  EXPECT_GT(pieces_to_walk(rectangle, {20, 10}, {mm("2.999"), 0}, {0, mm("2.999")}), 0U);
  const RoundedRectangle slot{20, 0, 8};
  EXPECT_EQ(pieces_to_walk(slot, {20, 0}, {0, -3}, {0, 3}), 0U);
  EXPECT_GT(pieces_to_walk(slot, {20, 0}, {0, 3}, {0, -3}), 0U);
  EXPECT_EQ(pieces_to_walk(slot, {-20, 0}, {0, 3}, {0, -3}), 0U);
}

// The straight edges of the band of a line at the given height, of those two that need a walk.
std::size_t edges_to_walk(const RoundedRectangle& area, std::string_view q) {
  const Rounding outward;
  const Path path{{}, {}, {make_line({-5, mm(q)}, {5, mm(q)})}};
  const Target target{area, std::nullopt, mm("5.001"), Number()};
  const auto bands = make_bands(path, target.reach, 1e-3);
  std::vector<BorderPiece> pieces;
  append_border(bands->bands.back(), false, target, enclose(area), pieces);
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(),
      [](const BorderPiece& piece) { return std::holds_alternative<LinePiece>(piece.curve); }));
}

// Half the width is 20: corners narrower, wider than the reach.
TEST(PocketBorders, AnEdgeOnTheSideOfTheAreaIsOutsideItAndANanometreInsideIsNot) {
  for (const RoundedRectangle& area : {RoundedRectangle{20, 15, 5}, RoundedRectangle{20, 12, 8}}) {
    EXPECT_EQ(edges_to_walk(area, "-14.999"), 1U);
    EXPECT_EQ(edges_to_walk(area, "-14.998999999"), 2U);
    EXPECT_EQ(edges_to_walk(area, "14.999"), 1U);
    EXPECT_EQ(edges_to_walk(area, "14.998999999"), 2U);
  }
}

TEST(PocketEquality, ThePathOneToleranceOutsideIsGo) {
  Pocket job = pocket("60", "40", "8", "5", "0");
  contour_parallel(job, 4);
  job.level.area = pocket("60", "40", "8", "5", "0.001").level.area;
  EXPECT_TRUE(is_go(job));
}

LevelVerdict judge_exactly(const Pocket& job) {
  return judge_level_by(Method::exact_only, job.level, job.motions);
}

void expect_go(const Pocket& job) {
  const LevelVerdict verdict = judge_exactly(job);
  EXPECT_TRUE(is_go(job, verdict));
  EXPECT_FALSE(verdict.by_filter);
}

void expect_hole(const Pocket& job) {
  EXPECT_TRUE(breaks(Rule::cover, job, judge_exactly(job)));
}

TEST(PocketExact, AllStrategiesAreGo) {
  for (const std::string_view width : {"40", "16"}) {
    Pocket rows = pocket("60", width, "8", "5", "0.75");
    Pocket rings = rows;
    Pocket circles = rows;
    zigzag(rows, 4);
    contour_parallel(rings, 4);
    trochoidal(circles, 2, 4);
    expect_go(rows);
    expect_go(rings);
    expect_go(circles);
  }
}

TEST(PocketExact, AnIslandOfNoWidthIsGoAndOfANanometreIsNot) {
  expect_go(sides_apart("20.002"));
  expect_hole(sides_apart("20.002000002"));
}

TEST(PocketExact, TheStripIsGoAndTheFloorIsNot) {
  Pocket job = pocket("60", "40", "8", "5", "0");
  job.level.cleared = pocket("60", "40", "8", "5", "0.75").level.area;
  finish(job);
  expect_go(job);
  job.level.cleared.reset();
  expect_hole(job);
}

// Rows along (7, 3), of irrational length: shapes within their bands.
TEST(PocketExact, AslantLinesAreDecidedFromWithin) {
  Pocket job = pocket("40", "30", "8", "5", "0");
  for (const int row : {-6, 0, 6}) {
    line_to(job, {-7, row - 3});
    line_to(job, {7, row + 3});
  }
  contour_parallel(job, 4);
  expect_go(job);
}

}  // namespace
}  // namespace gonogo::oracle::region
