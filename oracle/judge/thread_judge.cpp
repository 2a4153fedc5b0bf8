// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/thread_judge.hpp"

#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {

using reference::ThreadRunOut;
using reference::operator""_clause;

ThreadJudge::ThreadJudge(const reference::ThreadMilling& item, const Position& start,
                         const JudgeTerms& terms)
    : item_(item),
      terms_(terms),
      loose_(terms),
      axes_(reference::axes_of(item.plane)),
      up_(item.r_plane < item.bottom ? -1 : 1),
      passes_(item.passes()),
      turns_(reference::gsk988ta::turns_of(item)),
      position_(start) {
  open_.emplace();
  // The end of the helix may be off by the tolerance at either of the points that fix it.
  loose_.tolerance = terms.tolerance * 3;
  to_end_ = turn_by((turns_ - turns_.floor()) * 360 * item.sense);
  if (item.arc_path) step_ = Step::entry;
}

// A thread so shallow that the way back to the R plane is too small to see.
bool ThreadJudge::is_back_unseen() const {
  if (phase_ != Phase::run_out || pass_ != passes_ || item_.arc_path || is_below(position_)) {
    return false;
  }
  if (!has_run_out_end()) return true;
  return helix_.front().starts().admits(run_out_map(), from_axis(position_));
}

bool ThreadJudge::complete() const {
  if (is_back_unseen()) return true;
  if (phase_ != Phase::above || pass_ <= passes_) return false;
  if (step_ != Step::away) return true;
  const Number safe = reference::gsk988ta::safe_radius(item_);
  return agree(position_[axes_.p], item_.centre[0] + safe, terms_.tolerance);
}

PlaneVector ThreadJudge::from_axis(const Position& at) const {
  return {at[axes_.p] - item_.centre[0], at[axes_.q] - item_.centre[1]};
}

bool ThreadJudge::on_circle(const Position& at, const Number& radius) const {
  return TurnedStart(radius, terms_.tolerance).admits({}, from_axis(at));
}

bool ThreadJudge::moves_depth_alone(const Motion& motion) const {
  return moved_axes(motion, terms_.tolerance) == AxisSet{axes_.d};
}

// Lines and arcs of the thread's plane move evenly along d, and a traverse within its box.
ThreadJudge::Side ThreadJudge::side_of(const Motion& motion) const {
  if (is_below(motion.from) || is_below(motion.to())) return Side::below;
  if (motion.record.kind != RecordKind::arc || motion.record.plane == item_.plane) {
    return Side::above;
  }
  const reference::PlaneAxes axes = reference::axes_of(motion.record.plane);
  const PlaneVector a = from_centre(motion.record, motion.from);
  const PlaneVector b = from_centre(motion.record, motion.to());
  const Number reach_2 = max(a.p * a.p + a.q * a.q, b.p * b.p + b.q * b.q);
  const std::size_t place = axes.p == axes_.d ? 0 : 1;
  const Number room = (motion.record.centre[place] - item_.r_plane) * up_ + terms_.tolerance;
  return room.sign() >= 0 && reach_2 <= room * room ? Side::above : Side::unknown;
}

OpenPathAnswer ThreadJudge::take(const Motion& motion) {
  if (passes_ > 1 && agree(item_.r_plane, item_.bottom, terms_.tolerance)) {
    return OpenPathAnswer::gap(
        "The passes of a thread that is no deeper than the tolerance cannot be told apart.");
  }
  if (terms_.compare_blocks && motion.record.block != item_.block) {
    if (complete()) return OpenPathAnswer::end(motion.from);
    return OpenPathAnswer::decide(incomplete(motion.from));
  }
  if (turns_rotary_axis(motion, terms_.tolerance)) {
    return fault(VerdictKind::fail_geometry, item_.clause, motion,
                 "A rotary axis moves in a thread.");
  }
  if (motion.record.kind == RecordKind::thread) {
    return fault(VerdictKind::fail_geometry, item_.clause, motion,
                 "A feed bound to the spindle has no place in thread milling.");
  }
  if (motion.record.kind == RecordKind::arc3) {
    return OpenPathAnswer::gap("An arc through a point is not judged in a thread.");
  }
  OpenPathAnswer answer = take_in_phase(motion);
  if (answer.kind != OpenPathAnswer::Kind::taken) return answer;
  Record feed;
  feed.feed = item_.feed;
  feed.feed_mode = item_.feed_mode;
  if (is_cut(motion.record.kind) && !feeds_agree(feed, motion.record, terms_)) {
    return fault(VerdictKind::fail_feed, "GSK-G114-08"_clause, motion,
                 "The feed of the thread differs.");
  }
  position_ = motion.to();
  return answer;
}

OpenPathAnswer ThreadJudge::take_in_phase(const Motion& motion) {
  switch (phase_) {
    case Phase::above:
      return take_above(motion);
    case Phase::helix:
      return take_helix(motion);
    case Phase::run_out:
      return take_run_out(motion);
    case Phase::way_back:
      return take_way_back(motion);
  }
  return {};
}

OpenPathAnswer ThreadJudge::take_above(const Motion& motion) {
  if (item_.arc_path && step_ != Step::helix) return take_named(motion);
  const Side side = side_of(motion);
  if (side == Side::unknown) {
    return OpenPathAnswer::gap("An arc across the thread's plane comes near the R plane.");
  }
  if (pass_ > passes_) return take_after_last(motion, side);
  const MatchResult result = match_helix(motion);
  if (phase_ == Phase::run_out) return {};
  if (side == Side::above && !(item_.arc_path && open_->empty())) return {};
  if (open_->empty()) return no_helix(motion, result);
  phase_ = Phase::helix;
  return {};
}

// After the last pass the tool may still move to a safe position; then it returns along d.
OpenPathAnswer ThreadJudge::take_after_last(const Motion& motion, Side side) {
  const Number& tau = terms_.tolerance;
  const bool at_initial = agree(item_.r_plane, item_.initial_plane, tau);
  // GSK-G114-07. The initial plane may lie below the R plane (gsk.thread.direction = free).
  const bool rises = height(motion.to()) - height(motion.from) > tau;
  // Without block numbers the next block's traverse may be joined to the return.
  const bool to_initial =
      agree(motion.to()[axes_.d], item_.initial_plane, tau) || (!terms_.compare_blocks && rises);
  if (moves_depth_alone(motion) && to_initial && !at_initial) {
    return OpenPathAnswer::end(motion.from);
  }
  if (side == Side::below) {
    if (at_initial && !terms_.compare_blocks) return OpenPathAnswer::end(motion.from);
    return fault(VerdictKind::fail_geometry, "GSK-G114-04"_clause, motion,
                 "The tool goes below the R plane again after the last pass.");
  }
  if (terms_.compare_blocks && !agree(motion.from[axes_.d], motion.to()[axes_.d], tau)) {
    return fault(
        VerdictKind::fail_geometry, "GSK-G114-07"_clause, motion,
        "After the last pass the tool leaves the R plane otherwise than by a traverse along "
        "the depth axis to the initial plane.");
  }
  if (!terms_.compare_blocks && agree(motion.from[axes_.d], item_.initial_plane, tau)) {
    return OpenPathAnswer::gap(
        "Without block numbers it cannot be told where the motions of the thread end, because the "
        "tool stands at the initial plane already.");
  }
  return {};
}

HelixShape ThreadJudge::shape() const {
  HelixShape helix;
  helix.block = item_.block;
  helix.clause = item_.clause;
  helix.plane = item_.plane;
  helix.centre = item_.centre;
  helix.radius = radius();
  helix.top = item_.r_plane;
  helix.bottom = item_.bottom;
  helix.turns = turns_;
  helix.sense = item_.sense;
  helix.feed = item_.feed;
  helix.feed_mode = item_.feed_mode;
  helix.to_end = to_end_;
  return helix;
}

MatchResult ThreadJudge::match_helix(const Motion& motion) {
  if (phase_ == Phase::above) {
    const HelixShape helix = shape();
    if (std::optional<TurnedStart> starts = starts_of_helix(helix, motion, terms_)) {
      const bool named = !item_.arc_path || starts->narrow({}, {helix.radius, 0});
      if (named && !open_->add(helix, *std::move(starts), motion.from, terms_)) {
        return {Departure::undecided, false, "The helix may have begun at too many points."};
      }
    }
  }
  MatchResult result = open_->match(motion);
  if (result.done) {
    helix_ = open_->take_done();
    open_.emplace();
    helix_end_ = motion.to();
    line_.reset();
    ran_out_ = false;
    phase_ = Phase::run_out;
  }
  return result;
}

OpenPathAnswer ThreadJudge::take_helix(const Motion& motion) {
  const MatchResult result = match_helix(motion);
  if (result.departure == Departure::none) return {};
  return no_helix(motion, result);
}

// GSK-G114-10: with J >= t_n all of it keeps off the material, else off what is deeper than r_n.
OpenPathAnswer ThreadJudge::take_way_back(const Motion& motion) {
  if (!is_below(motion.from) && !is_below(motion.to())) {
    // The thread is so shallow that the way back was too small to see.
    begin_next_pass();
    return take_above(motion);
  }
  if ((motion.to()[axes_.d] - item_.bottom) * up_ < -terms_.tolerance) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion,
                 "The tool goes below the bottom of the thread.");
  }
  const bool promised = item_.runout_length >= item_.depth_of_pass(pass_);
  const Clearance clear = clearance(motion, promised ? item_.start_radius : radius(), true);
  if (clear.kind != Clearance::Kind::clear) {
    const bool cuts = motion.record.kind == RecordKind::arc &&
                      (motion.record.rot < 0) == (item_.sense < 0) &&
                      agree(motion.record.centre[0], item_.centre[0], terms_.tolerance) &&
                      agree(motion.record.centre[1], item_.centre[1], terms_.tolerance);
    if (cuts) {
      return touching(clear, "GSK-G114-06"_clause, motion,
                      "The tool cuts again before it has returned to the R plane.");
    }
    if (promised && clear.kind == Clearance::Kind::touches && reading_ends_in_material()) {
      return OpenPathAnswer::gap("The run-out of the reading ends in the material.");
    }
    const bool may_run_out = phase_ == Phase::run_out && item_.runout == ThreadRunOut::open &&
                             is_cut(motion.record.kind) &&
                             clearance(motion, radius(), true).kind == Clearance::Kind::clear;
    if (may_run_out) {
      return OpenPathAnswer::gap("A run-out that rises along the depth axis is not judged.");
    }
    return touching(clear, "GSK-G114-10"_clause, motion,
                    motion.record.kind == RecordKind::rapid
                        ? "A traverse below the R plane goes through the part."
                        : "The tool touches the part on its way back to the R plane.");
  }
  if (item_.arc_path && !(motion.record.kind == RecordKind::rapid && moves_depth_alone(motion))) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion,
                 "The tool does not return to the R plane by a traverse along the depth axis.");
  }
  return is_below(motion.to()) ? OpenPathAnswer{} : end_pass(motion);
}

void ThreadJudge::begin_next_pass() {
  phase_ = Phase::above;
  pass_ += 1;
  if (item_.arc_path) step_ = Step::away;
}

OpenPathAnswer ThreadJudge::end_pass(const Motion& motion) {
  const Number& tau = terms_.tolerance;
  begin_next_pass();
  const bool beyond = height(motion.to()) > tau;
  if (!beyond) return {};
  if (!moves_depth_alone(motion)) {
    if (pass_ <= passes_) return {};
    return fault(VerdictKind::fail_geometry, "GSK-G114-07"_clause, motion,
                 "After the last pass the tool does not return along the depth axis.");
  }
  // The return to the R plane and the traverse to the initial plane in one.
  Position here = motion.from;
  here[axes_.d] = item_.r_plane;
  position_ = here;
  const bool to_initial =
      agree(motion.to()[axes_.d], item_.initial_plane, tau) || !terms_.compare_blocks;
  if (complete() && to_initial) return OpenPathAnswer::end(here);
  if (!item_.arc_path && pass_ <= passes_) return {};
  return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion,
               "The tool goes beyond the R plane.");
}

}  // namespace gonogo::oracle
