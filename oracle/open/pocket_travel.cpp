// SPDX-License-Identifier: GPL-3.0-or-later
//
// PocketMillingJudge's part for what travels: through the air, in what is cleared, and to the end.
#include "oracle/open/pocket_milling_judge.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

// Whether the motion may go where it goes: what is cleared, by this path or by roughing.
FreeStepAnswer PocketMillingJudge::check_travel(const Motion& motion) const {
  const Number& tau = tolerances_.tolerance;
  // R8: no clause leads above R101.
  if (motion.to()[axes_.d] > item_.retract + tau && motion.to()[axes_.d] > motion.from[axes_.d]) {
    return departs(VerdictKind::fail_region, "SIE-LC75-13"_clause, motion,
                   "The tool leaves the cycle's planes: it moves above R101.",
                   motion.to()[axes_.d] - item_.retract);
  }
  const Number lowest = min(motion.from[axes_.d], motion.to()[axes_.d]);
  // What is finished was cleared down to the reference plane: above it is air.
  const Number free =
      item_.finishing ? min(cleared_.everywhere, item_.reference_plane) : cleared_.everywhere;
  const bool above = lowest >= free - tau;
  if (!above && lowest < cleared_.rough - tau) {
    // Up where the tool stands, out of what it has just cut.
    const bool straight_up = motion.from[axes_.d] < motion.to()[axes_.d] &&
                             agree(motion.from[axes_.p], motion.to()[axes_.p], tau) &&
                             agree(motion.from[axes_.q], motion.to()[axes_.q], tau);
    if (straight_up) return FreeStepAnswer::take();
    return departs(VerdictKind::fail_region, "SIE-LC75-13"_clause, motion,
                   "The tool travels where nothing is cleared.");
  }
  if (traverses_on_floor(motion)) {
    return departs(VerdictKind::fail_region, "SIE-LC75-11"_clause, motion,
                   "The tool traverses on the floor of the pocket.");
  }
  const std::optional<bool> inside = stays_in(motion, above ? reach_ : rough_reach_);
  if (!inside)
    return FreeStepAnswer::gap(GapReason::comparison,
                               "A motion is too close to the wall to decide.");
  if (*inside) return FreeStepAnswer::take();
  return departs(
      VerdictKind::fail_region, "SIE-LC75-13"_clause, motion,
      above ? "The tool leaves the pocket." : "The tool travels outside of what is cleared.");
}

// J-PKT-09: whether a traverse ends at the depth of a floor, be it the one that roughing left. Off
// a floor it may begin; on the floor that it has roughed itself the tool may travel.
bool PocketMillingJudge::traverses_on_floor(const Motion& motion) const {
  if (motion.record.kind != RecordKind::rapid) return false;
  const Number& from = motion.from[axes_.d];
  const Number& to = motion.to()[axes_.d];
  const bool leaves = to > from + tolerances_.tolerance;
  const bool in_air = to >= item_.reference_plane - tolerances_.tolerance;
  if (leaves || in_air) return false;
  if (item_.finishing) return to <= item_.rough_floor + tolerances_.tolerance;
  return to < from - tolerances_.tolerance && is_floor(to);
}

// Whether a motion leads past R101 above the centre, behind the cycle. Without line numbers the
// way back is joined with what comes after it.
bool PocketMillingJudge::passes_retract_plane(const Motion& motion) const {
  return floor_done_ && !tolerances_.compare_blocks && above_centre(motion.from) &&
         above_centre(motion.to()) && motion.from[axes_.d] < item_.retract &&
         item_.retract < motion.to()[axes_.d];
}

FreeStepAnswer PocketMillingJudge::take_travel(const Motion& motion) {
  if (is_cut(motion.record.kind)) ++idle_cuts_;
  if (passes_retract_plane(motion)) {
    if (FreeStepAnswer floor = check_contour_only(motion); floor.is_decided()) return floor;
    over_ = true;
    Position here = motion.to();
    here[axes_.d] = item_.retract;
    return FreeStepAnswer::end(here);
  }
  if (const auto answer = check_first(motion); answer.is_decided()) {
    return answer;
  }
  if (FreeStepAnswer answer = check_travel(motion); answer.is_decided()) return answer;
  const bool may_end = floor_done_ && (motion.record.kind == RecordKind::rapid || has_risen_);
  if (!may_end || !above_centre(motion.to())) return FreeStepAnswer::take();
  // SIE-LC75-13: the end is above the centre at R101, whatever the speed of the way there.
  over_ = agree(motion.to()[axes_.d], item_.retract, tolerances_.tolerance);
  return over_ ? check_contour_only(motion) : FreeStepAnswer::take();
}

// R8: in roughing the first infeed follows the approach, at the centre. In finishing
// (SIE-LC75-11) the tool may travel in what roughing left.
FreeStepAnswer PocketMillingJudge::check_first(const Motion& motion) const {
  const bool below = min(motion.from[axes_.d], motion.to()[axes_.d]) < item_.clearance;
  if (item_.finishing || !first_ || milling_ || below) return FreeStepAnswer::take();
  const bool sinks = motion.to()[axes_.d] <= motion.from[axes_.d] + tolerances_.tolerance;
  const bool stays = above_centre(motion.to()) && !goes_round(motion, tolerances_.tolerance);
  if (sinks && stays) return FreeStepAnswer::take();
  return departs(VerdictKind::fail_region, "SIE-LC75-04"_clause, motion,
                 "The tool moves away before the first infeed, where no clause leads it.");
}

}  // namespace gonogo::oracle
