// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_step.hpp"

#include "oracle/steps/step_text.hpp"

namespace gonogo::oracle {

using Path = ThreadJudge::Path;

namespace {

FreeStepAnswer answer_of(ThreadJudge& judge, const Motion& motion) {
  try {
    return judge.take(motion);
  } catch (const exact::Undecided& undecided) {
    return FreeStepAnswer::decide(undecided_verdict(undecided));
  }
}

}  // namespace

ThreadStep::ThreadStep(const reference::ThreadMilling& item, const Position& start,
                       const Tolerances& tolerances, RunOutSet& run_outs)
    : item_(item),
      start_(start),
      tolerances_(tolerances),
      run_outs_(run_outs),
      ways_{Way{Path::named}, Way{Path::mirrored, !item.arc_path},
            Way{Path::open, !item.arc_path}} {
  begin(ways_.front());
}

void ThreadStep::begin(Way& way) {
  way.judge.emplace(item_, way.path, start_, tolerances_, run_outs_);
  std::optional<FreeStepAnswer> taken;
  for (std::size_t i = 0; i < taken_.size() && way.is_left; ++i) take_by(way, taken_[i], i, taken);
}

// The later of two departures counts; but an undecided answer stays.
void ThreadStep::take_by(Way& way, const Motion& motion, std::size_t number,
                         std::optional<FreeStepAnswer>& taken) {
  FreeStepAnswer answer = answer_of(*way.judge, motion);
  way.is_left = !answer.is_decided();
  if (way.is_left) {
    taken = std::move(answer);
  } else if (!departed_ ||
             (decision(departed_->kind) != Decision::undecided && number >= departed_at_)) {
    departed_ = std::move(answer.verdict);
    departed_at_ = number;
  }
}

FreeStepAnswer ThreadStep::take(const Motion& motion) {
  std::optional<FreeStepAnswer> taken;
  bool all_begun = true;
  for (Way& way : ways_) {
    if (!way.is_left) continue;
    if (!way.judge && taken && may_wait()) {
      all_begun = false;
      continue;
    }
    if (!way.judge) begin(way);
    if (way.is_left) take_by(way, motion, motions_, taken);
  }
  ++motions_;
  if (all_begun) {
    taken_.clear();
  } else {
    taken_.push_back(motion);
  }
  return taken ? *std::move(taken) : FreeStepAnswer::decide(*departed_);
}

std::optional<Verdict> ThreadStep::end(const Position& here) {
  std::optional<Verdict> why_not;
  for (Way& way : ways_) {
    if (!way.is_left) continue;
    if (!way.judge) begin(way);
    if (!way.is_left) continue;
    why_not = way.judge->end(here);
    if (!why_not) return std::nullopt;
  }
  return why_not;
}

}  // namespace gonogo::oracle
