// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of the passes of a thread milling block: of their path only radii,
// lead, sense, depth, number and planes are fixed, and that nothing else touches the part
// (GSK-G114-03 to 06 and 08 to 11).
#pragma once

#include <optional>

#include "oracle/judge/open_helix.hpp"
#include "oracle/judge/open_path.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class ThreadJudge {
 public:
  // `item` and `terms` must outlive the judge. `start`: where the tool stands, at the R plane.
  ThreadJudge(const reference::ThreadMilling& item, const Position& start, const JudgeTerms& terms);
  ThreadJudge(const ThreadJudge&) = delete;

  OpenPathAnswer take(const Motion& motion);
  // Whether the passes are done and the tool is back at the R plane or above it.
  bool complete() const;
  // Why not; `position` is where the subject stands.
  Verdict incomplete(const Position& position) const;

 private:
  enum class Phase { above, helix, run_out, way_back };
  enum class Side { above, below, unknown };  // of the R plane, by more than the tolerance

  OpenPathAnswer take_in_phase(const Motion& motion);
  OpenPathAnswer take_above(const Motion& motion);
  OpenPathAnswer take_after_last(const Motion& motion, Side side);
  OpenPathAnswer take_helix(const Motion& motion);
  OpenPathAnswer take_run_out(const Motion& motion);
  OpenPathAnswer take_way_back(const Motion& motion);
  OpenPathAnswer end_pass(const Motion& motion);
  void begin_next_pass();
  bool is_back_unseen() const;

  // The path of the reading gsk.thread.path = arc, where it is named.
  enum class Step { entry, infeed, helix, away, over };
  OpenPathAnswer take_named(const Motion& motion);
  bool prepare_named(const Position& from);  // false where the step moves nothing

  HelixShape shape() const;  // of the helix of the pass
  // Follows the motion along every helix that may have begun, or begins with it.
  MatchResult match_helix(const Motion& motion);
  // Whether the reading says where the run-out ends, and then: a point moved there in the plane.
  bool has_run_out_end() const;
  Position at_run_out_end(Position at) const;
  bool runs_out_straight() const;
  Motion straight_run_out() const;
  bool reading_cuts_deeper() const;
  bool reading_ends_in_material() const;
  bool is_straight_run_out(const Motion& motion);
  std::optional<Verdict> finish_run_out(const Motion& motion);
  Similarity run_out_map() const;  // from the start of the helix to the end of the run-out
  Clearance clearance(const Motion& motion, const Number& radius, bool only_below) const;

  // The evidence, in thread_faults.cpp.
  OpenPathAnswer fault(VerdictKind kind, reference::ClauseId clause, const Motion& motion,
                       std::string message) const;
  OpenPathAnswer touching(const Clearance& clearance, reference::ClauseId clause,
                          const Motion& motion, std::string message) const;
  OpenPathAnswer no_helix(const Motion& motion, const MatchResult& result) const;
  OpenPathAnswer wrong_radius(const Motion& motion) const;
  OpenPathAnswer wrong_way_down(const Motion& motion) const;
  std::string want_text() const;

  Number radius() const { return item_.radius_of_pass(pass_); }
  // Height over the R plane, positive away from the bottom.
  Number height(const Position& at) const { return (at[axes_.d] - item_.r_plane) * up_; }
  Side side_of(const Motion& motion) const;
  bool is_below(const Position& at) const { return height(at) < -terms_.tolerance; }
  bool moves_depth_alone(const Motion& motion) const;
  PlaneVector from_axis(const Position& at) const;
  bool on_circle(const Position& at, const Number& radius) const;

  const reference::ThreadMilling& item_;
  const JudgeTerms& terms_;
  JudgeTerms loose_;  // for a line from where the subject's helix ends
  reference::PlaneAxes axes_;
  int up_;             // sign of d from the bottom to the R plane
  Number passes_;      // N
  Number turns_;       // of a helix
  Similarity to_end_;  // from the start of a helix to its end

  Phase phase_ = Phase::above;
  Number pass_ = 1;
  Position position_;  // where the tool stands
  Step step_ = Step::over;

  std::optional<OpenHelices> open_;  // that may have begun
  std::list<OpenHelix> helix_;       // the one that is complete
  Position helix_end_;
  bool ran_out_ = false;  // the run-out has begun
  Motion line_want_;      // a motion that a reading names
  std::optional<CurveMatch> line_;
};

}  // namespace gonogo::oracle
