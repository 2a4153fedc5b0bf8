// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-06, J-PKT-07: pockets of LCYC75 whose arcs are given as chords, and whose passes are given
// in pieces. Length 60, width 40, corners 8, tool 5: E has corners of radius 3.
#include <cmath>
#include <numbers>

#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

Pocket corner_8() {
  return pocket("60", "40", "8", "5", "0");
}

// A number with six decimals.
Number near(double value) {
  return Number::millionths(std::llround(value * 1e6));
}

// Every motion in pieces: arcs as chords whose ends lie on them, lines no longer than `longest`.
Pocket in_pieces(const Pocket& whole, int chords, double longest) {
  Pocket job = whole;
  job.motions.clear();
  for (const LevelMotion& motion : whole.motions) {
    const double fx = approximate(motion.from.p);
    const double fy = approximate(motion.from.q);
    const double tx = approximate(motion.to.p);
    const double ty = approximate(motion.to.q);
    if (!motion.is_arc) {
      const int count = 1 + static_cast<int>(std::hypot(tx - fx, ty - fy) / longest);
      for (int k = 1; k < count; ++k) {
        line_to(job, {near(fx + (tx - fx) * k / count), near(fy + (ty - fy) * k / count)});
      }
      line_to(job, motion.to);
      continue;
    }
    const double cx = approximate(motion.centre.p);
    const double cy = approximate(motion.centre.q);
    const double start = std::atan2(fy - cy, fx - cx);
    double turn = std::atan2(ty - cy, tx - cx) - start;
    if (motion.rot > 0 && turn <= 0) turn += 2 * std::numbers::pi;
    if (motion.rot < 0 && turn >= 0) turn -= 2 * std::numbers::pi;
    const double r = std::hypot(fx - cx, fy - cy);
    for (int k = 1; k < chords; ++k) {
      const double angle = start + turn * k / chords;
      line_to(job, {near(cx + r * std::cos(angle)), near(cy + r * std::sin(angle))});
    }
    line_to(job, motion.to);
  }
  return job;
}

// A quarter of radius 3 in eight chords: 3 (1 - cos 5.625 degrees) = 0.0144 inside.
TEST(PocketChords, CornersOfChordsAreGoWhereTheyAreGranted) {
  Pocket whole = corner_8();
  contour_parallel(whole, 4);
  Pocket job = in_pieces(whole, 8, 100);
  EXPECT_TRUE(breaks(Rule::cover, job));
  job.level.chord = Number::parse("0.015").value();
  EXPECT_EQ(judge(job).kind, LevelVerdict::Kind::go);
}

TEST(PocketChords, TheOtherWayRoundIsNoGoInChordsAndPieces) {
  for (const double longest : {100.0, 0.5, 0.0039}) {
    Pocket whole = corner_8();
    contour_parallel(whole, 4);
    go_round(whole, border_of(whole), -1);
    Pocket job = in_pieces(whole, 8, longest < 0.01 ? 2000 : 8);
    if (longest < 0.01) {
      // Only the last pass in tiny pieces.
      Pocket right = corner_8();
      contour_parallel(right, 4);
      job = right;
      Pocket last = corner_8();
      last.motions.clear();
      go_round(last, border_of(last), -1);
      for (const LevelMotion& motion : in_pieces(last, 500, longest).motions) {
        line_to(job, motion.to);
      }
    }
    job.level.chord = Number::parse("0.015").value();
    const LevelVerdict verdict = judge(job);
    ASSERT_EQ(verdict.kind, LevelVerdict::Kind::no_go) << longest << verdict.gap;
    EXPECT_EQ(verdict.finding->rule, Rule::sense) << longest;
  }
}

TEST(PocketChords, ChordsThatReachTwiceTheChordOutGouge) {
  Pocket whole = corner_8();
  contour_parallel(whole, 4);
  RoundedRectangle wide = border_of(whole);
  wide.radius += Number::parse("0.03").value();
  go_round(whole, wide, 1);
  Pocket job = in_pieces(whole, 8, 100);
  job.level.chord = Number::parse("0.015").value();
  const LevelVerdict verdict = judge(job);
  ASSERT_EQ(verdict.kind, LevelVerdict::Kind::no_go);
  EXPECT_EQ(verdict.finding->rule, Rule::gouge);
}

}  // namespace
}  // namespace gonogo::oracle::region
