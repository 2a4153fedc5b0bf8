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

}  // namespace

LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions) {
  const bool sound = level.tool_radius.sign() > 0 && level.tool_radius < level.pocket_radius &&
                     level.step.sign() > 0 && level.tolerance.sign() > 0 && level.chord.sign() >= 0;
  if (!sound) return out_of_range("The pocket, tool, step or tolerance is out of range.");
  Terms terms;
  terms.middle = level.centre;
  terms.area = {Number(), Number(), level.pocket_radius};
  terms.step = level.step;
  terms.tool_radius = level.tool_radius;
  terms.sense = level.sense;
  terms.plunge = level.plunge;
  terms.tolerance = level.tolerance;
  terms.chord = level.chord;
  terms.open_turns = level.open_turns.value_or(OpenTurns{level.tolerance});
  return judge_by_rules(terms, motions, method);
}

LevelVerdict judge_level_by(Method method, const RectangularLevel& level,
                            std::span<const LevelMotion> motions) {
  const bool sound = is_sound(level.area) && (!level.cleared || is_sound(*level.cleared)) &&
                     level.tool_radius.sign() > 0 && level.tool_radius <= level.area.radius &&
                     level.tolerance.sign() > 0 && level.slack.sign() >= 0 &&
                     level.slack < level.tolerance && level.chord.sign() >= 0;
  if (!sound) return out_of_range("The pocket, tool or tolerance is out of range.");
  Terms terms;
  terms.area = level.area;
  terms.cleared = level.cleared;
  terms.by_border = true;
  terms.tool_radius = level.tool_radius;
  terms.sense = level.sense;
  terms.plunge = level.plunge;
  terms.tolerance = level.tolerance;
  terms.slack = level.slack;
  terms.chord = level.chord;
  terms.open_turns = level.open_turns.value_or(OpenTurns{level.tolerance});
  return judge_by_rules(terms, motions, method);
}

LevelVerdict judge_level(const CircularLevel& level, std::span<const LevelMotion> motions) {
  return judge_level_by(Method::filter_first, level, motions);
}

LevelVerdict judge_level(const RectangularLevel& level, std::span<const LevelMotion> motions) {
  return judge_level_by(Method::filter_first, level, motions);
}

}  // namespace gonogo::oracle::region
