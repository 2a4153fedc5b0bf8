// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/oracle/region/expectations.hpp"

namespace gonogo::oracle::region {
namespace {

Number micron(int count) {
  return Number::millionths(std::int64_t{1000} * count);
}

// Rational directions, so that the radii stay what they are.
PlanePoint direction(int which) {
  const PlanePoint all[] = {{1, 0},
                            {0, -1},
                            {mm("0.6"), mm("0.8")},
                            {mm("-0.28"), mm("0.96")},
                            {mm("-5/13"), mm("-12/13")}};
  return all[which];
}

Job rings(const CircularLevel& level, const std::vector<int>& radii) {
  Job job{level, {}};
  for (const int radius : radii) circle(job, micron(radius), direction(*rc::gen::inRange(0, 5)));
  return job;
}

// What the radii alone say, in microns, in the order of the rules; nothing: go.
std::optional<Rule> by_gaps(std::vector<int> radii, int border, int tool, int step) {
  radii.push_back(0);  // the plunge point
  std::sort(radii.begin(), radii.end());
  if (radii.back() > border + 1) return Rule::gouge;
  const auto leaves_hole = [&radii](int disc, int half_reach2) {
    for (std::size_t k = 1; k < radii.size(); ++k) {
      // A gap inside the disc wider than twice the reach.
      if (radii[k - 1] < disc && radii[k] - radii[k - 1] > half_reach2 &&
          2 * disc > 2 * radii[k - 1] + half_reach2) {
        return true;
      }
    }
    return 2 * (disc - radii.back()) > half_reach2;
  };
  if (leaves_hole(border + tool, 2 * tool + 2)) return Rule::cover;
  if (leaves_hole(border, step + 2)) return Rule::step;
  return std::nullopt;
}

RC_GTEST_PROP(RegionProperty, RingsAreJudgedByTheirGaps, ()) {
  const CircularLevel level = i16_l3_d4();
  // Growing by about a step, now and then exactly to the limit or a micron beyond.
  std::vector<int> radii;
  for (int radius = 0; radius < 12'000;) {
    radius += *rc::gen::weightedOneOf<int>({{6, rc::gen::inRange(2'500, 3'000)},
                                            {3, rc::gen::element(3'000, 3'001, 3'002)},
                                            {1, rc::gen::inRange(3'003, 4'200)}});
    radii.push_back(std::min(radius, *rc::gen::element(12'000, 12'000, 12'001, 11'999, 12'002)));
  }
  const Job job = rings(level, radii);
  const auto expected = by_gaps(radii, 12'000, 4'000, 3'000);
  const LevelVerdict verdict = judge(job);
  RC_CLASSIFY(!expected.has_value());
  if (expected) {
    RC_ASSERT(breaks(*expected, job, verdict));
  } else {
    RC_ASSERT(is_go(job, verdict));
  }
}

RC_GTEST_PROP(RegionProperty, ARingThatIsDroppedIsAlwaysMissed, ()) {
  CircularLevel level = i16_l3_d4();
  const int count = *rc::gen::inRange(2, 9);
  // Spacing above half the widest gap allowed, so that no ring is dispensable.
  const int spacing = *rc::gen::inRange(1'502, 3'003);
  std::vector<int> radii;
  for (int k = 1; k <= count; ++k) radii.push_back(k * spacing);
  level.pocket_radius = micron(count * spacing) + level.tool_radius;
  RC_ASSERT(is_go(rings(level, radii)));
  const auto dropped = *rc::gen::inRange(0, count);
  radii.erase(radii.begin() + dropped);
  const Job job = rings(level, radii);
  const LevelVerdict verdict = judge(job);
  RC_ASSERT(verdict.kind == LevelVerdict::Kind::no_go);
  RC_ASSERT(flaw_of_finding(job, *verdict.finding) == "");
}

RC_GTEST_PROP(RegionProperty, SemicircleSpiralsAreGoForEveryPocket, ()) {
  CircularLevel level = i16_l3_d4(*rc::gen::element(-1, 1));
  level.tool_radius = micron(*rc::gen::inRange(1'000, 8'000));
  level.pocket_radius = level.tool_radius + micron(*rc::gen::inRange(100, 20'000));
  level.step = level.tool_radius * micron(*rc::gen::inRange(300, 2'000));
  const PlanePoint by{micron(*rc::gen::inRange(-900'000, 900'000)), mm("1/7")};
  RC_ASSERT(is_go(moved(semicircles(level), by)));
}

// The direction of twice the angle whose tangent is t.
PlanePoint by_half_tangent(const Number& t) {
  const Number below = Number(1) + t * t;
  return {(Number(1) - t * t) / below, Number(2) * t / below};
}

// The ring of 6 is open by an angle g. The bands of 3 and 9 end at 4.501 and 7.499; there the discs
// about its two ends reach round by an angle f with 1.499^2 + 2*6*7.499 (1 - cos f) = 1.501^2:
// f = 0.011547 (at 4.501: 0.0149). So it is go up to g = 0.02309, tan(g/2) = 0.011547.
RC_GTEST_PROP(RegionProperty, ANarrowOpeningOfARingIsSeen, ()) {
  const bool wide = *rc::gen::arbitrary<bool>();
  const Number opening = Number::millionths(
      wide ? *rc::gen::oneOf(rc::gen::inRange(11'700, 12'500), rc::gen::inRange(11'700, 200'000))
           : *rc::gen::inRange(1'000, 11'400));
  const Number start = micron(*rc::gen::inRange(-3'000, 3'000));
  const Number end = (start + opening) / (Number(1) - start * opening);
  Job job = concentric(i16_l3_d4(), {3});
  const PlanePoint a = by_half_tangent(start);
  const PlanePoint b = by_half_tangent(end);
  line_to(job, {Number(6) * a.p, Number(6) * a.q});
  arc_to(job, {Number(6) * b.p, Number(6) * b.q}, {}, -1);
  // From opposite the opening, where the ring of 6 is made.
  for (const int radius : {9, 12}) circle(job, radius, {-1, 0});
  RC_ASSERT((wide ? breaks(Rule::step, job) : is_go(job)));
}

// The ring of 6 stands aside by d: on the other side it is 3 + d from the ring of 9.
RC_GTEST_PROP(RegionProperty, ARingBesideTheCentreIsMeasuredWhereTheGapIsWidest, ()) {
  const bool wide = *rc::gen::arbitrary<bool>();
  const Number aside =
      Number::millionths(wide ? *rc::gen::inRange(2'010, 3'000) : *rc::gen::inRange(0, 2'001));
  const PlanePoint u = by_half_tangent(micron(*rc::gen::inRange(-5'000, 5'000)));
  const PlanePoint centre{aside * u.p, aside * u.q};
  // The plunge point is 3 from the first ring; the gap from 3 to the ring of 6 is 3 + d as well.
  Job job = concentric(i16_l3_d4(), {3});
  line_to(job, {centre.p + Number(6), centre.q});
  arc_to(job, job.motions.back().to, centre, -1);
  for (const int radius : {9, 12}) circle(job, radius, {1, 0});
  RC_ASSERT((wide ? breaks(Rule::step, job) : is_go(job)));
}

// The filter says nothing that the exact decision denies.
RC_GTEST_PROP(RegionProperty, TheFilterAndTheExactDecisionAgree, ()) {
  CircularLevel level = i16_l3_d4();
  level.step = micron(*rc::gen::inRange(2'900, 3'100));
  Job job = semicircles(level, *rc::gen::element(true, true, false));
  job.level.step = 3;
  const LevelVerdict filtered = judge(job);
  const LevelVerdict exact = judge_level_by(Method::exact_only, job.level, job.motions);
  RC_ASSERT(filtered.kind == exact.kind);
  RC_ASSERT(filtered.finding.has_value() == exact.finding.has_value());
  if (filtered.finding) RC_ASSERT(filtered.finding->rule == exact.finding->rule);
}

}  // namespace
}  // namespace gonogo::oracle::region
