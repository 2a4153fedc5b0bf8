// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of a helical pocket that may be entered on any side (GSK-G112-04 to 06): a semicircle
// to the circle, the helix, perhaps a flat circle, a semicircle back to the centre.
#pragma once

#include <optional>
#include <vector>

#include "oracle/open/free_step.hpp"
#include "oracle/open/open_helix.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class HelixPocketJudge : public FreeStep {
 public:
  // `item` and `tolerances` must outlive the judge.
  // `place`: where the reference stands before it.
  HelixPocketJudge(const reference::HelixPocket& item, const Position& place,
                   const Tolerances& tolerances);

  // The path ends with the motion that reaches the centre at the bottom; what follows is `ended`.
  FreeStepAnswer take(const Motion& motion) override;
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override;
  bool is_before(const Motion& motion) const override;
  bool is_path_known() const override { return true; }

 private:
  bool complete() const;
  Verdict incomplete(const Position& position) const;
  enum class Phase { entry, helix, flat, exit, over };

  bool semicircle_is_unseen() const;
  bool stays_at_centre(const Motion& motion) const;
  FreeStepAnswer take_entry(const Motion& motion);
  FreeStepAnswer wrong_entry(const Motion& motion) const;
  FreeStepAnswer take_helix(const Motion& motion);
  FreeStepAnswer end_helix(const Motion& motion);
  Verdict helix_ended() const;
  std::optional<Verdict> ended_short(const Motion& next) const;
  FreeStepAnswer take_at_bottom(const Motion& motion);
  bool is_remainder(const Motion& motion) const;
  // The motions so far as a semicircle that ends where the last of them does.
  MatchResult match_entry(OpenStart& starts) const;
  Motion semicircle(const Position& from, const Position& to) const;
  OpenArc open_semicircle(const OpenStart& starts) const;
  void prepare_bottom(Phase phase);
  FreeStepAnswer departs(const MatchResult& result, const Motion& motion) const;
  reference::ClauseId clause() const;

  const reference::HelixPocket& item_;
  Position place_;
  const Tolerances& tolerances_;
  reference::PlaneAxes axes_;
  HelixShape shape_;
  Phase phase_ = Phase::entry;
  std::vector<Motion> entry_;
  std::optional<std::pair<MatchResult, Motion>> entry_fault_;
  OpenHelices open_;            // one for each motion that may have ended the entry
  std::list<OpenHelix> helix_;  // the one that is complete
  std::optional<Motion> last_;  // that was taken
  Position helix_end_;
  Motion want_;  // at the bottom
  bool is_begun_ = false;
  std::optional<CurveFollower> match_;
};

}  // namespace gonogo::oracle
