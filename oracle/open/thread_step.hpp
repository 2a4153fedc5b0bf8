// SPDX-License-Identifier: GPL-3.0-or-later
//
// A thread milling block whose path is open: the path that the reading gsk.thread.path = arc names
// is right as it is, on either side along p, and so is any other that the steps leave open
// (J-THR-01). All are followed until they depart.
#pragma once

#include <array>

#include "oracle/open/thread_judge.hpp"

namespace gonogo::oracle {

class ThreadStep : public OpenStep {
 public:
  // As of ThreadJudge.
  ThreadStep(const reference::ThreadMilling& item, const Position& start,
             const Tolerances& tolerances, RunOutSet& run_outs);

  OpenStepAnswer take(const Motion& motion) override;
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override { return ways_.back().judge.exit(here); }

 private:
  struct Way {
    ThreadJudge judge;
    bool is_left = true;
  };
  void depart(Way& way, Verdict verdict);

  std::array<Way, 3> ways_;  // what stands behind says more of a path that is neither
  std::optional<Verdict> departed_;
};

}  // namespace gonogo::oracle
