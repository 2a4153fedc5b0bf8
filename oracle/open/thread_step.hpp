// SPDX-License-Identifier: GPL-3.0-or-later
//
// A thread milling block whose path is open. The path that the reading gsk.thread.path = arc names
// is right, on either side along p, and so is any other that the steps leave open (J-THR-01). All
// are followed until they depart.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "oracle/open/thread_judge.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {

class ThreadStep : public FreeStep {
 public:
  // The arguments are those of ThreadJudge.
  ThreadStep(const reference::ThreadMilling& item, const Position& start,
             const Tolerances& tolerances, RunOutSet& run_outs);

  FreeStepAnswer take(const Motion& motion) override;
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override { return ways_.front().judge->exit(here); }
  bool is_path_known() const override { return item_.arc_path; }

 private:
  struct Way {
    ThreadJudge::Path path;
    bool is_left = true;
    std::optional<ThreadJudge> judge = {};  // none: it has not begun
  };
  void begin(Way& way);
  void take_by(Way& way, const Motion& motion, std::size_t number,
               std::optional<FreeStepAnswer>& taken);
  // The filter: a way begins only when those before it have departed, as long as motions are kept.
  bool may_wait() const { return tolerances_.skip_equal && taken_.size() < kMostParts; }

  const reference::ThreadMilling& item_;
  const Position start_;
  const Tolerances& tolerances_;
  RunOutSet& run_outs_;
  std::array<Way, 3> ways_;  // the last says most of a path that departs from all
  std::size_t motions_ = 0;
  std::vector<Motion> taken_;  // while there are ways that have not begun
  std::optional<Verdict> departed_;
  std::size_t departed_at_ = 0;
};

}  // namespace gonogo::oracle
