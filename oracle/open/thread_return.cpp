// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the way from the run-out to the R plane, to the safe position, and home
// (J-THR-06, J-THR-09).
#include "oracle/open/thread_judge.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

namespace {

FreeStepAnswer untold_end() {
  return FreeStepAnswer::gap(
      GapReason::two_readings,
      "Without block numbers nothing shows where the motions of the thread end, because the "
      "tool stands at the initial plane already.");
}

}  // namespace

// J-THR-06: along d alone from where the run-out ended; GSK-G114-10: with J >= t_n that keeps off
// the material.
FreeStepAnswer ThreadJudge::take_way_back(const Motion& motion) {
  if (!is_below(motion.from) && !is_below(motion.to()) && !geometry_.is_above(motion.to())) {
    // So shallow that the way back was too small to see.
    phase_ = Phase::away;
    return take_away(motion);
  }
  const bool same_place =
      agree(motion.to()[axes_.p], run_out_end_[axes_.p], tolerances_.tolerance) &&
      agree(motion.to()[axes_.q], run_out_end_[axes_.q], tolerances_.tolerance);
  const bool falls = is_falling(motion);
  if (!same_place || falls || motion.record.kind == RecordKind::arc) return wrong_way_back(motion);
  const Clearance clear = geometry_.clearance(motion, radius_kept());
  if (clear.kind != Clearance::Kind::clear) {
    return touching(clear, "GSK-G114-10"_clause, motion,
                    "The way back to the R plane goes through the part.");
  }
  if (is_named() && motion.record.kind != RecordKind::rapid) return wrong_way_back(motion);
  highest_ = max(highest_, height(motion.to()));
  if (is_below(motion.to())) return {};
  if (geometry_.is_above(motion.to())) return rise_beyond(motion);
  phase_ = Phase::away;
  return {};
}

// The return to the R plane and the traverse to the initial plane in one: right where the tool
// stands at a safe position already.
FreeStepAnswer ThreadJudge::rise_beyond(const Motion& motion) {
  phase_ = Phase::away;
  Position here = motion.from;
  here[axes_.d] = item_.r_plane;
  position_ = here;
  const bool to_initial = agree(motion.to()[axes_.d], item_.initial_plane, tolerances_.tolerance) ||
                          !tolerances_.compare_blocks;
  if (complete() && to_initial) return FreeStepAnswer::end(here);
  return not_away(motion);
}

// Whether the way along p comes by a safe position: outwards from a bolt, across the axis of a
// bore.
bool ThreadJudge::passes_safety(const Motion& motion, bool is_clear) const {
  if (item_.external) return is_clear;
  const Number from = geometry_.from_axis(motion.from).p;
  const Number to = geometry_.from_axis(motion.to()).p;
  return is_safe(motion.to()) || from.sign() * to.sign() < 0;
}

// J-THR-06: along p alone, clear of the part, until the tool is at a safe position.
FreeStepAnswer ThreadJudge::take_away(const Motion& motion) {
  if (is_named()) return take_named(motion);
  const Number& tau = tolerances_.tolerance;
  const bool safe = is_safe(position_);  // infeed may follow that is too small to see
  const bool last = pass_ == passes_;
  const bool in_plane = !is_below(motion.to()) && !geometry_.is_above(motion.to());
  if (in_plane && agree(motion.from, motion.to(), tau) && !nearly_full_turn(motion)) {
    return wait();
  }
  const Number way = motion.to()[axes_.p] - motion.from[axes_.p];
  const bool goes_on = in_plane && geometry_.moves_first_axis_alone(motion) &&
                       agree(motion.to()[axes_.q], run_out_end_[axes_.q], tau * 2) &&
                       way.sign() * away_direction_ >= 0 &&
                       (!safe || motion.record.kind == RecordKind::rapid);
  if (goes_on) {
    away_direction_ = way.sign();
    const Clearance clear = geometry_.clearance(motion, radius_kept());
    const bool is_clear = clear.kind == Clearance::Kind::clear;
    const bool is_far = geometry_.is_beyond_reach(motion.to());
    if (is_clear && !is_far) return {};
    if (last && (safe || passes_safety(motion, is_clear)) && is_end_untold()) return untold_end();
    if (is_clear) return not_away(motion);
    return touching(clear, "GSK-G114-10"_clause, motion,
                    "The way to the safe position goes through the part.");
  }
  if (!safe) return not_away(motion);
  if (last) return take_after_last(motion);
  pass_ += 1;
  begin_pass(position_);
  return take_entry(motion);
}

// J-THR-09. Without block numbers, where the R plane is the initial one.
bool ThreadJudge::is_end_untold() const {
  return !tolerances_.compare_blocks &&
         agree(item_.r_plane, item_.initial_plane, tolerances_.tolerance);
}

// J-THR-09. After the last pass the tool returns along d to the initial plane.
FreeStepAnswer ThreadJudge::take_after_last(const Motion& motion) {
  const Number& tau = tolerances_.tolerance;
  const bool at_initial = agree(item_.r_plane, item_.initial_plane, tau);
  // GSK-G114-07. The initial plane may lie below the R plane (gsk.thread.direction = free).
  const bool rises = height(motion.to()) - height(motion.from) > tau;
  // Without block numbers the next block's traverse may be joined to the return.
  const bool to_initial = agree(motion.to()[axes_.d], item_.initial_plane, tau) ||
                          (!tolerances_.compare_blocks && rises);
  // In pieces, of which one was dropped, the last may be no motion that is seen.
  const bool is_small = agree(motion.from, motion.to(), tau);
  if ((geometry_.moves_depth_alone(motion) || is_small) && to_initial && !at_initial) {
    return FreeStepAnswer::end(motion.from);
  }
  if (is_below(motion.to())) {
    if (is_end_untold()) return FreeStepAnswer::end(motion.from);
    return fault(VerdictKind::fail_geometry, "GSK-G114-04"_clause, motion,
                 "The tool goes below the R plane again after the last pass.");
  }
  if (is_end_untold()) return untold_end();
  if (is_cut(motion.record.kind) && !geometry_.is_above(motion.to())) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-04"_clause, motion,
                 "The tool goes in again after the last pass.");
  }
  return fault(VerdictKind::fail_geometry, "GSK-G114-07"_clause, motion,
               "After the last pass the tool leaves its safe position otherwise than by a traverse "
               "along the depth axis to the initial plane.");
}

}  // namespace gonogo::oracle
