// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
// After GoogleTest, which it needs.
#include <rapidcheck/gtest.h>

#include "oracle/region/frame.hpp"
#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

Number tenths(int count) {
  return Number::millionths(std::int64_t{100'000} * count);
}

// Whether a motion comes within reach of the point, by squares alone. Arcs are whole circles.
bool reaches(const LevelMotion& motion, const PlanePoint& point, const Number& reach) {
  const Number s2 = reach * reach;
  const auto squared = [](const Number& p, const Number& q) { return p * p + q * q; };
  if (motion.is_arc) {
    const Number r =
        exact::sqrt(squared(motion.from.p - motion.centre.p, motion.from.q - motion.centre.q));
    const Number d2 = squared(point.p - motion.centre.p, point.q - motion.centre.q);
    return d2 <= (r + reach) * (r + reach) && (r <= reach || d2 >= (r - reach) * (r - reach));
  }
  const Number dp = motion.to.p - motion.from.p;
  const Number dq = motion.to.q - motion.from.q;
  const Number wp = point.p - motion.from.p;
  const Number wq = point.q - motion.from.q;
  if (squared(wp, wq) <= s2) return true;
  if (squared(point.p - motion.to.p, point.q - motion.to.q) <= s2) return true;
  const Number along = wp * dp + wq * dq;
  const Number length2 = squared(dp, dq);
  if (along.sign() <= 0 || along >= length2) return false;
  const Number aside = wp * dq - wq * dp;
  return aside * aside <= s2 * length2;
}

// A point of a raster that must be cleared and is not.
std::optional<PlanePoint> missed_on_raster(const Pocket& job) {
  const RectangularLevel& level = job.level;
  const Number reach = level.tool_radius + level.tolerance;
  const Number p_max = level.area.core_p + level.area.radius;
  const Number q_max = level.area.core_q + level.area.radius;
  const Number step = Number(1) / Number(6);
  for (Number p = -p_max; p <= p_max; p += step) {
    for (Number q = -q_max; q <= q_max; q += step) {
      const PlanePoint point{p, q};
      if (!must_be_cleared(level, point)) continue;
      LevelMotion plunge;
      plunge.from = plunge.to = level.plunge;
      if (reaches(plunge, point, reach)) continue;
      const bool done =
          std::any_of(job.motions.begin(), job.motions.end(),
                      [&](const LevelMotion& motion) { return reaches(motion, point, reach); });
      if (!done) return point;
    }
  }
  return std::nullopt;
}

// E: 2 x 1 about the origin, grown by 0.5. Lines between points of a raster, circles between them.
Pocket random_path() {
  Pocket job = pocket("7", "5", "1.5", "1", "0");
  if (*rc::gen::arbitrary<bool>()) {
    job.level.cleared = pocket("7", "5", "1.5", "1", "0.8").level.area;
  }
  const int count = *rc::gen::inRange(3, 40);
  for (int k = 0; k < count; ++k) {
    const PlanePoint to{tenths(*rc::gen::inRange(-24, 25)), tenths(*rc::gen::inRange(-14, 15))};
    line_to(job, to);
    if (*rc::gen::inRange(0, 3) == 0) {
      const PlanePoint centre{to.p - tenths(*rc::gen::inRange(-5, 6)), to.q};
      if (!(centre == to)) arc_to(job, to, centre, *rc::gen::element(1, -1));
    }
  }
  if (*rc::gen::arbitrary<bool>()) finish(job);
  // The rules before cover are others' business: leave out what breaks them.
  for (LevelVerdict verdict = judge(job); verdict.finding && verdict.finding->record;
       verdict = judge(job)) {
    job.motions.erase(job.motions.begin() + static_cast<std::ptrdiff_t>(*verdict.finding->record));
    for (std::size_t k = 0; k < job.motions.size(); ++k) job.motions[k].record = k;
  }
  return job;
}

RC_GTEST_PROP(PocketRegionProperty, ARandomPathAgreesWithARaster, ()) {
  const Pocket job = random_path();
  const LevelVerdict verdict = judge(job);
  const auto missed = missed_on_raster(job);
  RC_CLASSIFY(!missed, "all of the raster reached");
  RC_ASSERT(verdict.kind != LevelVerdict::Kind::gap);
  if (missed) RC_ASSERT(verdict.kind == LevelVerdict::Kind::no_go);
  if (verdict.finding) {
    RC_ASSERT(flaw_of_finding(job, *verdict.finding) == "");
  } else {
    RC_ASSERT(flaw_of_go(job) == "");
  }
}

RC_GTEST_PROP(PocketRegionProperty, TheFilterAndTheExactDecisionAgree, ()) {
  const Pocket job = random_path();
  const LevelVerdict filtered = judge(job);
  const LevelVerdict exact = judge_level_by(Method::exact_only, job.level, job.motions);
  RC_ASSERT(filtered.kind == exact.kind);
  if (filtered.finding) RC_ASSERT(filtered.finding->rule == exact.finding->rule);
}

Pocket cleared_somehow() {
  const int tool = *rc::gen::inRange(20, 60);
  const int corner = *rc::gen::inRange(0, 100);
  const int width = 2 * std::max(tool, corner) + *rc::gen::inRange(1, 200);
  const int length = width + *rc::gen::inRange(0, 200);
  const auto text = [](int count) { return tenths(count).text(); };
  Pocket job = pocket(text(length), text(width), text(corner), text(tool), "0");
  job.level.sense = *rc::gen::element(1, -1);
  const Number step = job.level.tool_radius * tenths(*rc::gen::inRange(2, 11));
  *rc::gen::arbitrary<bool>() ? zigzag(job, step) : contour_parallel(job, step);
  return job;
}

RC_GTEST_PROP(PocketRegionProperty, EveryPocketClearedIsGo, ()) {
  RC_ASSERT(is_go(cleared_somehow()));
}

// In base coordinates, turned by an angle and rounded to the micron, and back.
RC_GTEST_PROP(PocketRegionProperty, TurnedAndRoundedIsGo, ()) {
  Pocket job = cleared_somehow();
  const auto [cos, sin] = exact::cos_sin_degrees(tenths(*rc::gen::inRange(-1'800, 1'801)));
  const PocketFrame frame = make_frame({mm("12.3"), Number(100) / Number(3)}, cos, sin);
  const auto rounded = [&frame](const PlanePoint& point) {
    const PlanePoint base = out_of(frame, point);
    const auto micron = [](const Number& value) {
      return (value * Number(1000) + mm("0.5")).floor() / Number(1000);
    };
    return into(frame, {micron(base.p), micron(base.q)});
  };
  for (LevelMotion& motion : job.motions) {
    motion.from = rounded(motion.from);
    motion.to = rounded(motion.to);
    motion.centre = rounded(motion.centre);
  }
  job.level.slack = slack_of(frame, job.level.area);
  RC_ASSERT(is_go(job));
}

// A row or a ring less leaves an island, unless its neighbours reach across.
RC_GTEST_PROP(PocketRegionProperty, AMotionLeftOutIsMissedWhereItMatters, ()) {
  Pocket job = cleared_somehow();
  const auto at = *rc::gen::inRange<std::size_t>(0, job.motions.size());
  job.motions[at].is_arc = false;
  job.motions[at].to = job.motions[at].from;
  const LevelVerdict verdict = judge(job);
  RC_CLASSIFY(verdict.kind == LevelVerdict::Kind::no_go, "island");
  RC_ASSERT(verdict.kind != LevelVerdict::Kind::gap);
  if (verdict.finding) {
    RC_ASSERT(flaw_of_finding(job, *verdict.finding) == "");
  } else {
    RC_ASSERT(flaw_of_go(job) == "");
  }
}

}  // namespace
}  // namespace gonogo::oracle::region
