// SPDX-License-Identifier: GPL-3.0-or-later
//
// GSK-CYC-02, J-PKT-05: a level is cut from the centre outwards. I16 L3 D4: E has radius 12.
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include <numbers>

#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

// The wrong GO: 12 mm straight through solid, then rings from outside in. Where the line
// ends, the plunge is 12 away, 9 more than the step.
TEST(CutOrder, AFeedStraightToTheWallAndClearingInwardsIsNoGo) {
  const Job job = concentric(i16_l3_d4(), {12, 9, 6, 3});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::order, job, verdict));
  EXPECT_EQ(verdict.finding->record, 0U);
  EXPECT_EQ(verdict.finding->witness.p, Number(12));
  EXPECT_GE(verdict.finding->deviation, mm("8.999"));
  EXPECT_LE(verdict.finding->deviation, mm("9"));
}

// The ring of 9 is cut 6 from what is removed, the one of 6 after it.
TEST(CutOrder, TwoRingsInTheWrongOrderAreNoGo) {
  const Job job = concentric(i16_l3_d4(), {3, 9, 6, 12});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::order, job, verdict));
  EXPECT_EQ(verdict.finding->record, 2U);  // the link to it
}

// A half circle from the centre to the border turns as it should, through solid all the way.
TEST(CutOrder, AnArcThroughSolidIsNoGo) {
  Job job{i16_l3_d4(), {}};
  arc_to(job, {12, 0}, {6, 0}, -1);
  line_to(job, {0, 0});
  for (const int radius : {3, 6, 9, 12}) circle(job, radius, {1, 0});
  const LevelVerdict verdict = judge(job);
  ASSERT_TRUE(breaks(Rule::order, job, verdict));
  EXPECT_EQ(verdict.finding->record, 0U);
}

// A first ring of 0.3, as where the rest of the radius is milled first.
TEST(CutOrder, ASmallFirstRingIsGo) {
  for (const char* first : {"0.001", "0.003", "0.01", "0.03", "0.3", "1.5", "2.9"}) {
    CircularLevel level = i16_l3_d4();
    level.pocket_radius = Number(16) + mm(first);
    Job job{level, {}};
    for (const int radius : {0, 3, 6, 9, 12}) circle(job, mm(first) + Number(radius), {1, 0});
    EXPECT_TRUE(is_go(job)) << first;
    EXPECT_TRUE(is_go(moved(job, {mm("1/7"), 50}))) << first;
  }
}

// Each ring from another side, the link through what is cleared and then 3 through solid.
TEST(CutOrder, LinksThroughWhatIsClearedAreGo) {
  Job job{i16_l3_d4(), {}};
  circle(job, 3, {1, 0});
  circle(job, 6, {-1, 0});
  line_to(job, {0, 0});
  circle(job, 9, {0, -1});
  circle(job, 12, {mm("0.6"), mm("0.8")});
  line_to(job, {-12, 0});
  line_to(job, {0, 0});
  EXPECT_TRUE(is_go(job));
}

// Half rings, stepped by 1.5 at either side.
TEST(CutOrder, HalfRingsWithStepsBetweenAreGo) {
  Job job{i16_l3_d4(), {}};
  int side = 1;
  for (int half = 1; half <= 8; ++half) {
    const Number radius = mm("1.5") * Number(half);
    line_to(job, {Number(side) * radius, 0});
    side = -side;
    arc_to(job, {Number(side) * radius, 0}, {}, -1);
  }
  side = -side;
  arc_to(job, {Number(side) * Number(12), 0}, {}, -1);
  circle(job, 12, {1, 0});
  EXPECT_TRUE(is_go(job));
}

// One turn of a spiral in whole circles: r grows by 3 a turn, by a centre that moves.
TEST(CutOrder, ASpiralOfArcsWithTwoRadiiIsGo) {
  Job job{i16_l3_d4(-1), {}};
  // Quarter arcs about the centre from radius r to r + 0.75.
  const PlanePoint directions[] = {{1, 0}, {0, -1}, {-1, 0}, {0, 1}};
  line_to(job, {mm("0.01"), 0});
  Number r = mm("0.01");
  for (int k = 1; r < Number(12); ++k) {
    r = min(r + mm("0.75"), Number(12));
    const PlanePoint& to = directions[k % 4];
    arc_to(job, {r * to.p, r * to.q}, {}, -1);
  }
  const PlanePoint last = job.motions.back().to;
  arc_to(job, last, {}, -1);
  EXPECT_TRUE(is_go(job));
}

// What is milled again, or visited once more, changes nothing.
TEST(CutOrder, RingsMilledTwiceAreGo) {
  EXPECT_TRUE(is_go(concentric(i16_l3_d4(), {3, 3, 6, 3, 6, 9, 6, 12, 12})));
}

// Each piece of 360 of a ring is a motion of its own: nothing changes.
Job in_pieces(const Job& whole, int pieces) {
  Job job{whole.level, {}};
  for (const LevelMotion& motion : whole.motions) {
    if (!motion.is_arc) {
      line_to(job, motion.to);
      continue;
    }
    // By a rotation that is rational: the tangent of half an angle next to a piece's.
    const Number t = Number(1) / Number(pieces) * Number(motion.rot > 0 ? 3 : -3);
    const Number below = Number(1) + t * t;
    const Number c = (Number(1) - t * t) / below;
    const Number s = Number(2) * t / below;
    PlanePoint at = motion.from - motion.centre;
    const int count = static_cast<int>(std::numbers::pi / 3 * pieces);
    for (int k = 1; k < count; ++k) {
      at = {c * at.p - s * at.q, s * at.p + c * at.q};
      at = {at.p, at.q};
      // Rounded to nine decimals, as a controller would.
      const Number scale(1'000'000'000);
      const PlanePoint to{(at.p * scale).floor() / scale, (at.q * scale).floor() / scale};
      at = to;
      arc_to(job, to + motion.centre, motion.centre, motion.rot > 0 ? 1 : -1);
    }
    arc_to(job, motion.to, motion.centre, motion.rot > 0 ? 1 : -1);
  }
  return job;
}

TEST(CutOrder, RingsInPiecesAreJudgedAsWhole) {
  EXPECT_TRUE(is_go(in_pieces(concentric(i16_l3_d4(), {3, 6, 9, 12}), 90)));
  EXPECT_TRUE(breaks(Rule::order, in_pieces(concentric(i16_l3_d4(), {3, 9, 6, 12}), 90)));
}

// Rings by steps of at most 3 in any order that keeps the order are go; in an order that breaks
// it they are not.
RC_GTEST_PROP(CutOrderProperty, ThePermutationDecides, ()) {
  std::vector<int> radii = {3, 6, 9, 12};
  for (std::size_t k = radii.size() - 1; k > 0; --k) {
    std::swap(radii[k],
              radii[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(k) + 1))]);
  }
  std::vector<Number> list;
  bool sorted = true;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    list.emplace_back(radii[k]);
    sorted = sorted && radii[k] == 3 * static_cast<int>(k + 1);
  }
  const Job job = concentric(i16_l3_d4(), list);
  RC_ASSERT((sorted ? is_go(job) : breaks(Rule::order, job)));
}

// Where the first ring begins and ends is just as far from the second as the step: on one side of
// that place the path has been away since, on the other it begins there.
TEST(CutOrder, ARingThatBeginsAtTheStepFromTheOneBeforeIsGo) {
  CircularLevel level = i16_l3_d4();
  level.pocket_radius = mm("3.004") + level.tool_radius;
  Job job{level, {}};
  circle(job, mm("1.502"), {0, -1});
  circle(job, mm("3.004"), {1, 0});
  EXPECT_TRUE(is_go(job));
}
}  // namespace
}  // namespace gonogo::oracle::region
