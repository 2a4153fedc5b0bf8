// SPDX-License-Identifier: GPL-3.0-or-later
//
// ProgramJudge's part for pocket levels: the motions between the plunge and the next motion along
// the depth axis, handed to the region judge as a whole.
#include <fmt/format.h>

#include "oracle/judge/evidence.hpp"
#include "oracle/judge/program_judge.hpp"

namespace gonogo::oracle {

using reference::axes_of;
using reference::kAllAxes;
using reference::PlaneAxes;
using reference::PocketLevel;
using reference::operator""_clause;

namespace {

region::PlanePoint plane_point(const Position& point, const PlaneAxes& axes) {
  return {point[axes.p], point[axes.q]};
}

std::string_view sentence(region::Rule rule) {
  switch (rule) {
    case region::Rule::gouge:
      return "The tool cuts into the wall of the pocket.";
    case region::Rule::cover:
      return "The tool leaves material in the pocket.";
    case region::Rule::step:
      return "The step between the tool's paths is too wide.";
    case region::Rule::sense:
      return "An arc of the level turns the wrong way.";
    case region::Rule::order:
      return "The tool cuts through solid material for more than the step.";
  }
  return "";
}

bool same_motion(const region::LevelMotion& a, const region::LevelMotion& b) {
  auto same = [](const region::PlanePoint& x, const region::PlanePoint& y) {
    return x.p == y.p && x.q == y.q;
  };
  return a.is_arc == b.is_arc && a.rot == b.rot && same(a.from, b.from) && same(a.to, b.to) &&
         (!a.is_arc || same(a.centre, b.centre));
}

// Apart from depth and block.
bool same_level(const PocketLevel& a, const PocketLevel& b) {
  return a.plane == b.plane && a.centre == b.centre && a.pocket_radius == b.pocket_radius &&
         a.tool_radius == b.tool_radius && a.step == b.step && a.sense == b.sense;
}

}  // namespace

void ProgramJudge::depart_from_level(VerdictKind kind, const Motion& motion,
                                     const PocketLevel& level, std::string message) {
  Verdict verdict;
  verdict.kind = kind;
  verdict.clause = level.clause;
  verdict.block = level.block;
  verdict.record = motion.number;
  verdict.want = level_text(level);
  verdict.got = record_text(motion.record);
  verdict.witness = point_text(motion.to(), {Axis::x, Axis::y, Axis::z});
  verdict.message = std::move(message);
  decide(std::move(verdict));
}

bool ProgramJudge::collect(const Motion& motion, const PocketLevel& level) {
  if (motion.record.kind == RecordKind::arc3) {
    if (const std::optional<Motion> arc = as_arc(motion)) return collect(*arc, level);
  }
  const PlaneAxes axes = axes_of(level.plane);
  const Number& tau = terms_.tolerance;
  const Record& record = motion.record;
  const bool other_block = terms_.compare_blocks && record.block != level.block;
  if (other_block || !agree(motion.to()[axes.d], motion.from[axes.d], tau)) return false;
  // A traverse ends the level: at depth it is the retract's business, which may be too small to
  // see.
  if (record.kind != RecordKind::feed && record.kind != RecordKind::arc) return false;
  if (level_motions_.empty()) plunge_ = motion.from;
  if (!agree(motion.to()[axes.d], level.depth, tau)) {
    depart_from_level(VerdictKind::fail_region, motion, level, "The cut leaves the level's depth.");
    return true;
  }
  for (Axis axis : kAllAxes) {
    if (!reference::is_linear(axis) && !agree(motion.from[axis], motion.to()[axis], tau)) {
      depart_from_level(VerdictKind::fail_region, motion, level, "A rotary axis moves in a level.");
      return true;
    }
  }
  if (record.kind == RecordKind::arc && record.plane != level.plane) {
    depart_from_level(VerdictKind::fail_region, motion, level, "The arc lies in another plane.");
    return true;
  }
  Record terms;
  terms.feed = level.feed;
  terms.feed_mode = level.feed_mode;
  if (!feeds_agree(terms, record, terms_)) {
    depart_from_level(VerdictKind::fail_feed, motion, level, "The feed of the level differs.");
    return true;
  }
  region::LevelMotion part;
  part.is_arc = record.kind == RecordKind::arc;
  part.from = plane_point(motion.from, axes);
  part.to = plane_point(motion.to(), axes);
  part.centre = {record.centre[0], record.centre[1]};
  part.rot = record.rot;
  part.record = motion.number;
  level_motions_.push_back(std::move(part));
  level_records_.push_back(record);
  budget_.count_level_cut();
  if (level_motions_.size() > region::kMaximumLevelMotions) {
    decide_gap(fmt::format("A level of more than {} motions is not judged.",
                           region::kMaximumLevelMotions));
  }
  return true;
}

namespace {

region::CircularLevel circle_of(const PocketLevel& level, const Position& plunge,
                                const JudgeTerms& terms) {
  region::CircularLevel circle;
  circle.centre = {level.centre[0], level.centre[1]};
  circle.pocket_radius = level.pocket_radius;
  circle.tool_radius = level.tool_radius;
  circle.step = level.step;
  circle.sense = level.sense;
  circle.plunge = plane_point(plunge, axes_of(level.plane));
  circle.tolerance = terms.level_tolerance();
  circle.chord = terms.chord;
  return circle;
}

}  // namespace

Verdict ProgramJudge::level_fault(const PocketLevel& level, const region::Finding& finding,
                                  const Position& here) const {
  const PlaneAxes axes = axes_of(level.plane);
  Position witness = here;
  witness[axes.p] = finding.witness.p;
  witness[axes.q] = finding.witness.q;
  witness[axes.d] = level.depth;
  Verdict verdict;
  verdict.kind = VerdictKind::fail_region;
  verdict.clause = finding.rule == region::Rule::order ? "GSK-CYC-02"_clause : level.clause;
  verdict.block = level.block;
  verdict.record = finding.record;
  verdict.want = level_text(level);
  for (std::size_t i = 0; i < level_motions_.size(); ++i) {
    if (finding.record == level_motions_[i].record) verdict.got = record_text(level_records_[i]);
  }
  verdict.witness = point_text(witness, {Axis::x, Axis::y, Axis::z});
  if (finding.deviation.sign() != 0) {
    verdict.deviation_exact = exact_text(finding.deviation);
    verdict.deviation_mm = millimetres_text(finding.deviation);
  }
  verdict.message = sentence(finding.rule);
  return verdict;
}

bool ProgramJudge::is_known_level(const PocketLevel& level) const {
  const PlaneAxes axes = axes_of(level.plane);
  return last_level_ && same_level(*last_level_, level) &&
         plunge_[axes.p] == last_plunge_[axes.p] && plunge_[axes.q] == last_plunge_[axes.q] &&
         std::equal(level_motions_.begin(), level_motions_.end(), last_motions_.begin(),
                    last_motions_.end(), same_motion);
}

bool ProgramJudge::needs_no_motion(const PocketLevel& level) const {
  const region::CircularLevel circle = circle_of(level, position_, terms_);
  return level_motions_.empty() &&
         region::judge_level(circle, {}).kind == region::LevelVerdict::Kind::go;
}

void ProgramJudge::finish_level(const PocketLevel& level, const Position& here) {
  if (level_motions_.empty()) plunge_ = here;
  // Equal levels are judged once. Levels no farther apart than the tolerance are one level, and
  // this one is cleared.
  const bool known = is_known_level(level);
  const bool cleared = level_motions_.empty() && last_level_ && same_level(*last_level_, level) &&
                       agree(last_level_->depth, level.depth, terms_.tolerance);
  if (!known && !cleared) {
    const region::LevelVerdict answer =
        region::judge_level(circle_of(level, plunge_, terms_), level_motions_);
    if (answer.kind == region::LevelVerdict::Kind::gap) return decide_gap(answer.gap);
    if (answer.kind == region::LevelVerdict::Kind::no_go) {
      return decide(level_fault(level, answer.finding.value(), here));
    }
    last_level_ = level;
    last_motions_ = level_motions_;
    last_plunge_ = plunge_;
  }
  if (known) last_level_->depth = level.depth;
  go_on_below(level);
}

// The reference goes on from where the subject left the level, at the level's exact depth.
void ProgramJudge::go_on_below(const PocketLevel& level) {
  const PlaneAxes axes = axes_of(level.plane);
  Position at = level_motions_.empty() ? plunge_ : reference_.position();
  if (!level_motions_.empty()) {
    at[axes.p] = level_motions_.back().to.p;
    at[axes.q] = level_motions_.back().to.q;
  }
  at[axes.d] = level.depth;
  level_motions_.clear();
  level_records_.clear();
  reference_.go_on_from(at);
  reference_.advance();
}

}  // namespace gonogo::oracle
