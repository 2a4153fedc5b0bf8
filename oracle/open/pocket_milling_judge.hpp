// SPDX-License-Identifier: GPL-3.0-or-later
//
// The judge of a pocket whose path the manual leaves open (LCYC75): plunges at the centre, levels
// judged by what they clear, free travel in what is cleared, and the end above the centre.
#pragma once

#include <optional>
#include <vector>

#include "oracle/motion/progress.hpp"
#include "oracle/open/free_step.hpp"
#include "oracle/region/constants.hpp"
#include "oracle/region/frame.hpp"
#include "oracle/region/milled_floor.hpp"
#include "oracle/region/rectangle.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class PocketMillingJudge : public FreeStep {
 public:
  // `item` and `tolerances` must outlive the judge. The tool stands at `place`, at the clearance
  // above the centre.
  PocketMillingJudge(const reference::PocketMilling& item, const Position& place,
                     const Tolerances& tolerances);

  // The path ends with the motion that reaches R101 above the centre; what follows is `ended`.
  FreeStepAnswer take(const Motion& motion) override;
  std::optional<Verdict> end(const Position& here) override;
  Exit exit(const Position& here) const override;
  bool sees(const Motion& small) const override;
  bool may_begin_within(const Motion& rest) const override;

 private:
  FreeStepAnswer take_motion(const Motion& motion);
  // Whether the last motion has a limit of its own: a motion of a level, or a cut through what is
  // cleared, of which a pocket may have as many as a level has motions.
  bool is_limited() const { return milling_ || idle_cuts_ <= kMostMotions; }
  Verdict incomplete(const Position& position) const;
  // How far the tool may go down without cutting: everywhere it may be, and in what roughing left.
  struct Cleared {
    Number everywhere;
    Number rough;
  };

  // Whether the motion leads up or down, however little.
  bool goes_along_depth(const Motion& motion) const;
  // Whether a cut along the depth axis within a level leaves it at its depth.
  bool stays_at_level(const Motion& motion) const;
  FreeStepAnswer take_along_plane(const Motion& motion);
  // Whether the depth may be one that is cleared everywhere.
  bool is_near_cleared(const Number& depth) const;
  FreeStepAnswer take_near_cleared(const Motion& motion);
  void start_floor_or_travel(const Number& depth, const Position& plunge);
  FreeStepAnswer finish_floor_or_travel(const Motion& next);
  void close_level();
  FreeStepAnswer take_cut(const Motion& motion);
  FreeStepAnswer collect(const Motion& motion);
  FreeStepAnswer take_down(const Motion& motion);
  FreeStepAnswer take_travel(const Motion& motion);
  FreeStepAnswer check_travel(const Motion& motion) const;
  bool traverses_on_floor(const Motion& motion) const;
  FreeStepAnswer check_first(const Motion& motion) const;
  bool passes_retract_plane(const Motion& motion) const;
  FreeStepAnswer check_plunge(const Motion& motion) const;
  FreeStepAnswer check_level_depth(const Motion& motion);
  FreeStepAnswer finish_level(const Motion& next);
  FreeStepAnswer judge_level(const Motion& next);
  // SIE-LC75-07: whether the floor is milled where only the contour is to be.
  FreeStepAnswer check_contour_only(const Motion& next) const;
  FreeStepAnswer level_fault(const region::Finding& finding, const Position& at) const;
  // `off`: how far, where that is a length.
  FreeStepAnswer departs(VerdictKind kind, reference::ClauseId clause, const Motion& motion,
                         std::string message, const Number& off = 0) const;
  FreeStepAnswer wrong_depth(const Motion& motion) const;

  bool is_floor(const Number& depth) const;
  // The distance from the centre at a depth, along the axis where it is greatest; 0: not known.
  Number from_centre(const Position& at, const Number& depth) const;
  // Whether a list names the depths of all levels.
  bool are_levels_named() const;
  // How deep the next level may be, where no list names it.
  Number deepest_infeed() const;
  // Whether a level that breaks a rule of the floor must be one just above it.
  bool may_be_above_floor() const;
  bool admits_depth(const Number& depth) const;
  bool is_due(const Number& place) const;
  std::optional<Number> due_place(const Number& depth) const;
  std::optional<Number> place_of(const Number& depth) const;
  bool has_strip() const { return item_.finishing && item_.allowance.sign() > 0; }
  bool above_centre(const Position& at) const;
  bool has_feed(const Motion& motion, const Number& feed) const;
  // Whether the motion stays where the tool's centre may be; nothing when that is undecided.
  std::optional<bool> stays_in(const Motion& motion, const region::RoundedRectangle& area) const;
  // Whether the tool can only go up and down in the pocket.
  bool is_point() const;
  // Where coordinates are only enclosed, rational ones near them are used.
  void take_slack_of(const Motion& motion);
  // In the pocket's own frame.
  region::PlanePoint own(const Position& at) const;
  region::LevelMotion own(const Motion& motion) const;
  region::RectangularLevel level_at(const Number& depth) const;

  const reference::PocketMilling& item_;
  Position place_;
  const Tolerances& tolerances_;
  reference::PlaneAxes axes_;
  region::RoundedRectangle area_;  // what the tool may touch
  region::PocketFrame frame_;
  Number slack_;  // of the frame, over the area, and of coordinates that are only enclosed
  bool has_slack_of_enclosures_ = false;
  region::RoundedRectangle reach_;                      // where its centre may be
  std::optional<region::RoundedRectangle> rough_area_;  // finishing: what roughing cleared
  region::RoundedRectangle rough_reach_;                // and where the tool fits in it
  Cleared cleared_;
  bool first_ = true;              // no level is finished
  Number next_level_ = 1;          // place of the next one in the list that the reading names
  Number last_depth_;              // of the level before, at first the clearance
  std::optional<Motion> arrival_;  // what brought the tool down to where it is
  bool milling_ = false;           // a level is being collected
  Number lowest_;                  // that the tool has been in what is cleared, or in the air
  Number depth_;                   // of it
  // J-PKT-09: two ways to take the level, between which its end decides.
  bool may_be_travel_ = false;  // what its cuts are unless they clear the floor
  bool taken_above_floor_ =
      false;  // the level above the floor, since it is not milled as the floor
  std::optional<Verdict> floor_fault_;  // why not
  std::vector<region::LevelMotion> motions_;
  std::vector<Record> records_;
  std::size_t idle_cuts_ = 0;
  bool has_risen_ = false;  // the last motion along the depth axis led up
  MilledAgain again_;
  MilledWay way_;
  std::optional<region::MilledFloor> floor_cuts_;  // where only the contour is to be milled
  region::PlanePoint plunge_;
  bool floor_done_ = false;
  bool over_ = false;
};

}  // namespace gonogo::oracle
