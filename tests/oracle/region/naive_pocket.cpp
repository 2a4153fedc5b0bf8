// SPDX-License-Identifier: GPL-3.0-or-later
//
// The independent look at pockets with rounded corners.
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "tests/oracle/region/pocket_expectations.hpp"

namespace gonogo::oracle::region {
namespace {

Number clamped(const Number& value, const Number& half) {
  return exact::max(-half, exact::min(value, half));
}

// To the nearest point of the core, exactly.
Number distance_to_core(const RoundedRectangle& shape, const PlanePoint& point) {
  const Number p = point.p - clamped(point.p, shape.core_p);
  const Number q = point.q - clamped(point.q, shape.core_q);
  return exact::sqrt(p * p + q * q);
}

Number distance_to_line(const LevelMotion& motion, const PlanePoint& point) {
  const Number dp = motion.to.p - motion.from.p;
  const Number dq = motion.to.q - motion.from.q;
  const Number wp = point.p - motion.from.p;
  const Number wq = point.q - motion.from.q;
  const Number length2 = dp * dp + dq * dq;
  if (length2.sign() == 0) return exact::sqrt(wp * wp + wq * wq);
  // The foot of the perpendicular, held between the ends.
  const Number part = exact::max(Number(), exact::min((wp * dp + wq * dq) / length2, Number(1)));
  const Number ap = wp - part * dp;
  const Number aq = wq - part * dq;
  return exact::sqrt(ap * ap + aq * aq);
}

using RoughDistance = std::function<double(double x, double y)>;

RoughDistance rough_distance_to(const LevelMotion& motion) {
  if (motion.is_arc) return rough_distance_to_arc(motion);
  const double ax = approximate(motion.from.p);
  const double ay = approximate(motion.from.q);
  const double dx = approximate(motion.to.p) - ax;
  const double dy = approximate(motion.to.q) - ay;
  const double length2 = dx * dx + dy * dy;
  return [=](double x, double y) {
    const double part =
        length2 > 0 ? std::clamp(((x - ax) * dx + (y - ay) * dy) / length2, 0.0, 1.0) : 0.0;
    return std::hypot(x - ax - part * dx, y - ay - part * dy);
  };
}

// For the whole path.
RoughDistance rough_distance_to(const Pocket& pocket) {
  std::vector<RoughDistance> all;
  LevelMotion plunge;
  plunge.from = plunge.to = pocket.level.plunge;
  all.push_back(rough_distance_to(plunge));
  for (const LevelMotion& motion : pocket.motions) all.push_back(rough_distance_to(motion));
  return [all](double x, double y) {
    double least = all.front()(x, y);
    for (const RoughDistance& one : all) least = std::min(least, one(x, y));
    return least;
  };
}

// By how much the point lies inside the shape.
double rough_depth(const RoundedRectangle& shape, double x, double y) {
  const double p = std::max(0.0, std::fabs(x) - approximate(shape.core_p));
  const double q = std::max(0.0, std::fabs(y) - approximate(shape.core_q));
  return approximate(shape.radius) - std::hypot(p, q);
}

std::string flaw_of_hole(const Pocket& pocket, const Finding& finding) {
  const RectangularLevel& level = pocket.level;
  if (!must_be_cleared(level, finding.witness)) return "need not be cleared";
  const Number reach = level.tool_radius + level.tolerance + level.slack;
  for (const LevelMotion& motion : pocket.motions) {
    if (!motion.is_arc || is_round(motion)) continue;
    const double far =
        rough_distance_to(pocket)(approximate(finding.witness.p), approximate(finding.witness.q));
    const double apart = far - approximate(level.tool_radius);
    return apart > approximate(finding.deviation) - 1e-9 ? "" : "too near";
  }
  const Number beyond = exact_distance(pocket, finding.witness) - reach;
  if (beyond.sign() <= 0) return "within reach";
  const Number apart = beyond + level.tolerance + level.slack;
  if (exact::abs(apart - finding.deviation) > mm("1e-20")) return "deviation differs";
  return {};
}

std::string flaw_of_gouge(const Pocket& pocket, const Finding& finding) {
  const RectangularLevel& level = pocket.level;
  const Number beyond = distance_to_core(level.area, finding.witness) - border_of(pocket).radius;
  if (beyond <= level.tolerance + level.slack) return "not outside";
  if (exact::abs(beyond - finding.deviation) > mm("1e-9")) return "deviation differs";
  const LevelMotion& motion = pocket.motions.at(finding.record.value());
  const double off =
      rough_distance_to(motion)(approximate(finding.witness.p), approximate(finding.witness.q));
  return off < 1e-8 ? "" : "not on the motion";
}

}  // namespace

bool must_be_cleared(const RectangularLevel& level, const PlanePoint& point) {
  if (distance_to_core(level.area, point) > level.area.radius) return false;
  return !level.cleared || distance_to_core(*level.cleared, point) > level.cleared->radius;
}

Number exact_distance(const Pocket& pocket, const PlanePoint& point) {
  const Number p = point.p - pocket.level.plunge.p;
  const Number q = point.q - pocket.level.plunge.q;
  Number least = exact::sqrt(p * p + q * q);
  for (const LevelMotion& motion : pocket.motions) {
    const Number distance =
        motion.is_arc ? exact_distance(motion, point) : distance_to_line(motion, point);
    if (distance < least) least = distance;
  }
  return least;
}

std::string flaw_of_finding(const Pocket& pocket, const Finding& finding) {
  if (finding.rule == Rule::cover) return flaw_of_hole(pocket, finding);
  if (finding.rule == Rule::gouge) return flaw_of_gouge(pocket, finding);
  return finding.rule == Rule::sense && finding.record ? "" : "no such rule";
}

std::string flaw_of_go(const Pocket& pocket) {
  const RectangularLevel& level = pocket.level;
  const double p = approximate(level.area.core_p + level.area.radius);
  const double q = approximate(level.area.core_q + level.area.radius);
  const double reach = approximate(level.tool_radius + level.tolerance);
  std::mt19937_64 random(20261121);
  std::uniform_real_distribution<double> part(-1, 1);
  const RoughDistance distance = rough_distance_to(pocket);
  const int samples = pocket.motions.size() > 200 ? 1'000 : 5'000;
  for (int k = 0; k < samples; ++k) {
    const double x = p * part(random);
    const double y = q * part(random);
    if (rough_depth(level.area, x, y) < 0) continue;
    if (level.cleared && rough_depth(*level.cleared, x, y) > 0) continue;
    const double far = distance(x, y);
    if (far > reach + 1e-6) return fmt::format("{} at {}, {}", far, x, y);
  }
  return {};
}

}  // namespace gonogo::oracle::region
