// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the evidence: what keeps clear of the part, and which word of a helix is
// wrong.
#include <cmath>

#include "oracle/motion/approximate.hpp"
#include "oracle/open/thread_judge.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

FreeStepAnswer ThreadJudge::fault(VerdictKind kind, reference::ClauseId clause,
                                  const Motion& motion, std::string message,
                                  const Number& off) const {
  Verdict verdict =
      departure_from(kind, clause, item_.block, motion, want_text(), std::move(message));
  set_deviation(verdict, off);
  return FreeStepAnswer::decide(std::move(verdict));
}

FreeStepAnswer ThreadJudge::wrong_feed(const Motion& motion) const {
  return fault(VerdictKind::fail_feed, "GSK-G114-08"_clause, motion,
               "The feed of the thread differs." +
                   feed_in_place_of(motion.record, item_.feed, item_.feed_mode));
}

std::string ThreadJudge::want_text() const {
  const bool over = pass_ > passes_;
  return thread_text(item_, over ? passes_ : pass_);
}

Verdict ThreadJudge::incomplete(const Position& position) const {
  if (phase_ == Phase::helix) return helix_ended();
  Verdict verdict = fault_of_step(VerdictKind::fail_geometry, "GSK-G114-06"_clause, item_.block,
                                  want_text(), position, {});
  switch (phase_) {
    case Phase::run_out:
    case Phase::way_back:
      verdict.message = "The tool does not return to the R plane after a pass.";
      break;
    case Phase::away:
      if (pass_ == passes_) {
        verdict.message = "The tool does not go to the safe position after the last pass.";
        break;
      }
      [[fallthrough]];
    default:
      verdict.clause = "GSK-G114-04"_clause;
      verdict.message = "A pass of the thread is missing.";
      break;
  }
  return verdict;
}

// J-CMP-12: what follows shows that it has, with the last motion that was taken.
Verdict ThreadJudge::helix_ended() const {
  const bool at_bottom = agree(last_->to()[axes_.d], item_.bottom, tolerances_.tolerance);
  return open_->farthest().ended("GSK-G114-06"_clause, *last_, want_text(),
                                 at_bottom
                                     ? "The helix ends beside the place that its turns lead to."
                                     : "The helix ends before the bottom of the thread.",
                                 tolerances_);
}

FreeStepAnswer ThreadJudge::touching(const Clearance& clear, reference::ClauseId clause,
                                     const Motion& motion, std::string message) const {
  if (clear.kind == Clearance::Kind::undecided) {
    return FreeStepAnswer::gap(GapReason::comparison,
                               "Whether an arc below the R plane clears the part is not decided.");
  }
  FreeStepAnswer answer =
      fault(VerdictKind::fail_geometry, clause, motion, std::move(message), clear.deviation);
  Position witness = geometry_.place(clear.witness, motion.from);
  // On a sloping line the depth goes with the way in the plane.
  const PlaneVector from = near_rational(geometry_.from_axis(motion.from));
  const PlaneVector along = near_rational(geometry_.from_axis(motion.to())) - from;
  const Number length_2 = norm_squared(along);
  if (motion.record.kind == RecordKind::feed && length_2.sign() != 0) {
    const Number part = dot(clear.witness - from, along) / length_2;
    witness[axes_.d] += part * (motion.to()[axes_.d] - motion.from[axes_.d]);
  }
  answer.verdict.witness = point_text(witness, {Axis::x, Axis::y, Axis::z});
  return answer;
}

// A motion below the R plane where the helix of the pass is due, or one that leaves it. The first
// of radius, plane, centre, sense, start, lead, turns, depth and feed that is wrong gives the name.
FreeStepAnswer ThreadJudge::no_helix(const Motion& motion, const MatchResult& result) const {
  constexpr VerdictKind kGeometry = VerdictKind::fail_geometry;
  const reference::ClauseId clause = "GSK-G114-06"_clause;
  if (result.departure == Departure::undecided)
    return FreeStepAnswer::gap(result.gap, result.reason);
  if (result.departure == Departure::feed) return wrong_feed(motion);
  const Record& record = motion.record;
  const bool on_the_way = phase_ == Phase::helix;
  if (!on_the_way && entry_fault_) return fault(kGeometry, clause, motion, *entry_fault_);
  const bool goes_on = is_cut(record.kind) && height(motion.to()) < height(motion.from);
  if (on_the_way && !goes_on) return FreeStepAnswer::decide(helix_ended());
  if (record.kind == RecordKind::rapid) {
    return fault(kGeometry, "GSK-G114-10"_clause, motion,
                 "A traverse goes below the R plane before the helix.");
  }
  if (record.kind != RecordKind::arc && tolerances_.chord.sign() == 0) {
    return fault(kGeometry, clause, motion, "The tool goes below the R plane off the helix.");
  }
  if (!on_the_way && !geometry_.on_circle(motion.from, radius())) return wrong_radius(motion);
  if (record.kind != RecordKind::arc) return fault(kGeometry, clause, motion, result.reason);
  if (record.plane != item_.plane) {
    return fault(kGeometry, clause, motion, "The helix lies in another plane.");
  }
  for (std::size_t i : {0U, 1U}) {
    if (agree(record.centre[i], item_.centre[i], tolerances_.tolerance)) continue;
    return fault(kGeometry, clause, motion, "The helix turns about another centre.",
                 abs(record.centre[i] - item_.centre[i]));
  }
  if ((record.rot < 0) != (item_.sense < 0)) {
    return fault(kGeometry, "GSK-G114-09"_clause, motion, "The helix turns the wrong way.");
  }
  if (!on_the_way && !agree(motion.from[axes_.d], item_.r_plane, tolerances_.tolerance)) {
    return fault(kGeometry, clause, motion, "The helix does not begin at the R plane.",
                 abs(motion.from[axes_.d] - item_.r_plane));
  }
  if (!geometry_.on_circle(motion.to(), radius())) return wrong_radius(motion);
  return wrong_way_down(motion);
}

// Another radius than that of the pass; that of a neighbouring pass says more.
FreeStepAnswer ThreadJudge::wrong_radius(const Motion& motion) const {
  const Position& at = geometry_.on_circle(motion.from, radius()) ? motion.to() : motion.from;
  const PlaneVector v = geometry_.from_axis(at);
  const Number got = exact::sqrt(norm_squared(v));
  const Number beyond = item_.external ? radius() - got : got - radius();
  reference::ClauseId clause = "GSK-G114-04"_clause;
  std::string message = "The helix has another radius than its pass.";
  if (pass_ < passes_ && geometry_.on_circle(at, item_.radius_of_pass(pass_ + 1))) {
    message = "A pass of the thread is missing before this one.";
  } else if (pass_ > 1 && geometry_.on_circle(at, item_.radius_of_pass(pass_ - 1))) {
    message = "A pass of the thread is cut again.";
  } else if (pass_ == passes_ && beyond.sign() > 0) {
    message = "The last pass is deeper than the thread.";
  } else {
    clause = "GSK-G114-06"_clause;
  }
  FreeStepAnswer answer =
      fault(VerdictKind::fail_geometry, clause, motion, std::move(message), abs(beyond));
  answer.verdict.witness = point_text(at, {Axis::x, Axis::y, Axis::z});
  return answer;
}

// Lead, turns or depth: estimates only choose the name here.
FreeStepAnswer ThreadJudge::wrong_way_down(const Motion& motion) const {
  const double tau = approximate(tolerances_.tolerance);
  const double lead = approximate(item_.lead);
  const double turns = approximate_turns(motion);
  const double down = approximate(height(motion.from) - height(motion.to()));
  const double slope = std::abs(down - turns * lead);
  const bool at_bottom = agree(motion.to()[axes_.d], item_.bottom, tolerances_.tolerance);
  std::string message = "The helix ends at another point.";
  const double turns_off = slope / lead;
  if (slope > 3 * tau) {
    const bool whole =
        std::round(turns_off) >= 1 && std::abs(turns_off - std::round(turns_off)) * lead < 3 * tau;
    message = at_bottom && whole ? "The helix makes another number of turns."
                                 : "The lead of the helix differs.";
  } else if (!at_bottom) {
    message = "The helix ends at another depth.";
  }
  return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion, std::move(message),
               abs(motion.to()[axes_.d] - item_.bottom));
}

// J-THR-06
FreeStepAnswer ThreadJudge::wrong_way_back(const Motion& motion) const {
  std::string message =
      "The way back to the R plane does not lead along the depth axis alone from the end of the "
      "run-out.";
  if (motion.record.kind == RecordKind::arc) {
    message = "The tool turns on its way back to the R plane.";
  } else if (is_falling(motion)) {
    message = "The tool goes down again on its way back to the R plane.";
  } else if (motion.record.kind == RecordKind::rapid) {
    message = "A traverse below the R plane does not lead along the depth axis alone.";
  }
  return fault(VerdictKind::fail_geometry, "GSK-G114-10"_clause, motion, std::move(message));
}

// J-THR-06
FreeStepAnswer ThreadJudge::not_away(const Motion& motion) const {
  std::string message =
      "The tool does not move along the first axis of the plane to the safe position before it "
      "goes on.";
  if (geometry_.is_beyond_reach(motion.to())) {
    message = "The tool goes farther than the safe position and a tool's diameter beside it.";
  } else if (geometry_.moves_first_axis_alone(motion)) {
    message = "The tool turns back before it has reached the safe position.";
  }
  return fault(VerdictKind::fail_geometry, "GSK-G114-10"_clause, motion, std::move(message));
}

}  // namespace gonogo::oracle
