// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_judge.hpp"

#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

ThreadJudge::ThreadJudge(const reference::ThreadMilling& item, Path path, const Position& start,
                         const Tolerances& tolerances, RunOutSet& run_outs)
    : item_(item),
      side_(static_cast<int>(path)),
      tolerances_(tolerances),
      run_outs_(run_outs),
      geometry_(item, tolerances),
      axes_(reference::axes_of(item.plane)),
      passes_(item.passes()),
      turns_(reference::gsk988ta::turns_of(item)),
      start_(start),
      position_(start),
      entry_(geometry_) {
  to_end_ = turn_by((turns_ - turns_.floor()) * 360 * item.sense);
  begin_pass(start);
}

void ThreadJudge::begin_pass(const Position& from) {
  phase_ = Phase::entry;
  entry_.begin(from, pass_);
  entry_fault_.reset();
  open_.emplace();
  away_direction_ = 0;
  if (is_named()) step_ = Step::entry;
}

// A thread so shallow that the way back to the R plane is too small to see.
bool ThreadJudge::is_back_unseen() const {
  if (phase_ == Phase::way_back) return !is_below(position_);
  return phase_ == Phase::run_out && !is_below(position_) &&
         (item_.runout_length.sign() == 0 || !run_out_->ending_at(position_).empty());
}

bool ThreadJudge::complete() const {
  if (pass_ > passes_) return true;  // of a path that is named
  if (pass_ != passes_ || !is_safe(position_)) return false;
  return phase_ == Phase::away || is_back_unseen();
}

std::optional<Verdict> ThreadJudge::end(const Position& here) {
  if (complete()) return std::nullopt;
  return incomplete(here);
}

// Where the subject stands, or where the reference would where that agrees.
FreeStep::Exit ThreadJudge::exit(const Position& here) const {
  Position at = start_;
  for (const Axis axis : {axes_.p, axes_.q, axes_.d}) at[axis] = here[axis];
  const std::array<Number, 2> shown = reference::gsk988ta::end_of_passes(item_);
  // Half the tolerance: as far as a correctly rounded position may lie.
  const Number near = tolerances_.tolerance / 2;
  if (agree(here[axes_.p], shown[0], near) && agree(here[axes_.q], shown[1], near)) {
    at[axes_.p] = shown[0];
    at[axes_.q] = shown[1];
  }
  if (agree(here[axes_.d], item_.r_plane, tolerances_.tolerance)) at[axes_.d] = item_.r_plane;
  return {at, true};
}

FreeStepAnswer ThreadJudge::take(const Motion& motion) {
  waits_ = false;
  if (passes_ > 1 && agree(item_.r_plane, item_.bottom, tolerances_.tolerance)) {
    return FreeStepAnswer::gap(
        GapReason::two_readings,
        "The passes of a thread that is no deeper than the tolerance cannot be distinguished.");
  }
  if (tolerances_.compare_blocks && motion.record.block != item_.block) {
    if (complete()) return FreeStepAnswer::end(motion.from);
    return FreeStepAnswer::decide(incomplete(motion.from));
  }
  if (turns_rotary_axis(start_, motion.to(), tolerances_.tolerance)) {
    return fault(VerdictKind::fail_geometry, item_.clause, motion,
                 "A rotary axis moves in a thread.");
  }
  if (motion.record.kind == RecordKind::thread) {
    return fault(VerdictKind::fail_geometry, item_.clause, motion,
                 "A feed bound to the spindle has no place in thread milling.");
  }
  if (motion.record.kind == RecordKind::arc3) {
    return FreeStepAnswer::gap(GapReason::unjudged_form,
                               "An arc through a point is not judged in a thread.");
  }
  FreeStepAnswer answer = take_by_phase(motion);
  if (answer.kind != FreeStepAnswer::Kind::taken) return answer;
  if (is_cut(motion.record.kind) &&
      !feeds_agree(item_.feed, item_.feed_mode, motion.record, tolerances_)) {
    return wrong_feed(motion);
  }
  position_ = motion.to();
  if (!waits_) last_ = motion;
  // J-THR-01: steps are bounded by the thread's geometry, not by the number of pieces.
  if (!waits_) answer.cost = FreeStepAnswer::Cost::free;
  return answer;
}

FreeStepAnswer ThreadJudge::take_by_phase(const Motion& motion) {
  switch (phase_) {
    case Phase::entry:
      return take_entry(motion);
    case Phase::helix:
      return take_helix(motion);
    case Phase::run_out:
      return take_run_out(motion);
    case Phase::way_back:
      return take_way_back(motion);
    case Phase::away:
      return take_away(motion);
  }
  return {};
}

// J-THR-02. Where the helix begins shows only when it leaves the R plane.
FreeStepAnswer ThreadJudge::take_entry(const Motion& motion) {
  if (is_named() && step_ != Step::helix) return take_named(motion);
  const MatchResult result = match_helix(motion);
  if (phase_ == Phase::run_out) return {};
  if (is_below(motion.from) || is_below(motion.to())) {
    if (open_->empty()) return no_helix(motion, result);
    phase_ = Phase::helix;
    return {};
  }
  if (geometry_.is_above(motion.to())) {
    const bool missing = !entry_.has_begun();
    return fault(VerdictKind::fail_geometry, missing ? "GSK-G114-04"_clause : "GSK-G114-10"_clause,
                 motion,
                 missing ? "A pass of the thread is missing."
                         : "The tool leaves the R plane before the helix of its pass.");
  }
  if (is_named()) {
    if (!open_->empty()) return {};
    // The last piece of an infeed that came within the tolerance of its end before.
    const bool nothing =
        agree(motion.from, motion.to(), tolerances_.tolerance) && !nearly_full_turn(motion);
    return nothing ? wait() : no_helix(motion, result);
  }
  switch (entry_.add(motion)) {
    case ThreadEntry::Taken::progress:
      return {};
    case ThreadEntry::Taken::nothing:
      return wait();
    case ThreadEntry::Taken::departs:
      break;
  }
  if (!open_->empty()) return {};
  return fault(VerdictKind::fail_geometry, "GSK-G114-06"_clause, motion, entry_.departure());
}

// J-THR-04
MatchResult ThreadJudge::match_helix(const Motion& motion) {
  if (phase_ == Phase::entry) {
    HelixShape helix = helix_of(item_, item_.clause, radius(), turns_);
    helix.to_end = to_end_;
    if (std::optional<OpenStart> starts = starts_of_helix(helix, motion, tolerances_)) {
      const bool named = !is_named() || starts->narrow({}, {helix.radius * side_, 0});
      std::optional<std::string> why;
      if (!is_named()) why = entry_.fault_before_helix(motion.from);
      if (why) {
        if (!entry_fault_) entry_fault_ = std::move(why);
      } else if (named && !open_->add(helix, *std::move(starts), motion.from, tolerances_)) {
        return MatchResult::undecided(GapReason::cap_ways,
                                      "The helix may have begun at too many points.");
      }
    }
  }
  MatchResult result = open_->match(motion);
  if (result.done) {
    helix_ = open_->take_done();
    open_.emplace();
    line_.reset();
    highest_ = height(motion.to());
    run_out_.emplace(geometry_, pass_, helix_.front(), to_end_, motion.to(),
                     allowed_run_outs(run_outs_), allowed_run_outs({}));
    if (is_named() && !item_.external && !run_out_->is_unfit()) run_out_->turn_with_helix();
    phase_ = Phase::run_out;
  }
  return result;
}

FreeStepAnswer ThreadJudge::take_helix(const Motion& motion) {
  const MatchResult result = match_helix(motion);
  if (result.departure == Departure::none) return {};
  return no_helix(motion, result);
}

}  // namespace gonogo::oracle
