// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of one level of a circular pocket (G110, G111): the motions between the plunge and the
// next motion along the depth axis, which the region judge decides as a whole (J-PKT).
#pragma once

#include <optional>
#include <vector>

#include "oracle/motion/progress.hpp"
#include "oracle/open/free_step.hpp"
#include "oracle/region/level.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class PocketLevelStep : public FreeStep {
 public:
  // All must outlive it. `place`: where the reference stands, at the plunge. `last`: the last level
  // that was judged GO.
  PocketLevelStep(const reference::PocketLevel& level, const Position& place,
                  const Tolerances& tolerances, std::optional<reference::PocketLevel>& last);

  FreeStepAnswer take(const Motion& motion) override;
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override;
  bool is_before(const Motion& motion) const override;
  bool may_be_left_by(const Motion& small) const override;
  bool is_judged_when_left() const override { return true; }
  bool is_judged_at_alarm(const Position& here) const override;

 private:
  // Whether the motion belongs to the level; what departs is decided.
  bool collects(const Motion& motion) const;
  FreeStepAnswer collect(const Motion& motion);
  // `off`: how far, where that is a length.
  FreeStepAnswer departs(VerdictKind kind, const Motion& motion, std::string message,
                         const Number& off = 0) const;
  FreeStepAnswer leaves_depth(const Motion& motion) const;
  region::CircularLevel circle(const Position& plunge) const;
  Verdict fault(const region::Finding& finding, const Position& here) const;

  const reference::PocketLevel& level_;
  reference::PlaneAxes axes_;
  Position place_;
  const Tolerances& tolerances_;
  std::optional<reference::PocketLevel>& last_;
  Position plunge_;  // where the tool came down
  std::vector<region::LevelMotion> motions_;
  Number slack_;                 // of the enclosures among them
  std::vector<Record> records_;  // the same, for the evidence
  MilledAgain again_;
  MilledWay way_;
};

}  // namespace gonogo::oracle
