// SPDX-License-Identifier: GPL-3.0-or-later
//
// ThreadJudge's part for the reading gsk.thread.path = arc, or its mirror image: a semicircle on
// the chord to +rho_0 on p, straight infeed along p, the helix from there; after it along p to the
// safe position. The run-out is judged as elsewhere.
#include "oracle/open/thread_judge.hpp"
#include "oracle/steps/step_text.hpp"
#include "reference/clause_literal.hpp"
#include "reference/gsk988ta/thread_path.hpp"

namespace gonogo::oracle {

using reference::operator""_clause;

// `from`: where the subject stands, which may be elsewhere than its last motion that was not too
// small to see ended.
bool ThreadJudge::prepare_named(const Position& from) {
  Motion& want = line_want_;
  want = Motion{};
  want.from = from;
  want.from[axes_.d] = item_.r_plane;
  Record& record = want.record;
  record.to = want.from;
  record.block = tolerances_.compare_blocks ? item_.block : 0;
  record.clause = "GSK-G114-06"_clause;
  record.feed = item_.feed;
  record.feed_mode = item_.feed_mode;
  record.axes = {axes_.p};
  Number& p = record.to[axes_.p];
  switch (step_) {
    case Step::entry:
      record.kind = RecordKind::arc;
      record.plane = item_.plane;
      record.rot = item_.sense;
      record.axes = {axes_.p, axes_.q};
      p = item_.centre[0] + item_.start_radius * side_;
      record.to[axes_.q] = item_.centre[1];
      record.centre = {(want.from[axes_.p] + p) / 2, (want.from[axes_.q] + record.to[axes_.q]) / 2};
      break;
    case Step::infeed:
      record.kind = RecordKind::feed;
      want.from[axes_.p] = item_.centre[0] + item_.start_radius * side_;
      want.from[axes_.q] = record.to[axes_.q] = item_.centre[1];
      p = item_.centre[0] + radius() * side_;
      break;
    default:
      record.kind = RecordKind::rapid;
      p = item_.centre[0] + reference::gsk988ta::safe_radius(item_) * side_;
      break;
  }
  if (agree(from, want.to(), tolerances_.tolerance)) return false;
  line_.emplace(want, tolerances_);
  return true;
}

void ThreadJudge::next_named(const Position& at) {
  line_.reset();
  if (step_ != Step::away) {
    step_ = step_ == Step::entry ? Step::infeed : Step::helix;
    return;
  }
  pass_ += 1;
  begin_pass(at);
  if (pass_ > passes_) step_ = Step::over;
}

// J-THR-09. Without block numbers the traverse of the next block may be joined to the last one of a
// thread that ends at the initial plane.
bool ThreadJudge::passes_end_of_thread(const Motion& motion) const {
  if (step_ != Step::away || pass_ != passes_ || !is_end_untold()) return false;
  const Number& end = line_want_.to()[axes_.p];
  return motion.record.kind == RecordKind::rapid && geometry_.moves_first_axis_alone(motion) &&
         (end - motion.from[axes_.p]).sign() * (motion.to()[axes_.p] - end).sign() > 0;
}

FreeStepAnswer ThreadJudge::take_named(const Motion& motion) {
  if (phase_ == Phase::away) step_ = Step::away;
  while (true) {
    if (step_ == Step::over) {
      return is_end_untold() ? FreeStepAnswer::end(motion.from) : take_after_last(motion);
    }
    if (step_ == Step::helix) return take_entry(motion);
    if (!line_ && !prepare_named(motion.from)) {
      next_named(motion.from);
      continue;
    }
    const bool nothing = agree(motion.from, motion.to(), tolerances_.tolerance) &&
                         agree(motion.from, line_want_.from, tolerances_.tolerance) &&
                         !nearly_full_turn(motion);
    const MatchResult result = line_->match(motion);
    if (result.departure != Departure::none && nothing) return wait();
    if (result.departure == Departure::none) {
      if (result.done) next_named(motion.to());
      return {};
    }
    if (agree(motion.from, line_want_.to(), tolerances_.tolerance)) {
      next_named(motion.from);
      continue;
    }
    if (passes_end_of_thread(motion)) return FreeStepAnswer::end(line_want_.to());
    if (result.departure == Departure::undecided)
      return FreeStepAnswer::gap(result.gap, result.reason);
    const bool feed = result.departure == Departure::feed;
    FreeStepAnswer answer =
        fault(feed ? VerdictKind::fail_feed : VerdictKind::fail_geometry,
              feed ? "GSK-G114-08"_clause : "GSK-G114-06"_clause, motion, result.reason);
    answer.verdict.want = record_text(line_want_.record);
    if (!feed) {
      set_deviation(answer.verdict, largest_difference(motion.to(), line_want_.to()));
    }
    return answer;
  }
}

}  // namespace gonogo::oracle
