// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/pocket_level_step.hpp"

#include <fmt/format.h>

#include <cmath>

#include "oracle/motion/arc_turns.hpp"
#include "oracle/open/enclosed_places.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::axes_of;
using reference::PocketLevel;
using reference::operator""_clause;

namespace {

std::string_view sentence(region::Rule rule) {
  switch (rule) {
    case region::Rule::gouge:
      return "The tool cuts into the wall of the pocket.";
    case region::Rule::cover:
      return "The tool leaves material in the pocket.";
    case region::Rule::step:
      return "The step between the tool's paths is too wide.";
    case region::Rule::sense:
      return "The level turns the wrong way round its middle.";
    case region::Rule::order:
      return "The tool cuts through solid material for more than the step.";
  }
  return "";
}

// Apart from depth and block.
bool same_level(const PocketLevel& a, const PocketLevel& b) {
  return a.plane == b.plane && a.centre == b.centre && a.pocket_radius == b.pocket_radius &&
         a.tool_radius == b.tool_radius && a.step == b.step && a.sense == b.sense;
}

// Ten times the way of concentric circles a step apart, of which each goes eight times its radius
// along both axes.
double most_way(const PocketLevel& level) {
  const double reach = estimate(level.pocket_radius - level.tool_radius);
  const double circles = std::ceil(reach / estimate(level.step)) + 1;
  return circles * reach * 8 * kMostTimes;
}

}  // namespace

PocketLevelStep::PocketLevelStep(const PocketLevel& level, const Position& place,
                                 const Tolerances& tolerances, std::optional<PocketLevel>& last)
    : level_(level),
      axes_(axes_of(level.plane)),
      place_(place),
      tolerances_(tolerances),
      last_(last),
      again_(ring_width(level.step, tolerances.level_tolerance())),
      way_(most_way(level)) {}

FreeStepAnswer PocketLevelStep::departs(VerdictKind kind, const Motion& motion, std::string message,
                                        const Number& off) const {
  Verdict verdict = departure_from(kind, level_.clause, level_.block, motion, level_text(level_),
                                   std::move(message));
  verdict.word = {};
  verdict.witness = point_text(motion.to(), {Axis::x, Axis::y, Axis::z});
  set_deviation(verdict, off);
  return FreeStepAnswer::decide(std::move(verdict));
}

// The traverse to where the pocket begins.
bool PocketLevelStep::is_before(const Motion& motion) const {
  return motions_.empty() && motion.record.kind == RecordKind::rapid &&
         visible_sign(motion.to()[axes_.d] - motion.from[axes_.d]) == 0;
}

// A traverse ends the level: at depth it is the retract's business, which may be too small to see.
bool PocketLevelStep::collects(const Motion& motion) const {
  const Record& record = motion.record;
  const bool other_block = tolerances_.compare_blocks && record.block != level_.block;
  if (other_block || !agree(motion.to()[axes_.d], motion.from[axes_.d], tolerances_.tolerance)) {
    return false;
  }
  return record.kind == RecordKind::feed || record.kind == RecordKind::arc;
}

// The next infeed or retract, of levels that lie close together.
bool PocketLevelStep::may_be_left_by(const Motion& small) const {
  const auto moves = [&](Axis axis) {
    return visible_sign(small.to()[axis] - small.from[axis]) != 0;
  };
  return small.record.kind != RecordKind::arc && moves(axes_.d) && !moves(axes_.p) &&
         !moves(axes_.q);
}

FreeStepAnswer PocketLevelStep::take(const Motion& motion) {
  if (collects(motion)) return collect(motion);
  if (std::optional<Verdict> fault = end(motion.from)) {
    const Number limit = level_.depth - tolerances_.tolerance;
    const bool is_deeper = visible_sign(motion.to()[axes_.d] - limit) < 0;
    const bool is_uncut = motions_.empty() && decision(fault->kind) == Decision::no_go;
    return is_uncut && is_deeper ? leaves_depth(motion) : FreeStepAnswer::decide(*std::move(fault));
  }
  return FreeStepAnswer::end(motion.from);
}

FreeStepAnswer PocketLevelStep::leaves_depth(const Motion& motion) const {
  return departs(VerdictKind::fail_region, motion, "The cut leaves the level's depth.",
                 exact::abs(motion.to()[axes_.d] - level_.depth));
}

FreeStepAnswer PocketLevelStep::collect(const Motion& motion) {
  const Record& record = motion.record;
  if (motions_.empty()) plunge_ = motion.from;
  if (!agree(motion.to()[axes_.d], level_.depth, tolerances_.tolerance))
    return leaves_depth(motion);
  if (turns_rotary_axis(motion.from, motion.to(), tolerances_.tolerance)) {
    return departs(VerdictKind::fail_region, motion, "A rotary axis moves in a level.");
  }
  if (record.kind == RecordKind::arc && record.plane != level_.plane) {
    return departs(VerdictKind::fail_region, motion, "The arc lies in another plane.");
  }
  if (!feeds_agree(level_.feed, level_.feed_mode, record, tolerances_)) {
    return departs(
        VerdictKind::fail_feed, motion,
        "The feed of the level differs." + feed_in_place_of(record, level_.feed, level_.feed_mode));
  }
  if (!again_.allows(motion)) {
    return departs(VerdictKind::fail_overrun, motion, std::string(kMilledTooOften));
  }
  if (!way_.allows(motion, axes_)) {
    return departs(VerdictKind::fail_overrun, motion,
                   "The cut is more than ten times as long as concentric circles.");
  }
  slack_ = max(slack_, slack_of_enclosures(motion, axes_));
  motions_.push_back(level_motion_near(motion, axes_));
  records_.push_back(record);
  if (motions_.size() > kMostMotions) {
    return FreeStepAnswer::gap(
        GapReason::cap_level,
        fmt::format("A level of more than {} motions is not judged.", kMostMotions));
  }
  return FreeStepAnswer::take(FreeStepAnswer::Cost::level_cut);
}

region::CircularLevel PocketLevelStep::circle(const Position& plunge) const {
  region::CircularLevel circle;
  circle.centre = {level_.centre[0], level_.centre[1]};
  circle.pocket_radius = level_.pocket_radius;
  circle.tool_radius = level_.tool_radius;
  circle.step = level_.step;
  circle.sense = level_.sense;
  circle.plunge = plane_point_near(plunge, axes_);
  circle.tolerance = tolerances_.level_tolerance();
  circle.chord = tolerances_.chord;
  circle.slack = slack_;
  circle.open_turns = open_turns(level_.centre, level_.pocket_radius, tolerances_);
  return circle;
}

Verdict PocketLevelStep::fault(const region::Finding& finding, const Position& here) const {
  Position witness = here;
  witness[axes_.p] = finding.witness.p;
  witness[axes_.q] = finding.witness.q;
  witness[axes_.d] = level_.depth;
  const bool is_order = finding.rule == region::Rule::order;
  Verdict verdict =
      fault_of_step(VerdictKind::fail_region, is_order ? "GSK-CYC-02"_clause : level_.clause,
                    level_.block, level_text(level_), witness, std::string(sentence(finding.rule)));
  add_finding(verdict, finding, motions_, records_);
  return verdict;
}

// So small that it is cleared where the subject stands: no disc covers one that is wider than it by
// more than the tolerance, before the region judge looks at anything else.
bool PocketLevelStep::is_judged_at_alarm(const Position& here) const {
  if (!motions_.empty()) return true;
  const Number wider = level_.pocket_radius - level_.tool_radius;
  if (wider > tolerances_.level_tolerance() * 2 + tolerances_.chord) return false;
  return region::judge_level(circle(here), {}).kind == region::LevelVerdict::Kind::go;
}

std::optional<Verdict> PocketLevelStep::end(const Position& here) {
  if (motions_.empty()) plunge_ = here;
  // Levels no farther apart than the tolerance are one level, and this one is cleared.
  const bool cleared = motions_.empty() && last_ && same_level(*last_, level_) &&
                       agree(last_->depth, level_.depth, tolerances_.tolerance);
  if (cleared) return std::nullopt;
  const region::LevelVerdict answer = region::judge_level(circle(plunge_), motions_);
  if (answer.kind == region::LevelVerdict::Kind::gap) {
    return FreeStepAnswer::gap(answer.reason, answer.gap).verdict;
  }
  if (answer.kind == region::LevelVerdict::Kind::no_go) {
    return fault(answer.finding.value(), here);
  }
  last_ = level_;
  return std::nullopt;
}

// At the level's exact depth.
FreeStep::Exit PocketLevelStep::exit(const Position& /*here*/) const {
  Position at = motions_.empty() ? plunge_ : place_;
  if (!motions_.empty()) {
    at[axes_.p] = records_.back().to[axes_.p];
    at[axes_.q] = records_.back().to[axes_.q];
  }
  at[axes_.d] = level_.depth;
  return {at};
}

}  // namespace gonogo::oracle
