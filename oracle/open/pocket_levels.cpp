// SPDX-License-Identifier: GPL-3.0-or-later
//
// PocketMillingJudge's part for levels and places: what a level clears, which depths it may have,
// where the centre is, and what stays inside.

#include "oracle/motion/arc_turns.hpp"
#include "oracle/motion/curve_follower.hpp"
#include "oracle/open/enclosed_places.hpp"
#include "oracle/open/pocket_milling_judge.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/region/gouge.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"
#include "reference/compared.hpp"

namespace gonogo::oracle {

using reference::Levels;
using reference::operator""_clause;

namespace {

std::pair<reference::ClauseId, std::string_view> meaning_of(region::Rule rule) {
  switch (rule) {
    case region::Rule::gouge:
      return {"SIE-LC75-08"_clause, "The tool cuts into the wall of the pocket."};
    case region::Rule::sense:
      return {"SIE-LC75-12"_clause, "The pass along the border goes round the wrong way."};
    default:
      return {"SIE-LC75-10"_clause, "The tool leaves material in the pocket."};
  }
}

}  // namespace

FreeStepAnswer PocketMillingJudge::finish_level(const Motion& next) {
  milling_ = false;
  if (may_be_travel_) return finish_floor_or_travel(next);
  if (motions_.empty()) {
    // An infeed alone: the level is a point, or nothing of it was milled.
    if (FreeStepAnswer depth = check_level_depth(next); depth.is_decided()) return depth;
  }
  if (FreeStepAnswer answer = judge_level(next); answer.is_decided()) return answer;
  close_level();
  return FreeStepAnswer::take();
}

FreeStepAnswer PocketMillingJudge::finish_floor_or_travel(const Motion& next) {
  may_be_travel_ = false;
  const FreeStepAnswer answer = judge_level(next);
  const bool decided = answer.is_decided();
  if (decided && answer.verdict.kind == VerdictKind::oracle_gap) return answer;
  if (!decided && !taken_above_floor_) {
    close_level();
    return FreeStepAnswer::take();
  }
  if (decided) floor_fault_ = answer.verdict;
  taken_above_floor_ = false;
  motions_.clear();
  records_.clear();
  return FreeStepAnswer::take();
}

void PocketMillingJudge::close_level() {
  again_.clear();
  motions_.clear();
  records_.clear();
  const std::optional<Number> place = due_place(depth_);
  next_level_ = (place ? *place : place_of(depth_).value_or(next_level_)) + 1;
  last_depth_ = depth_;
  first_ = false;
  // Below what roughing left a strip opens nothing but itself.
  const Number open = level_at(depth_).cleared ? max(depth_, cleared_.rough) : depth_;
  cleared_.everywhere = min(cleared_.everywhere, open);
  cleared_.rough = min(cleared_.rough, open);
  floor_done_ = floor_done_ || (is_floor(depth_) && !taken_above_floor_);
  taken_above_floor_ = false;
}

region::RectangularLevel PocketMillingJudge::level_at(const Number& depth) const {
  region::RectangularLevel level;
  level.area = area_;
  // SIE-LC75-07, SIE-LC75-10: the strip that roughing left, and at the last level the floor.
  const bool whole =
      !item_.finishing || (is_floor(depth) && !taken_above_floor_ && !item_.contour_only);
  if (!whole) level.cleared = rough_area_;
  level.tool_radius = item_.tool_radius;
  level.sense = item_.sense;
  level.plunge = plunge_;
  level.tolerance = tolerances_.level_tolerance();
  level.slack = slack_;
  level.chord = tolerances_.chord;
  level.open_turns = open_turns(item_.centre, item_.length + item_.width, tolerances_);
  return level;
}

FreeStepAnswer PocketMillingJudge::judge_level(const Motion& next) {
  if (const FreeStepAnswer floor = check_contour_only(next); floor.is_decided()) return floor;
  const region::LevelVerdict answer = region::judge_level(level_at(depth_), motions_);
  if (answer.kind == region::LevelVerdict::Kind::gap)
    return FreeStepAnswer::gap(answer.reason, answer.gap);
  if (answer.kind == region::LevelVerdict::Kind::no_go) {
    FreeStepAnswer fault = level_fault(answer.finding.value(), next.from);
    if (!may_be_above_floor()) return fault;
    floor_fault_ = fault.verdict;
    taken_above_floor_ = true;
    return judge_level(next);
  }
  return FreeStepAnswer::take();
}

// SIE-LC75-07, J-PKT-10
FreeStepAnswer PocketMillingJudge::check_contour_only(const Motion& next) const {
  const std::optional<region::PlanePoint> place =
      floor_cuts_ ? floor_cuts_->milled_place() : std::nullopt;
  if (!place) return FreeStepAnswer::take();
  FreeStepAnswer fault = level_fault({region::Rule::cover, std::nullopt, *place, {}}, next.from);
  fault.verdict.clause = "SIE-LC75-07"_clause;
  fault.verdict.got = record_text(next.record);
  fault.verdict.message = "The floor is milled, where R124 and R125 ask for the contour alone.";
  return fault;
}

FreeStepAnswer PocketMillingJudge::level_fault(const region::Finding& finding,
                                               const Position& at) const {
  const auto [clause, message] = meaning_of(finding.rule);
  const region::PlanePoint place = region::out_of(frame_, finding.witness);
  Position witness = at;
  witness[axes_.p] = place.p;
  witness[axes_.q] = place.q;
  witness[axes_.d] = depth_;
  Verdict verdict = fault_of_step(VerdictKind::fail_region, clause, item_.block, pocket_text(item_),
                                  witness, std::string(message));
  add_finding(verdict, finding, motions_, records_);
  return FreeStepAnswer::decide(std::move(verdict));
}

bool PocketMillingJudge::is_floor(const Number& depth) const {
  return agree(depth, item_.floor, tolerances_.tolerance);
}

bool PocketMillingJudge::may_be_above_floor() const {
  return item_.finishing && !item_.contour_only && !taken_above_floor_ && is_floor(depth_) &&
         depth_ > item_.floor;
}

// Which of the named levels lies at a depth; nothing when none does, or none has a name.
std::optional<Number> PocketMillingJudge::place_of(const Number& depth) const {
  if (item_.levels == Levels::open) return std::nullopt;
  const Number count = item_.level_count();
  if (is_floor(depth)) return count;
  const Number step = item_.top() - item_.depth_of_level(1);
  const Number half = Number(1) / Number(2);
  const Number place = ((item_.top() - depth) / step + half).floor();
  const bool found = place.sign() > 0 && place <= count &&
                     agree(item_.depth_of_level(place), depth, tolerances_.tolerance);
  return found ? std::optional(place) : std::nullopt;
}

// SIE-LC75-06. Finishing may leave out levels that have nothing to clear: those in the air,
// and where there is no strip all but the last. Levels no farther apart than the tolerance are one.
bool PocketMillingJudge::is_due(const Number& place) const {
  if (place <= next_level_) return place == next_level_;
  const Number above = item_.depth_of_level(place - 1);
  if (above >= last_depth_ - tolerances_.tolerance) return true;
  if (!item_.finishing) return false;
  return !has_strip() || above >= item_.reference_plane - tolerances_.tolerance;
}

// The named level that a level at this depth is. Beside the floor it may be the one above it.
std::optional<Number> PocketMillingJudge::due_place(const Number& depth) const {
  const std::optional<Number> place = place_of(depth);
  if (!place || is_due(*place)) return place;
  for (const Number& other : {*place - 1, next_level_}) {
    const bool near = other.sign() > 0 && other < *place &&
                      agree(item_.depth_of_level(other), depth, tolerances_.tolerance);
    if (near && is_due(other)) return other;
  }
  return std::nullopt;
}

bool PocketMillingJudge::admits_depth(const Number& depth) const {
  const Number& tau = tolerances_.tolerance;
  if (depth < item_.floor - tau) return false;
  // Where the tool can only go down, levels leave no trace: it may rise and sink again anywhere.
  if (is_point()) return true;
  // No farther down than the tolerance is no level, unless infeeds are as small: none divides the
  // depth into less than half of R121, except a rest at the floor.
  const bool is_small = item_.infeed <= tau * 2 && depth <= last_depth_ + tau;
  if (depth >= last_depth_ - tau) return is_floor(depth) || is_small;
  // SIE-LC75-11
  if (item_.one_level && first_ && is_floor(depth)) return true;
  if (due_place(depth)) return true;
  if (are_levels_named()) return false;
  if (item_.finishing && !has_strip()) return true;
  return depth >= deepest_infeed() - tau;
}

bool PocketMillingJudge::are_levels_named() const {
  return item_.levels != Levels::open && !item_.one_level;
}

Number PocketMillingJudge::deepest_infeed() const {
  return (first_ ? item_.reference_plane : last_depth_) - item_.infeed;
}

// With the levels that are due, or how deep this one may be.
FreeStepAnswer PocketMillingJudge::wrong_depth(const Motion& motion) const {
  using reference::with_values;
  const Number& tau = tolerances_.tolerance;
  std::string text =
      with_values("The depth of the level is none that the infeed admits. It is {}", {depth_});
  Number due = item_.floor;
  if (depth_ < item_.floor - tau) {
    text += with_values(", below the floor at {}.", {item_.floor});
  } else if (!are_levels_named()) {
    due = max(deepest_infeed(), item_.floor);
    text += with_values("; it may be from {} to {}.", {last_depth_, due});
  } else {
    const Number count = item_.level_count();
    const Number next = min(next_level_, count);
    const Number last = min(next + 2, count);  // of those that are named
    due = item_.depth_of_level(next);
    text += with_values(next == last ? "; due is {}" : "; due are {}", {due});
    for (Number place = next + 1; place <= last; place += 1) {
      text += with_values(", {}", {item_.depth_of_level(place)});
    }
    text += last < count ? ", ..." : ".";
  }
  return departs(VerdictKind::fail_geometry, "SIE-LC75-06"_clause, motion, std::move(text),
                 exact::abs(depth_ - due));
}

bool PocketMillingJudge::is_point() const {
  return max(reach_.core_p, reach_.core_q) + reach_.radius <= tolerances_.tolerance;
}

Number PocketMillingJudge::from_centre(const Position& at, const Number& depth) const try {
  const Number beside =
      max(exact::abs(at[axes_.p] - item_.centre[0]), exact::abs(at[axes_.q] - item_.centre[1]));
  return max(beside, exact::abs(at[axes_.d] - depth));
} catch (const exact::Undecided&) {
  return 0;
}

bool PocketMillingJudge::above_centre(const Position& at) const {
  return agree(at[axes_.p], item_.centre[0], tolerances_.tolerance) &&
         agree(at[axes_.q], item_.centre[1], tolerances_.tolerance);
}

bool PocketMillingJudge::has_feed(const Motion& motion, const Number& feed) const {
  return feeds_agree(feed, item_.feed_mode, motion.record, tolerances_);
}

void PocketMillingJudge::take_slack_of(const Motion& motion) {
  if (has_slack_of_enclosures_) return;
  const Number slack = slack_of_enclosures(motion, axes_);
  has_slack_of_enclosures_ = slack.sign() > 0;
  slack_ += slack;
}

region::PlanePoint PocketMillingJudge::own(const Position& at) const {
  return region::into(frame_, plane_point_near(at, axes_));
}

region::LevelMotion PocketMillingJudge::own(const Motion& motion) const {
  return region::into(frame_, level_motion_near(motion, axes_));
}

std::optional<bool> PocketMillingJudge::stays_in(const Motion& motion,
                                                 const region::RoundedRectangle& area) const {
  region::LevelMotion part = own(motion);
  const bool turns = part.is_arc && !(part.from == part.to && part.from == part.centre);
  const bool is_from_centre = part.from == part.centre;
  const bool is_spiral = turns && (is_from_centre || part.to == part.centre);
  const auto ends_outside = [&](const region::RoundedRectangle& limit) {
    return region::reach_of(part.from, limit).kind == region::Reach::Kind::outside ||
           region::reach_of(part.to, limit).kind == region::Reach::Kind::outside;
  };
  const auto limit = [&](const Number& margin) {
    return region::with_radius(area, area.radius + margin);
  };
  const auto reach = [&](const Number& margin) {
    if (turns) return region::reach_of(region::make_arc(part, {}), limit(margin)).kind;
    return ends_outside(limit(margin)) ? region::Reach::Kind::outside : region::Reach::Kind::inside;
  };
  const Number narrow = tolerances_.tolerance - slack_;
  const Number wide = tolerances_.tolerance + slack_;
  if (is_spiral) {
    if (ends_outside(limit(wide))) return false;
    // It goes no farther than the circle that it comes from or grows to.
    (is_from_centre ? part.from : part.to) = is_from_centre ? part.to : part.from;
    return reach(narrow) == region::Reach::Kind::inside ? std::optional(true) : std::nullopt;
  }
  if (reach(narrow) == region::Reach::Kind::inside) return true;
  if (reach(wide) == region::Reach::Kind::outside) return false;
  return std::nullopt;
}

}  // namespace gonogo::oracle
