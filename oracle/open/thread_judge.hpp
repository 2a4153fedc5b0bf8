// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of the passes of a thread milling block: the steps of the text in their order, each
// within what its clause leaves open, and nothing else (GSK-G114-06, GSK-G114-10, GSK-G114-14;
// docs/judging.md, J-THR).
#pragma once

#include <optional>

#include "oracle/open/free_step.hpp"
#include "oracle/open/open_helix.hpp"
#include "oracle/open/thread_entry.hpp"
#include "oracle/open/thread_run_out.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class ThreadJudge : public FreeStep {
 public:
  // The path of the reading gsk.thread.path = arc, the same on the other side along p, or any that
  // the steps leave open.
  enum class Path { named = 1, mirrored = -1, open = 0 };
  // `item`, `tolerances` and `run_outs` (what the program has left so far) must outlive the judge.
  // `start`: where the tool stands, at the R plane.
  ThreadJudge(const reference::ThreadMilling& item, Path path, const Position& start,
              const Tolerances& tolerances, RunOutSet& run_outs);

  FreeStepAnswer take(const Motion& motion) override;
  // The path may end when the passes are done and the tool is at the R plane, at a safe position.
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override;

 private:
  bool complete() const;
  // Why it is not complete; `position` is where the subject stands.
  Verdict incomplete(const Position& position) const;
  // The motion belongs to a step and moves nothing that is seen.
  FreeStepAnswer wait() {
    waits_ = true;
    return {};
  }
  // For a pass: the arc and the infeed, the helix, the run-out, back to the R plane, away.
  enum class Phase { entry, helix, run_out, way_back, away };

  FreeStepAnswer take_by_phase(const Motion& motion);
  FreeStepAnswer take_entry(const Motion& motion);
  FreeStepAnswer take_helix(const Motion& motion);
  FreeStepAnswer take_run_out(const Motion& motion);
  FreeStepAnswer take_run_out_cut(const Motion& motion);
  FreeStepAnswer take_way_back(const Motion& motion);
  FreeStepAnswer rise_beyond(const Motion& motion);
  FreeStepAnswer take_away(const Motion& motion);
  FreeStepAnswer take_after_last(const Motion& motion);
  void begin_pass(const Position& from);

  // Steps of a path that is named.
  enum class Step { entry, infeed, helix, away, over };
  FreeStepAnswer take_named(const Motion& motion);
  bool prepare_named(const Position& from);  // false where the step moves nothing
  void next_named(const Position& at);
  bool passes_end_of_thread(const Motion& motion) const;

  // Follows the motion along every helix that may have begun, or begins with it.
  MatchResult match_helix(const Motion& motion);
  RunOutSet allowed_run_outs(const RunOutSet& left) const;
  bool is_remainder(const Motion& motion) const;
  bool is_chord_clear(const Motion& flat) const;
  Clearance clearance_where_risen(const Motion& motion, const Motion& flat) const;
  bool is_back_unseen() const;
  bool is_end_untold() const;
  bool passes_safety(const Motion& motion, bool is_clear) const;
  std::optional<Verdict> finish_run_out(const Motion& motion);
  bool promises_clearance() const { return item_.runout_length >= item_.depth_of_pass(pass_); }

  // The evidence, in thread_faults.cpp.
  // `off`: how far, where that is a length.
  FreeStepAnswer fault(VerdictKind kind, reference::ClauseId clause, const Motion& motion,
                       std::string message, const Number& off = 0) const;
  FreeStepAnswer wrong_feed(const Motion& motion) const;
  FreeStepAnswer touching(const Clearance& clearance, reference::ClauseId clause,
                          const Motion& motion, std::string message) const;
  FreeStepAnswer no_helix(const Motion& motion, const MatchResult& result) const;
  Verdict helix_ended() const;
  FreeStepAnswer wrong_radius(const Motion& motion) const;
  FreeStepAnswer wrong_way_down(const Motion& motion) const;
  FreeStepAnswer no_run_out(const Motion& motion) const;
  FreeStepAnswer wrong_way_back(const Motion& motion) const;
  FreeStepAnswer not_away(const Motion& motion) const;
  std::string want_text() const;

  Number radius() const { return item_.radius_of_pass(pass_); }
  Number height(const Position& at) const { return geometry_.height(at); }
  bool is_below(const Position& at) const { return geometry_.is_below(at); }
  bool is_named() const { return side_ != 0; }
  bool is_safe(const Position& at) const { return geometry_.is_safe(at, side_); }
  bool is_falling(const Motion& motion) const {
    return height(motion.to()) < highest_ - tolerances_.tolerance;
  }
  // What the way back and the way to the safe position are free of.
  Number radius_kept() const { return promises_clearance() ? item_.start_radius : radius(); }

  const reference::ThreadMilling& item_;
  const int side_;  // along p, of a path that is named; 0: open
  const Tolerances& tolerances_;
  RunOutSet& run_outs_;
  ThreadGeometry geometry_;
  reference::PlaneAxes axes_;
  Number passes_;      // N
  Number turns_;       // of a helix
  Similarity to_end_;  // from the start of a helix to its end

  Phase phase_ = Phase::entry;
  Number pass_ = 1;
  Position start_;              // where the reference stood before the passes
  Position position_;           // where the tool stands
  std::optional<Motion> last_;  // that was taken, and did not wait
  bool waits_ = false;
  Step step_ = Step::over;

  ThreadEntry entry_;
  std::optional<std::string> entry_fault_;  // where the helix begins
  std::optional<OpenHelices> open_;         // that may have begun
  std::list<OpenHelix> helix_;              // the one that is complete
  std::optional<ThreadRunOutJudge> run_out_;
  Number highest_;  // place over the R plane since the helix
  Position run_out_end_;
  int away_direction_ = 0;  // along p
  Motion line_want_;        // a motion that a reading names
  std::optional<CurveFollower> line_;
};

}  // namespace gonogo::oracle
