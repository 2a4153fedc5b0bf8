// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/level.hpp"

#include <utility>

#include "oracle/region/judge.hpp"
#include "oracle/region/rules.hpp"

namespace gonogo::oracle::region {
namespace {

LevelVerdict out_of_range(std::string what) {
  LevelVerdict verdict;
  verdict.kind = LevelVerdict::Kind::gap;
  verdict.reason = GapReason::unjudged_form;
  verdict.gap = std::move(what);
  return verdict;
}

bool is_sound(const RoundedRectangle& shape) {
  return shape.core_p.sign() >= 0 && shape.core_q.sign() >= 0 && shape.radius.sign() > 0;
}

bool is_sound(const CommonLevel& terms) {
  return terms.tool_radius.sign() > 0 && terms.tolerance.sign() > 0 && terms.chord.sign() >= 0;
}

}  // namespace

LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions) {
  if (!is_sound(level) || level.tool_radius >= level.pocket_radius || level.step.sign() <= 0) {
    return out_of_range("The pocket, tool, step or tolerance is out of range.");
  }
  AnyLevel terms(level);
  terms.middle = level.centre;
  terms.area = {Number(), Number(), level.pocket_radius};
  terms.step = level.step;
  return judge_by_rules(terms, motions, method);
}

LevelVerdict judge_level_by(Method method, const RectangularLevel& level,
                            std::span<const LevelMotion> motions) {
  const bool sound = is_sound(level) && is_sound(level.area) &&
                     (!level.cleared || is_sound(*level.cleared)) &&
                     level.tool_radius <= level.area.radius && level.slack.sign() >= 0 &&
                     level.slack < level.tolerance;
  if (!sound) return out_of_range("The pocket, tool or tolerance is out of range.");
  AnyLevel terms(level);
  terms.area = level.area;
  terms.cleared = level.cleared;
  terms.slack = level.slack;
  terms.by_border = true;
  return judge_by_rules(terms, motions, method);
}

LevelVerdict judge_level(const CircularLevel& level, std::span<const LevelMotion> motions) {
  return judge_level_by(Method::filter_first, level, motions);
}

LevelVerdict judge_level(const RectangularLevel& level, std::span<const LevelMotion> motions) {
  return judge_level_by(Method::filter_first, level, motions);
}

}  // namespace gonogo::oracle::region
