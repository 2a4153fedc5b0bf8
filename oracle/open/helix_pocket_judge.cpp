// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/helix_pocket_judge.hpp"

#include <algorithm>
#include <cstdlib>

#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

namespace {

const Number kHalf = Number(1) / 2;

}  // namespace

HelixPocketJudge::HelixPocketJudge(const reference::HelixPocket& item, const Position& place,
                                   const Tolerances& tolerances)
    : item_(item),
      place_(place),
      tolerances_(tolerances),
      axes_(reference::axes_of(item.plane)),
      shape_(helix_of(item, "GSK-G112-05"_clause, item.radius, item.turns)) {}

reference::ClauseId HelixPocketJudge::clause() const {
  switch (phase_) {
    case Phase::entry:
      return "GSK-G112-04"_clause;
    case Phase::helix:
    case Phase::flat:
      return "GSK-G112-05"_clause;
    default:
      return "GSK-G112-06"_clause;
  }
}

bool HelixPocketJudge::complete() const {
  return phase_ == Phase::over || (phase_ == Phase::exit && semicircle_is_unseen());
}

std::optional<Verdict> HelixPocketJudge::end(const Position& here) {
  if (complete()) return std::nullopt;
  return incomplete(here);
}

// Above the centre, as before it.
FreeStep::Exit HelixPocketJudge::exit(const Position& /*here*/) const {
  Position at = place_;
  at[axes_.d] = item_.bottom;
  return {at};
}

// The traverse to where the pocket begins.
bool HelixPocketJudge::is_before(const Motion& motion) const {
  return phase_ == Phase::entry && entry_.empty() && open_.empty() &&
         motion.record.kind == RecordKind::rapid && motion.to()[axes_.d] == motion.from[axes_.d];
}

// A semicircle of this diameter stays where it is, as far as can be seen: rounded, it may be an arc
// that ends on its own centre; as the way back it may be left out.
bool HelixPocketJudge::semicircle_is_unseen() const {
  return item_.radius <= tolerances_.tolerance;
}

// Whether a cut may be such a semicircle or a piece of it: all of it lies near the centre.
bool HelixPocketJudge::stays_at_centre(const Motion& motion) const {
  const Number& tau = tolerances_.tolerance;
  const auto near = [&](const Number& p, const Number& q, const Number& within) {
    return agree(p, item_.centre[0], within) && agree(q, item_.centre[1], within);
  };
  const Record& record = motion.record;
  if (record.kind == RecordKind::arc && (record.plane != item_.plane || std::abs(record.rot) != 1 ||
                                         !near(record.centre[0], record.centre[1], tau * 2))) {
    return false;
  }
  return is_cut(record.kind) && feeds_agree(item_.feed, item_.feed_mode, record, tolerances_) &&
         agree(motion.from[axes_.d], motion.to()[axes_.d], tau) &&
         near(motion.from[axes_.p], motion.from[axes_.q], tau) &&
         near(motion.to()[axes_.p], motion.to()[axes_.q], tau);
}

Verdict HelixPocketJudge::incomplete(const Position& position) const {
  if (phase_ == Phase::helix && last_) return helix_ended();
  return fault_of_step(VerdictKind::fail_geometry, clause(), item_.block, helix_text(item_),
                       position, "The pocket is not milled to its end.");
}

FreeStepAnswer HelixPocketJudge::departs(const MatchResult& result, const Motion& motion) const {
  if (result.departure == Departure::undecided)
    return FreeStepAnswer::gap(result.gap, result.reason);
  if (result.departure == Departure::feed) {
    return FreeStepAnswer::decide(departure_from(
        VerdictKind::fail_feed, "GSK-G112-08"_clause, item_.block, motion, helix_text(item_),
        "The feed of the pocket differs." +
            feed_in_place_of(motion.record, item_.feed, item_.feed_mode)));
  }
  Verdict verdict = departure_from(VerdictKind::fail_geometry, clause(), item_.block, motion,
                                   helix_text(item_), result.reason);
  if (result.departure == Departure::kind) verdict.rule = RelationRule::label;
  if (match_) {
    verdict.want = record_text(want_.record);
    set_deviation(verdict, largest_difference(motion.to(), want_.to()));
  }
  return FreeStepAnswer::decide(std::move(verdict));
}

FreeStepAnswer HelixPocketJudge::take(const Motion& motion) {
  if (phase_ == Phase::over) return FreeStepAnswer::end(motion.from);
  if (tolerances_.compare_blocks && motion.record.block != item_.block) {
    return FreeStepAnswer::decide(incomplete(motion.from));
  }
  if (turns_rotary_axis(place_, motion.to(), tolerances_.tolerance)) {
    return departs({Departure::geometry, false, "A rotary axis moves in a pocket."}, motion);
  }
  FreeStepAnswer answer = phase_ == Phase::entry   ? take_entry(motion)
                          : phase_ == Phase::helix ? take_helix(motion)
                                                   : take_at_bottom(motion);
  if (answer.kind == FreeStepAnswer::Kind::taken) last_ = motion;
  return answer;
}

Motion HelixPocketJudge::semicircle(const Position& from, const Position& to) const {
  Motion arc;
  arc.from = from;
  arc.record.kind = RecordKind::arc;
  arc.record.plane = item_.plane;
  arc.record.block = tolerances_.compare_blocks ? item_.block : 0;
  arc.record.clause = clause();
  arc.record.rot = item_.sense;
  arc.record.feed = item_.feed;
  arc.record.feed_mode = item_.feed_mode;
  arc.record.axes = {axes_.p, axes_.q};
  arc.record.to = to;
  arc.record.centre = {(from[axes_.p] + to[axes_.p]) / 2, (from[axes_.q] + to[axes_.q]) / 2};
  return arc;
}

// Its centre follows from a point that is known within the tolerance only.
OpenArc HelixPocketJudge::open_semicircle(const OpenStart& starts) const {
  OpenArc open;
  open.starts = &starts;
  open.origin = {item_.centre[0], item_.centre[1]};
  open.centre = {kHalf, 0};
  open.radius = item_.radius / 2;
  open.slack = tolerances_.tolerance / 2;
  return open;
}

MatchResult HelixPocketJudge::match_entry(OpenStart& starts) const {
  if (semicircle_is_unseen() &&
      std::ranges::all_of(entry_, [&](const Motion& motion) { return stays_at_centre(motion); })) {
    return {Departure::none, true, {}};
  }
  Position centre = entry_.back().to();
  centre[axes_.p] = item_.centre[0];
  centre[axes_.q] = item_.centre[1];
  centre[axes_.d] = item_.r_plane;
  Position end = entry_.back().to();
  end[axes_.d] = item_.r_plane;
  const Motion want = semicircle(centre, end);
  CurveFollower match(want, tolerances_, open_semicircle(starts));
  MatchResult result;
  for (const Motion& motion : entry_) {
    result = match.match(motion);
    if (result.departure != Departure::none) return result;
    if (motion.record.kind != RecordKind::arc) continue;
    starts.narrow({kHalf, 0}, {motion.record.centre[0] - item_.centre[0],
                               motion.record.centre[1] - item_.centre[1]});
  }
  if (!result.done) return {Departure::geometry, false, "The entry is not a semicircle."};
  return result;
}

FreeStepAnswer HelixPocketJudge::take_entry(const Motion& motion) {
  const MatchResult result = open_.match(motion);
  if (result.done) return end_helix(motion);
  const bool begun = !open_.empty() || result.departure != Departure::none;
  if (!agree(motion.to()[axes_.d], item_.r_plane, tolerances_.tolerance)) {
    if (!begun) return wrong_entry(motion);
    phase_ = Phase::helix;
    return open_.empty() ? departs(result, motion) : FreeStepAnswer{};
  }
  if (!is_cut(motion.record.kind)) return wrong_entry(motion);
  if (entry_.size() >= kMostMotions) {
    return FreeStepAnswer::gap(GapReason::cap_level,
                               "An entry of more than 50,000 motions is not judged.");
  }
  entry_.push_back(motion);
  OpenStart starts(item_.radius, tolerances_.tolerance);
  if (!starts.narrow({}, shape_.from_axis(motion.to()))) return {};
  MatchResult entry = match_entry(starts);
  if (entry.departure != Departure::none) {
    if (!entry_fault_) entry_fault_ = {std::move(entry), motion};
    return {};
  }
  if (!open_.add(shape_, std::move(starts), motion.to(), tolerances_)) {
    return FreeStepAnswer::gap(GapReason::cap_ways, "The helix may have begun at too many points.");
  }
  return {};
}

// No motion so far has ended a semicircle, and this one does not go on at the R plane.
FreeStepAnswer HelixPocketJudge::wrong_entry(const Motion& motion) const {
  if (entry_fault_) return departs(entry_fault_->first, entry_fault_->second);
  return departs({Departure::geometry, false,
                  "The entry is no semicircle at the R plane to the circle of the helix."},
                 entry_.empty() ? motion : entry_.back());
}

FreeStepAnswer HelixPocketJudge::take_helix(const Motion& motion) {
  const MatchResult result = open_.match(motion);
  if (result.done) return end_helix(motion);
  if (result.departure == Departure::none) return {};
  const bool goes_down = is_cut(motion.record.kind) && motion.to()[axes_.d] < motion.from[axes_.d];
  const bool at_bottom = agree(motion.from[axes_.d], item_.bottom, tolerances_.tolerance);
  if (result.departure == Departure::undecided || (goes_down && !at_bottom) || !last_) {
    return departs(result, motion);
  }
  return FreeStepAnswer::decide(helix_ended());
}

// J-CMP-12: what follows shows that it has, with the last motion that was taken.
Verdict HelixPocketJudge::helix_ended() const {
  const bool at_bottom = agree(last_->to()[axes_.d], item_.bottom, tolerances_.tolerance);
  return open_.farthest().ended(
      clause(), *last_, helix_text(item_),
      at_bottom ? "The helix ends beside the place that its whole turns lead to."
                : "The helix ends before the bottom of the pocket.",
      tolerances_);
}

// J-CMP-12: of a circle or a semicircle at the bottom that has begun, where something comes that is
// none of its pieces.
std::optional<Verdict> HelixPocketJudge::ended_short(const Motion& next) const {
  const bool is_piece =
      is_cut(next.record.kind) && agree(next.to()[axes_.d], item_.bottom, tolerances_.tolerance);
  if (is_piece || !is_begun_) return std::nullopt;
  return ended_elsewhere(clause(), item_.block, *last_, want_.to(), record_text(want_.record),
                         "The cut ends before it is where it has to end.");
}

FreeStepAnswer HelixPocketJudge::end_helix(const Motion& motion) {
  helix_ = open_.take_done();
  helix_end_ = motion.to();
  entry_.clear();
  prepare_bottom(item_.flat ? Phase::flat : Phase::exit);
  return {};
}

void HelixPocketJudge::prepare_bottom(Phase phase) {
  phase_ = phase;
  is_begun_ = false;
  Position from = helix_end_;
  from[axes_.d] = item_.bottom;
  Position to = from;
  OpenArc open = open_semicircle(helix_.front().starts());
  if (phase == Phase::exit) {
    to[axes_.p] = item_.centre[0];
    to[axes_.q] = item_.centre[1];
    open.end = {0, 0};
  }
  want_ = semicircle(from, to);
  if (phase == Phase::flat) {
    want_.record.centre = item_.centre;
    open.centre = {0, 0};
    open.radius = item_.radius;
    open.slack = 0;
  }
  match_.emplace(want_, tolerances_, open);
}

// What is left of a helix or circle that ended within the tolerance of its end: to a place that may
// be that end, too (R2, R8).
bool HelixPocketJudge::is_remainder(const Motion& motion) const {
  return is_cut(motion.record.kind) && !nearly_full_turn(motion) &&
         agree(motion.from, want_.from, tolerances_.tolerance * 2) &&
         agree(motion.to(), want_.from, tolerances_.tolerance * 2) &&
         agree(motion.to()[axes_.d], item_.bottom, tolerances_.tolerance) &&
         helix_.front().starts().admits(shape_.to_end, shape_.from_axis(motion.to()));
}

FreeStepAnswer HelixPocketJudge::take_at_bottom(const Motion& motion) {
  const MatchResult result = match_->match(motion);
  if (result.departure == Departure::none) {
    is_begun_ = true;
    if (!result.done) return {};
    if (phase_ == Phase::flat) {
      prepare_bottom(Phase::exit);
    } else {
      phase_ = Phase::over;
    }
    return {};
  }
  if (phase_ == Phase::exit && semicircle_is_unseen()) {
    if (stays_at_centre(motion)) return {};
    if (!is_cut(motion.record.kind)) {
      phase_ = Phase::over;
      return FreeStepAnswer::end(motion.from);
    }
  }
  if (is_remainder(motion)) return {};
  if (result.departure != Departure::undecided) {
    if (auto verdict = ended_short(motion)) return FreeStepAnswer::decide(*std::move(verdict));
  }
  return departs(result, motion);
}

}  // namespace gonogo::oracle
