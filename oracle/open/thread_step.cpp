// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/open/thread_step.hpp"

#include "oracle/steps/step_text.hpp"


namespace gonogo::oracle {

using Path = ThreadJudge::Path;

namespace {

OpenStepAnswer answer_of(ThreadJudge& judge, const Motion& motion) {
  try {
    return judge.take(motion);
  } catch (const exact::Undecided& undecided) {
    return OpenStepAnswer::decide(undecided_verdict(undecided));
  }
}

}  // namespace

ThreadStep::ThreadStep(const reference::ThreadMilling& item, const Position& start,
                       const Tolerances& tolerances, RunOutSet& run_outs)
    : ways_{Way{{item, Path::named, start, tolerances, run_outs}},
            Way{{item, Path::mirrored, start, tolerances, run_outs}, !item.arc_path},
            Way{{item, Path::open, start, tolerances, run_outs}, !item.arc_path}} {}

OpenStepAnswer ThreadStep::take(const Motion& motion) {
  std::optional<OpenStepAnswer> taken;
  for (Way& way : ways_) {
    if (!way.is_left) continue;
    OpenStepAnswer answer = answer_of(way.judge, motion);
    if (answer.is_decided()) {
      depart(way, std::move(answer.verdict));
    } else {
      taken = std::move(answer);
    }
  }
  return taken ? *std::move(taken) : OpenStepAnswer::decide(*departed_);
}

// The later one counts; but what is not known of the other must stay known.
void ThreadStep::depart(Way& way, Verdict verdict) {
  way.is_left = false;
  if (!departed_ || decision(departed_->kind) != Decision::undecided) {
    departed_ = std::move(verdict);
  }
}

std::optional<Verdict> ThreadStep::end(const Position& here) {
  std::optional<Verdict> why_not;
  for (Way& way : ways_) {
    if (!way.is_left) continue;
    why_not = way.judge.end(here);
    if (!why_not) return std::nullopt;
  }
  return why_not;
}

}  // namespace gonogo::oracle
