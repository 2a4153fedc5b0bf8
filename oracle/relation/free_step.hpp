// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8: what a manual leaves open, held to the conditions of its clause.
#pragma once

#include <string_view>
#include <vector>

#include "oracle/relation/raster.hpp"
#include "oracle/relation/subject_side.hpp"
#include "reference/outcome.hpp"

namespace gonogo::relation {

// A helical pocket leaves open at which point of its circle the tool comes to the helix; that point
// decides everything. One path for each point at which the subject, from its event `begin` on, may
// have come to it.
std::vector<std::vector<reference::Record>> paths_of(const reference::HelixPocket& pocket,
                                                     SubjectSide& subject, std::size_t begin,
                                                     const Number& tau);

// How far a place may be off; the width of a piece is subtracted or added (Bias).
class Slack {
 public:
  Slack(const Tolerances& tolerances, bool is_generous)
      : tau_(tolerances.tolerance), is_generous_(is_generous) {}
  bool is_generous() const { return is_generous_; }
  bool allows(Said said) const { return said == Said::yes || (is_generous_ && said == Said::near); }
  // On an axis; on curves (R2).
  Number axis(const Number& width) const { return is_generous_ ? tau_ + width : tau_ - width; }
  Number round(const Number& width) const { return axis(width) + tau_ * 9 / 8; }

 private:
  Number tau_;
  bool is_generous_;
};

// How the subject's events, from one on, follow a step: where the step may be over, or which event
// breaks a condition.
struct StepAnswer {
  std::vector<std::size_t> ends;
  std::size_t broken_by = 0;
  std::string_view broken;  // a sentence; empty: none
};
struct Followed {
  SubjectSide& subject;
  std::size_t begin;
  const Tolerances& tolerances;
  Slack slack;
};
StepAnswer follow(const reference::PocketLevel& level, const Followed& way);
StepAnswer follow(const reference::PocketMilling& pocket, const Followed& way);
StepAnswer follow(const reference::ThreadMilling& thread, const Followed& way);

// The paths of a thread that the reading gsk.thread.path = arc names, on either side along p. None
// has an unfit run-out where another is fit, or more passes than `most`.
std::vector<std::vector<reference::Record>> paths_of(const reference::ThreadMilling& thread,
                                                     const Position& from, const Followed& way,
                                                     std::size_t most);
// R9: whether the run-out of the reading is unfit in one of so many passes: it leads into the
// material by itself.
bool is_unfit(const reference::ThreadMilling& thread, const Followed& way, std::size_t most);

// R3: the end of a stretch of one label that stays near a place; nothing where it does not. The
// place is where the last motion ended that had a label: small stretches do not add up.
std::optional<std::size_t> end_of_small_stretch(SubjectSide& subject, std::size_t begin,
                                                const Position& place, const Number& tau);

// Which way the arc of the piece turns in a plane, as the sign of rot; 0: it is no arc, or one that
// may come as its chord.
int sense_of(const Event& piece, const reference::PlaneAxes& axes);

// Whether an axis other than these moves.
bool moves_another_axis(const Event& piece, const Position& start, const reference::PlaneAxes& axes,
                        const Number& off);

// How far a piece may go in the plane.
inline Number way_of(const Event& piece, reference::Axis axis) {
  return abs(piece.to[axis] - piece.from[axis]);
}

}  // namespace gonogo::relation
