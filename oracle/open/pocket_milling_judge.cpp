// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/pocket_milling_judge.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

namespace {

region::RoundedRectangle area_of(const Number& length, const Number& width, const Number& corner) {
  return region::rounded_rectangle(length / 2, width / 2, corner);
}

// Ten times the way of lines a tool's radius apart, on every level.
double most_way(const reference::PocketMilling& item) {
  const double tool = estimate(item.tool_radius);
  const double length = estimate(item.length) / 2 - tool, width = estimate(item.width) / 2 - tool;
  const double lines = std::ceil(std::max(length, width) / tool) * 2 + 4;
  const double levels = estimate(item.level_count()) + 2;
  return lines * (length + width + tool) * 4 * levels * kMostTimes;
}

}  // namespace

PocketMillingJudge::PocketMillingJudge(const reference::PocketMilling& item, const Position& place,
                                       const Tolerances& tolerances)
    : item_(item),
      place_(place),
      tolerances_(tolerances),
      axes_(reference::axes_of(item.plane)),
      area_(area_of(item.length, item.width, item.corner_radius)),
      frame_(region::make_frame({item.centre[0], item.centre[1]}, item.direction[0],
                                item.direction[1])),
      slack_(region::slack_of(frame_, area_)),
      reach_(region::eroded(area_, item.tool_radius).value()),
      rough_reach_(reach_),
      cleared_{item.clearance, item.clearance},
      last_depth_(item.clearance),
      lowest_(item.clearance),
      depth_(item.clearance),
      again_(ring_width(item.tool_radius, tolerances.level_tolerance())),
      way_(most_way(item)) {
  // SIE-LC75-10: what a tool of this radius cleared in roughing; nothing where it does not fit.
  const Number narrower = min(item.length, item.width) - item.allowance * 2;
  if (!item.finishing || narrower < item.tool_radius * 2) return;
  const Number twice = item.allowance * 2;
  const Number corner = max(item.corner_radius - item.allowance, item.tool_radius);
  rough_area_ = area_of(item.length - twice, item.width - twice, corner);
  rough_reach_ = region::eroded(*rough_area_, item.tool_radius).value();
  cleared_.rough = item.rough_floor;
  if (item.contour_only) floor_cuts_.emplace(area_, item.tool_radius, rough_reach_);
}

Verdict PocketMillingJudge::incomplete(const Position& position) const {
  if (floor_fault_ && !floor_done_) return *floor_fault_;
  if (floor_done_) {
    Verdict verdict = fault_of_step(
        VerdictKind::fail_geometry, "SIE-LC75-13"_clause, item_.block, pocket_text(item_), position,
        "The cycle does not end above the centre at the retract plane.");
    set_deviation(verdict, from_centre(position, item_.retract));
    return verdict;
  }
  const Number depth = first_ ? item_.top() : last_depth_;
  Verdict verdict = fault_of_step(
      VerdictKind::fail_geometry, item_.clause, item_.block, pocket_text(item_), position,
      reference::with_values(first_ ? "The pocket is not milled to its floor. No level is milled "
                                      "between {} and {}."
                                    : "The pocket is not milled to its floor. It is milled to {} "
                                      "in place of {}.",
                             {depth, item_.floor}));
  set_deviation(verdict, depth - item_.floor);
  return verdict;
}

FreeStepAnswer PocketMillingJudge::departs(VerdictKind kind, reference::ClauseId clause,
                                           const Motion& motion, std::string message,
                                           const Number& off) const {
  Verdict verdict =
      departure_from(kind, clause, item_.block, motion, pocket_text(item_), std::move(message));
  set_deviation(verdict, off);
  return FreeStepAnswer::decide(std::move(verdict));
}

std::optional<Verdict> PocketMillingJudge::end(const Position& here) {
  if (over_) return std::nullopt;
  return incomplete(here);
}

// SIE-LC75-13
FreeStep::Exit PocketMillingJudge::exit(const Position& /*here*/) const {
  Position at = place_;
  at[axes_.p] = item_.centre[0];
  at[axes_.q] = item_.centre[1];
  at[axes_.d] = item_.retract;
  return {at};
}

// A traverse is no part of a level; only of a pocket as deep as the tolerance it may be the end.
bool PocketMillingJudge::sees(const Motion& small) const {
  if (tolerances_.compare_blocks && small.record.block != item_.block) return false;
  const Number& tau = tolerances_.tolerance;
  const bool is_shallow = item_.retract - item_.floor <= tau;
  if (small.record.kind == RecordKind::rapid && !is_shallow) return false;
  return !agree(small.from, small.to(), tau / kRoundingOfTolerance);
}

// SIE-LC75-11: infeeds of finishing may be fast. Whether this one may is judged as any other.
bool PocketMillingJudge::may_begin_within(const Motion& rest) const {
  return rest.record.kind == RecordKind::rapid;
}

FreeStepAnswer PocketMillingJudge::take(const Motion& motion) {
  FreeStepAnswer answer = take_motion(motion);
  if (is_limited() && is_cut(motion.record.kind)) answer.cost = FreeStepAnswer::Cost::free;
  return answer;
}

FreeStepAnswer PocketMillingJudge::take_motion(const Motion& motion) {
  if (over_) return FreeStepAnswer::end(motion.from);
  if (tolerances_.compare_blocks && motion.record.block != item_.block) {
    if (milling_) {
      if (FreeStepAnswer answer = finish_level(motion); answer.is_decided()) return answer;
    }
    // A lift that is too small to see may be missing.
    over_ = floor_done_ && item_.floor >= item_.retract - tolerances_.tolerance &&
            above_centre(motion.from) &&
            agree(motion.from[axes_.d], item_.retract, tolerances_.tolerance);
    if (over_) return FreeStepAnswer::end(motion.from);
    return FreeStepAnswer::decide(incomplete(motion.from));
  }
  const RecordKind kind = motion.record.kind;
  if (turns_rotary_axis(motion.from, motion.to(), tolerances_.tolerance)) {
    return departs(VerdictKind::fail_region, item_.clause, motion,
                   "A rotary axis moves in a pocket.");
  }
  if (kind != RecordKind::rapid && !is_cut(kind)) {
    return departs(VerdictKind::fail_geometry, item_.clause, motion,
                   "The motion is none of milling a pocket.");
  }
  if (kind == RecordKind::arc && motion.record.plane != item_.plane) {
    return departs(VerdictKind::fail_region, item_.clause, motion,
                   "The arc lies in another plane.");
  }
  if (is_cut(kind) && !again_.allows(motion)) {
    return departs(VerdictKind::fail_overrun, "SIE-LC75-04"_clause, motion,
                   std::string(kMilledTooOften));
  }
  if (!way_.allows(motion, axes_)) {
    return departs(VerdictKind::fail_overrun, "SIE-LC75-04"_clause, motion,
                   "The way is more than ten times as long as the levels need.");
  }
  take_slack_of(motion);
  const Number& from = motion.from[axes_.d];
  const Number& to = motion.to()[axes_.d];
  // At any feed.
  if (floor_cuts_ && is_cut(kind) && !goes_along_depth(motion) && is_floor(to)) {
    floor_cuts_->add(own(motion));
  }
  // SIE-LC75-05: levels may begin above what is to be cut.
  if (to < lowest_ - tolerances_.tolerance && is_near_cleared(to)) {
    lowest_ = to;
    again_.clear();
  }
  if (!goes_along_depth(motion)) return take_along_plane(motion);
  has_risen_ = to > from;
  if (stays_at_level(motion)) return FreeStepAnswer::take();
  if (milling_ && !(motions_.empty() && to < from)) {
    if (FreeStepAnswer answer = finish_level(motion); answer.is_decided()) return answer;
  }
  return to < from ? take_down(motion) : take_travel(motion);
}

bool PocketMillingJudge::goes_along_depth(const Motion& motion) const {
  const Number way = exact::abs(motion.to()[axes_.d] - motion.from[axes_.d]);
  if (way > tolerances_.tolerance) return true;
  const Number rounding = tolerances_.tolerance / kRoundingOfTolerance;
  return way > rounding && motion.record.kind != RecordKind::arc &&
         agree(motion.from[axes_.p], motion.to()[axes_.p], rounding) &&
         agree(motion.from[axes_.q], motion.to()[axes_.q], rounding);
}

bool PocketMillingJudge::stays_at_level(const Motion& motion) const {
  const Number& to = motion.to()[axes_.d];
  if (!milling_ || !is_cut(motion.record.kind) || !agree(to, depth_, tolerances_.tolerance) ||
      !agree(to, motion.from[axes_.d], tolerances_.tolerance)) {
    return false;
  }
  // In finishing, the floor is not cleared as the level just above it.
  return !(item_.finishing && to < depth_ && to >= item_.floor);
}

// At one depth: the cuts of a level, or travel.
FreeStepAnswer PocketMillingJudge::take_along_plane(const Motion& motion) {
  const Number& depth = motion.to()[axes_.d];
  const bool is_a_cut = is_cut(motion.record.kind);
  if (is_near_cleared(depth)) return take_near_cleared(motion);
  if (is_a_cut && has_feed(motion, item_.plane_feed)) return take_cut(motion);
  const bool deep = depth < cleared_.rough - tolerances_.tolerance;
  if (is_a_cut && !deep && stays_in(motion, rough_reach_).value_or(false)) {
    return FreeStepAnswer::take();
  }
  // Anything else comes after the level: what is cleared by now is all of it.
  if (milling_) {
    const FreeStepAnswer answer = finish_level(motion);
    const bool decided = answer.is_decided();
    if (!decided) return take_travel(motion);
    if (!is_a_cut) return answer;
  }
  if (!is_a_cut) return take_travel(motion);
  return departs(VerdictKind::fail_feed, "SIE-LC75-04"_clause, motion,
                 "The feed in the plane differs." +
                     feed_in_place_of(motion.record, item_.plane_feed, item_.feed_mode));
}

bool PocketMillingJudge::is_near_cleared(const Number& depth) const {
  const bool in_air = item_.finishing && depth >= item_.reference_plane - tolerances_.tolerance;
  return in_air || depth >= cleared_.everywhere - tolerances_.tolerance;
}

// J-PKT-09: travel; but where the floor is as near as the tolerance, it may be the level at the
// floor.
FreeStepAnswer PocketMillingJudge::take_near_cleared(const Motion& motion) {
  const Number& depth = motion.to()[axes_.d];
  const bool mills = !floor_done_ && is_floor(depth) && is_cut(motion.record.kind) &&
                     has_feed(motion, item_.plane_feed);
  // The infeed to it cut.
  if (mills && milling_ && !may_be_travel_) return take_cut(motion);
  if (may_be_travel_ && !mills) {
    if (FreeStepAnswer answer = finish_level(motion); answer.is_decided()) return answer;
  }
  const FreeStepAnswer travel = take_travel(motion);
  if (!mills || travel.is_decided()) return travel;
  if (!milling_) start_floor_or_travel(depth, motion.from);
  return may_be_travel_ ? collect(motion) : travel;
}

void PocketMillingJudge::start_floor_or_travel(const Number& depth, const Position& plunge) {
  milling_ = true;
  may_be_travel_ = true;
  depth_ = depth;
  plunge_ = own(plunge);
}

FreeStepAnswer PocketMillingJudge::take_cut(const Motion& motion) {
  if (!milling_) {
    depth_ = motion.from[axes_.d];
    if (FreeStepAnswer answer = check_level_depth(motion); answer.is_decided()) return answer;
    milling_ = true;
    plunge_ = own(motion.from);
  } else if (motions_.empty()) {
    if (FreeStepAnswer answer = check_level_depth(motion); answer.is_decided()) return answer;
  }
  if (!agree(motion.to()[axes_.d], depth_, tolerances_.tolerance)) {
    return departs(VerdictKind::fail_region, "SIE-LC75-04"_clause, motion,
                   "The cut leaves the level's depth.", exact::abs(motion.to()[axes_.d] - depth_));
  }
  return collect(motion);
}

FreeStepAnswer PocketMillingJudge::collect(const Motion& motion) {
  motions_.push_back(own(motion));
  records_.push_back(motion.record);
  if (motions_.size() > kMostMotions) {
    return FreeStepAnswer::gap(GapReason::cap_level,
                               "A level of more than 50,000 motions is not judged.");
  }
  return FreeStepAnswer::take();
}

FreeStepAnswer PocketMillingJudge::take_down(const Motion& motion) {
  const Number& to = motion.to()[axes_.d];
  const bool is_last = is_point() && is_floor(to) && !floor_done_;
  const Number lowest = min(cleared_.everywhere, cleared_.rough);
  const bool cuts = is_last || (to < lowest - tolerances_.tolerance && !is_near_cleared(to));
  arrival_ = motion;
  // SIE-LC75-13: the way down of finishing ends in the air, be the floor as near as the tolerance.
  const bool in_air = to >= item_.reference_plane - tolerances_.tolerance;
  if (item_.finishing && in_air && motion.record.kind == RecordKind::rapid) {
    return take_travel(motion);
  }
  if (!cuts) {
    const FreeStepAnswer travel = take_travel(motion);
    const bool decided = travel.is_decided();
    const bool tries = !floor_done_ && is_floor(to) && is_near_cleared(to);
    if (!decided && tries) start_floor_or_travel(to, motion.to());
    return travel;
  }
  may_be_travel_ = false;
  if (FreeStepAnswer answer = check_plunge(motion); answer.is_decided()) return answer;
  milling_ = true;
  depth_ = to;
  plunge_ = own(motion.to());
  return FreeStepAnswer::take();
}

// SIE-LC75-04: every infeed is at the centre with R122. SIE-LC75-11: of finishing the last.
FreeStepAnswer PocketMillingJudge::check_plunge(const Motion& motion) const {
  const reference::ClauseId clause = item_.finishing ? "SIE-LC75-11"_clause : "SIE-LC75-04"_clause;
  if (motion.record.kind == RecordKind::rapid) {
    const bool in_air = motion.to()[axes_.d] >= item_.reference_plane - tolerances_.tolerance;
    return departs(VerdictKind::fail_region, clause, motion,
                   in_air ? "The tool traverses where the infeed is due."
                          : "The tool traverses into the part.");
  }
  const Position& off = above_centre(motion.to()) ? motion.from : motion.to();
  if (motion.record.kind != RecordKind::feed || !above_centre(off)) {
    return departs(VerdictKind::fail_geometry, clause, motion,
                   "The infeed is not at the centre of the pocket.",
                   from_centre(off, off[axes_.d]));
  }
  if (!has_feed(motion, item_.depth_feed)) {
    return departs(VerdictKind::fail_feed, clause, motion,
                   "The feed of the infeed differs." +
                       feed_in_place_of(motion.record, item_.depth_feed, item_.feed_mode));
  }
  return FreeStepAnswer::take();
}

FreeStepAnswer PocketMillingJudge::check_level_depth(const Motion& motion) {
  if (!admits_depth(depth_)) return wrong_depth(motion);
  if (!item_.finishing || !is_floor(depth_)) return FreeStepAnswer::take();
  const FreeStepAnswer answer =
      arrival_ ? check_plunge(*arrival_)
               : departs(VerdictKind::fail_geometry, "SIE-LC75-11"_clause, motion,
                         "The last level has no infeed at the centre.");
  if (!answer.is_decided() || !may_be_above_floor()) return answer;
  taken_above_floor_ = true;
  floor_fault_ = answer.verdict;
  return FreeStepAnswer::take();
}

}  // namespace gonogo::oracle
