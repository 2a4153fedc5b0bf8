// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the run-out at the bottom of a pass (J-THR-05).
#include "oracle/open/thread_judge.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

namespace {

constexpr const char* kAnotherRunOut =
    "The run-out is another one than those of the passes before: one holds for a whole program.";

}  // namespace

// Those that the reading names; under `any`, of those that are left.
RunOutSet ThreadJudge::allowed_run_outs(const RunOutSet& left) const {
  RunOutSet allowed = RunOutSet::none();
  for (const ThreadRunOut each : kRunOuts) {
    const bool named = item_.runout == each;
    if (named || (item_.runout == ThreadRunOut::open && left.has(each))) allowed.add(each);
  }
  return allowed;
}

// What is left of a helix that ended within the tolerance of its end.
bool ThreadJudge::is_remainder(const Motion& motion) const {
  const Number rise = abs(geometry_.height_over_bottom(motion.to()));
  return !run_out_->has_begun() && !nearly_full_turn(motion) && rise <= tolerances_.tolerance &&
         helix_.front().starts().admits(to_end_, geometry_.from_axis(motion.to()));
}

// J-THR-01: a chord cuts deeper than its arc, by no more than the certifier grants.
bool ThreadJudge::is_chord_clear(const Motion& flat) const {
  return flat.record.kind == RecordKind::feed && tolerances_.chord.sign() > 0 &&
         geometry_.clearance_of_chord(flat, radius()).kind == Clearance::Kind::clear;
}

// J-THR-05: of the part of the motion that is higher than the groove leads, whether it is free of
// the part. The groove rises by the lead a turn, and so by its part of that over K degrees, either
// way round.
Clearance ThreadJudge::clearance_where_risen(const Motion& motion, const Motion& flat) const {
  const Number k = run_out_degrees(item_);
  const Number allowed = item_.lead * min(k, Number(360) - k) / 360 + tolerances_.tolerance;
  const Number from = geometry_.height_over_bottom(motion.from);
  const Number to = geometry_.height_over_bottom(motion.to());
  if (to <= allowed) return {};
  const Number part = from < allowed ? (allowed - from) / (to - from) : Number(0);
  const bool is_chord = flat.record.kind == RecordKind::feed && tolerances_.chord.sign() > 0;
  return is_chord ? geometry_.clearance_of_chord(flat, item_.start_radius, part)
                  : geometry_.clearance(flat, item_.start_radius, part);
}

FreeStepAnswer ThreadJudge::take_run_out(const Motion& motion) {
  if (is_cut(motion.record.kind)) {
    if (is_remainder(motion)) return wait();
    if (geometry_.moves_in_plane(motion)) return take_run_out_cut(motion);
  }
  if (std::optional<Verdict> verdict = finish_run_out(motion)) {
    return FreeStepAnswer::decide(*std::move(verdict));
  }
  phase_ = Phase::way_back;
  run_out_end_ = motion.from;
  return take_way_back(motion);
}

FreeStepAnswer ThreadJudge::take_run_out_cut(const Motion& motion) {
  const Number rise = geometry_.height_over_bottom(motion.to());
  if (rise < -tolerances_.tolerance) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion,
                 "The tool cuts below the bottom of the thread.");
  }
  if (item_.runout_length.sign() == 0) return no_run_out(motion);
  const bool falls = is_falling(motion);
  if (falls || geometry_.is_above(motion.to())) {
    return fault(VerdictKind::fail_geometry, "GSK-G114-11"_clause, motion,
                 falls ? "The run-out goes down again." : "The run-out rises beyond the R plane.");
  }
  // None of the run-outs turns in another plane, wherever such an arc leads.
  if (motion.record.kind == RecordKind::arc && motion.record.plane != item_.plane) {
    return no_run_out(motion);
  }
  // A run-out that rises is judged by its part in the plane.
  Motion flat = motion;
  flat.from[axes_.d] = flat.record.to[axes_.d] = item_.bottom;
  if (const Clearance risen = clearance_where_risen(motion, flat);
      risen.kind != Clearance::Kind::clear) {
    return touching(risen, "GSK-G114-11"_clause, motion,
                    "The run-out rises out of its groove while it is still in the material.");
  }
  const Clearance clear = geometry_.clearance(flat, radius());
  const bool is_unfit = run_out_->is_unfit();
  if (clear.kind != Clearance::Kind::clear && !is_unfit) {
    // J-THR-01
    if (!is_chord_clear(flat) || !run_out_->take_chord(flat)) {
      return touching(clear, "GSK-G114-10"_clause, motion,
                      "The run-out cuts deeper than its pass.");
    }
  } else if (!run_out_->take(flat)) {
    return no_run_out(motion);
  }
  highest_ = max(highest_, height(motion.to()));
  if (!is_unfit || run_out_->ending_at(flat.to()).empty()) return {};
  return FreeStepAnswer::gap(GapReason::reading_unfit,
                             "The run-out of the reading leads into the material by itself.");
}

std::optional<Verdict> ThreadJudge::finish_run_out(const Motion& motion) {
  if (item_.runout_length.sign() == 0) return std::nullopt;
  const RunOutSet ending = run_out_->ending_at(motion.from);
  if (!ending.empty()) {
    if (item_.runout == ThreadRunOut::open) run_outs_ = ending;
    return std::nullopt;
  }
  // J-CMP-12: what has begun ended elsewhere; else what comes in its place departs.
  const bool has_begun = run_out_->has_begun();
  std::string message = "The run-out ends at another point.";
  if (!has_begun) {
    message = "The run-out is missing.";
  } else if (run_out_->is_end_of_another(motion.from)) {
    message = kAnotherRunOut;
  }
  FreeStepAnswer answer = fault(VerdictKind::fail_geometry, "GSK-G114-11"_clause,
                                has_begun ? *last_ : motion, std::move(message));
  if (has_begun) answer.verdict.record = last_->number + last_->behind_first;
  answer.verdict.witness = point_text(motion.from, {Axis::x, Axis::y, Axis::z});
  set_deviation(answer.verdict, run_out_->distance_from_end(motion.from));
  return std::move(answer.verdict);
}

// A cut at the bottom that none of the run-outs makes.
FreeStepAnswer ThreadJudge::no_run_out(const Motion& motion) const {
  const bool round = motion.record.kind == RecordKind::arc;
  std::string message = "The run-out leads to another point than the readings name.";
  if (item_.runout_length.sign() == 0) {
    message = round ? "The tool turns on at the bottom of the thread, where the way back is due: "
                      "J = 0 is no run-out."
                    : "There is a run-out although J = 0.";
  } else if (run_out_->is_end(motion.from)) {
    message = "The tool cuts on after its run-out, where the way back to the R plane is due.";
  } else if (run_out_->swept() >= kAlmost) {
    message = "The tool turns round at the bottom of the thread, where the run-out is due.";
  } else if (run_out_->is_end_of_another(motion.to())) {
    message = kAnotherRunOut;
  } else if (round) {
    message = "The arc at the bottom is none of the run-outs that the readings name.";
  }
  return fault(VerdictKind::fail_geometry, "GSK-G114-11"_clause, motion, std::move(message));
}

}  // namespace gonogo::oracle
