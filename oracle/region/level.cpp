// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/level.hpp"

#include <algorithm>
#include <deque>

#include "oracle/region/constants.hpp"
#include "oracle/region/rules.hpp"

namespace gonogo::oracle::region {
namespace {

bool is_sound(const RoundedRectangle& shape) {
  return shape.core_p.sign() >= 0 && shape.core_q.sign() >= 0 && shape.radius.sign() > 0;
}

bool is_sound(const CommonLevel& terms) {
  return terms.tool_radius.sign() > 0 && terms.tolerance.sign() > 0 && terms.chord.sign() >= 0 &&
         terms.slack.sign() >= 0 && terms.slack < terms.tolerance;
}

// The levels that were judged last: those of one pocket are cut alike, and the ways to read a
// program and a trace that are followed at once come to the same level one after the other.
template <class Level>
class JudgedLately {
 public:
  LevelVerdict judge(const Level& level, std::span<const LevelMotion> motions) {
    for (const Judged& one : judged_) {
      if (is_same(one, level, motions)) return one.verdict;
    }
    judged_.push_back({level,
                       {motions.begin(), motions.end()},
                       judge_level_by(Method::filter_first, level, motions)});
    kept_ += motions.size();
    while (judged_.size() > 1 && (judged_.size() > kLevelsKept || kept_ > kMostMotionsKept)) {
      kept_ -= judged_.front().motions.size();
      judged_.pop_front();
    }
    return judged_.back().verdict;
  }

 private:
  struct Judged {
    Level level;
    std::vector<LevelMotion> motions;
    LevelVerdict verdict;
  };
  // Only a finding names records. Numbers that no comparison decides are not the same.
  static bool is_same(const Judged& one, const Level& level, std::span<const LevelMotion> motions) {
    const bool is_go = one.verdict.kind == LevelVerdict::Kind::go;
    const auto is_equal = [&](const LevelMotion& a, const LevelMotion& b) {
      return same_cut(a, b) && (is_go || a.record == b.record);
    };
    try {
      return std::ranges::equal(one.motions, motions, is_equal) && one.level == level;
    } catch (const exact::Undecided&) {
      return false;
    }
  }

  std::deque<Judged> judged_;
  std::size_t kept_ = 0;  // motions of them all
};

}  // namespace

LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions) {
  if (!is_sound(level) || level.tool_radius >= level.pocket_radius || level.step.sign() <= 0) {
    return LevelVerdict::undecided(GapReason::unjudged_form,
                                   "The pocket, tool, step or tolerance is out of range.");
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
                     level.tool_radius <= level.area.radius;
  if (!sound) {
    return LevelVerdict::undecided(GapReason::unjudged_form,
                                   "The pocket, tool or tolerance is out of range.");
  }
  AnyLevel terms(level);
  terms.area = level.area;
  terms.cleared = level.cleared;
  terms.by_border = true;
  return judge_by_rules(terms, motions, method);
}

LevelVerdict judge_level(const CircularLevel& level, std::span<const LevelMotion> motions) {
  thread_local JudgedLately<CircularLevel> lately;
  return lately.judge(level, motions);
}

LevelVerdict judge_level(const RectangularLevel& level, std::span<const LevelMotion> motions) {
  thread_local JudgedLately<RectangularLevel> lately;
  return lately.judge(level, motions);
}

}  // namespace gonogo::oracle::region
