// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/level.hpp"

#include <utility>

#include "oracle/region/coverage.hpp"
#include "oracle/region/gouge.hpp"
#include "oracle/region/judge.hpp"

namespace gonogo::oracle::region {
namespace {

LevelVerdict gap(std::string why) {
  LevelVerdict verdict;
  verdict.kind = LevelVerdict::Kind::gap;
  verdict.gap = std::move(why);
  return verdict;
}

LevelVerdict broken(Rule rule, std::optional<std::size_t> record, PlanePoint witness,
                    Number deviation) {
  LevelVerdict verdict;
  verdict.kind = LevelVerdict::Kind::no_go;
  verdict.finding = Finding{rule, record, std::move(witness), std::move(deviation)};
  return verdict;
}

// An arc that moves: not a turn of radius 0.
bool moves(const LevelMotion& motion) {
  if (!motion.is_arc) return false;
  return !(motion.from == motion.to && motion.from == motion.centre);
}

// Ends no farther apart than the tolerance on either axis, but not the same point: rounding may
// have made this of no motion at all or of a whole turn.
bool is_ambiguous(const LevelMotion& motion, const Number& tolerance) {
  if (motion.rot == 0 || whole_turns(motion.rot) > 0 || motion.from == motion.to) return false;
  return exact::abs(motion.from.p - motion.to.p) <= tolerance &&
         exact::abs(motion.from.q - motion.to.q) <= tolerance;
}

class LevelJudge {
 public:
  LevelJudge(const CircularLevel& level, std::span<const LevelMotion> motions, Method method)
      : level_(level), motions_(motions), method_(method) {}

  LevelVerdict judge() {
    if (auto verdict = sense()) return *verdict;
    if (auto verdict = gouge()) return *verdict;
    path_.points.push_back(level_.plunge - level_.centre);
    if (auto verdict = covers(Rule::cover, level_.pocket_radius, level_.tool_radius)) {
      return *verdict;
    }
    const Number border = level_.pocket_radius - level_.tool_radius;
    if (auto verdict = covers(Rule::step, border, level_.step / Number(2))) return *verdict;
    if (!doubt_.empty()) return gap(doubt_);
    LevelVerdict verdict;
    verdict.by_filter = by_filter_;
    return verdict;
  }

 private:
  std::optional<LevelVerdict> sense();
  std::optional<LevelVerdict> gouge();
  std::optional<LevelVerdict> gouge_of_arc(const LevelMotion& motion);
  std::optional<LevelVerdict> within(const LevelMotion& motion, const Reach& reach);
  std::optional<LevelVerdict> covers(Rule rule, const Number& radius, const Number& reach);
  void clear_with(const Arc& arc, bool counterclockwise);
  void clear_with_ends(const LevelMotion& motion);
  Number limit() const { return level_.pocket_radius - level_.tool_radius + level_.tolerance; }

  const CircularLevel& level_;
  std::span<const LevelMotion> motions_;
  Method method_;
  Path path_;
  std::string doubt_;  // the first thing that stayed undecided
  bool by_filter_ = true;
};

// GSK-G110-09: by arcs turning the commanded way.
std::optional<LevelVerdict> LevelJudge::sense() {
  for (const LevelMotion& motion : motions_) {
    if (!moves(motion) || is_ambiguous(motion, level_.tolerance)) continue;
    if (motion.rot != 0 && (motion.rot > 0) == (level_.sense > 0)) continue;
    if (motion.rot == 0 && motion.from == motion.to) continue;
    return broken(Rule::sense, motion.record, motion.from, Number());
  }
  return std::nullopt;
}

std::optional<LevelVerdict> LevelJudge::gouge() {
  for (const LevelMotion& motion : motions_) {
    if (moves(motion) && motion.rot != 0) {
      if (auto verdict = gouge_of_arc(motion)) return verdict;
      continue;
    }
    // A line, or an arc that goes nowhere: the disc is convex.
    for (const PlanePoint& end : {motion.from, motion.to}) {
      const Reach reach = reach_of_point(end - level_.centre, limit());
      if (auto verdict = within(motion, reach)) return verdict;
    }
  }
  return std::nullopt;
}

std::optional<LevelVerdict> LevelJudge::gouge_of_arc(const LevelMotion& motion) {
  const bool counterclockwise = motion.rot > 0;
  const bool ambiguous = is_ambiguous(motion, level_.tolerance);
  if (motion.from == motion.centre || motion.to == motion.centre) {
    doubt_ = "An arc begins or ends on its own centre.";
    clear_with_ends(motion);
    return std::nullopt;
  }
  Arc arc = make_arc(motion, level_.centre);
  if (ambiguous && counterclockwise != (level_.sense > 0)) {
    clear_with_ends(motion);  // the wrong way round: it can only be meant as no motion
    return std::nullopt;
  }
  if (ambiguous && !arc.sweep.wide) {
    arc.turns = 1;  // the end is just past the start
    arc.full = arc.round;
  }
  const Reach reach = reach_of_arc(arc, limit());
  if (ambiguous && reach.kind != Reach::Kind::inside) {
    for (const PlanePoint& end : {arc.end_a(), arc.end_b()}) {
      if (auto verdict = within(motion, reach_of_point(end, limit()))) return verdict;
    }
    clear_with_ends(motion);
    return std::nullopt;
  }
  if (auto verdict = within(motion, reach)) return verdict;
  clear_with(arc, counterclockwise);
  return std::nullopt;
}

std::optional<LevelVerdict> LevelJudge::within(const LevelMotion& motion, const Reach& reach) {
  if (reach.kind == Reach::Kind::undecided && doubt_.empty()) {
    doubt_ = "Whether a spiral stays within the pocket could not be decided.";
  }
  if (reach.kind != Reach::Kind::outside) return std::nullopt;
  return broken(Rule::gouge, motion.record, reach.witness + level_.centre, reach.beyond);
}

// Pieces of one circle, one after the other, count as one arc.
void LevelJudge::clear_with(const Arc& arc, bool counterclockwise) {
  if (!path_.arcs.empty()) {
    if (const auto both = joined(path_.arcs.back(), arc, counterclockwise)) {
      path_.arcs.back() = *both;
      return;
    }
  }
  path_.arcs.push_back(arc);
}

void LevelJudge::clear_with_ends(const LevelMotion& motion) {
  path_.points.push_back(motion.from - level_.centre);
  path_.points.push_back(motion.to - level_.centre);
}

std::optional<LevelVerdict> LevelJudge::covers(Rule rule, const Number& radius,
                                               const Number& reach) {
  const Disc disc{radius, reach + level_.tolerance};
  const Coverage coverage = check_coverage(path_, disc, level_.tolerance, method_);
  by_filter_ = by_filter_ && coverage.by_filter;
  if (coverage.kind == Coverage::Kind::covered) return std::nullopt;
  if (coverage.kind == Coverage::Kind::undecided) {
    if (doubt_.empty()) doubt_ = coverage.why;
    return std::nullopt;
  }
  auto verdict = broken(rule, std::nullopt, coverage.witness + level_.centre, coverage.excess);
  verdict.by_filter = coverage.by_filter;
  return verdict;
}

}  // namespace

LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions) {
  if (motions.size() > kMaximumLevelMotions) return gap("The level has more than 50,000 motions.");
  const bool sound = level.tool_radius.sign() > 0 && level.tool_radius < level.pocket_radius &&
                     level.step.sign() > 0 && level.tolerance.sign() > 0;
  if (!sound) return gap("The pocket, tool, step or tolerance is out of range.");
  try {
    return LevelJudge(level, motions, method).judge();
  } catch (const exact::Undecided& error) {
    return gap(error.what());
  }
}

LevelVerdict judge_level(const CircularLevel& level, std::span<const LevelMotion> motions) {
  return judge_level_by(Method::filter_first, level, motions);
}

}  // namespace gonogo::oracle::region
