// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where points and motions lie about a thread: its axis, its R plane, its circles.
#pragma once

#include "oracle/motion/motion.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/open/clearance.hpp"
#include "oracle/region/constants.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle {

class ThreadGeometry {
 public:
  // Both must outlive it.
  ThreadGeometry(const reference::ThreadMilling& item, const Tolerances& tolerances);

  const reference::ThreadMilling& item() const { return item_; }
  const Tolerances& tolerances() const { return tolerances_; }
  // For what begins where the subject's helix ends: both points that fix that end may be off by the
  // tolerance.
  const Tolerances& loose_terms() const { return loose_; }
  const reference::PlaneAxes& axes() const { return axes_; }

  // Over the R plane, positive away from the bottom.
  Number height(const Position& at) const { return (at[axes_.d] - item_.r_plane) * up_; }
  Number height_over_bottom(const Position& at) const { return (at[axes_.d] - item_.bottom) * up_; }
  bool is_below(const Position& at) const { return height(at) < -tolerances_.tolerance; }
  bool is_above(const Position& at) const { return height(at) > tolerances_.tolerance; }
  PlaneVector from_axis(const Position& at) const;
  // The place there, which is as high as another.
  Position place(const PlaneVector& from_axis, Position as_high) const;
  // Whether the point agrees with a point of the circle about the axis.
  bool on_circle(const Position& at, const Number& radius) const;
  // Whether it lies no deeper in the material than a circle, as far as the tolerance tells.
  bool is_free(const Position& at, const Number& radius) const;
  // J-THR-06: external, as far from the axis as rho_0 + J; internal, as near to it along p as
  // rho_0 - J. `side`, where it is not 0: exactly there, on that side along p.
  bool is_safe(const Position& at, int side) const;
  // J-THR-06: whether the point lies farther along p than the tool goes at an external thread. In a
  // bore the wall keeps it.
  bool is_beyond_reach(const Position& at) const;
  bool moves_depth_alone(const Motion& motion) const;
  bool moves_first_axis_alone(const Motion& motion) const;
  bool moves_in_plane(const Motion& motion) const;

  // Whether a motion, from that part of it on, keeps off the material that begins at the circle. A
  // traverse may go anywhere within its box.
  Clearance clearance(const Motion& motion, const Number& radius, const Number& part = 0) const;
  // The same for a chord that the certifier grants: it may cut deeper by that much.
  Clearance clearance_of_chord(const Motion& chord, const Number& radius,
                               const Number& part = 0) const;
  // Whether the motion stays within a circle about the axis; or within the circle whose diameter is
  // the line between two points.
  Clearance within(const Motion& motion, const Number& radius) const;
  Clearance within_chord(const Motion& motion, const PlaneVector& a, const PlaneVector& b) const;
  // J-THR-02, J-THR-06. How far from the axis the words lead: to the safe position of an external
  // thread, and a tool's diameter beyond.
  Number reach() const { return item_.start_radius + item_.runout_length + item_.tool_radius * 2; }

 private:
  struct Limit {
    Keep keep;
    PlaneVector middle;  // of its circle, from the axis
  };
  Clearance clearance_in(const Limit& limit, const Motion& motion, const Number& part) const;
  // A point that agrees on each axis lies up to sqrt(2) tau beyond a circle.
  Number slack() const { return Number::millionths(kDiagonal) * tolerances_.tolerance; }

  const reference::ThreadMilling& item_;
  const Tolerances& tolerances_;
  Tolerances loose_;
  reference::PlaneAxes axes_;
  int up_;  // sign of d from the bottom to the R plane
};

// K within a turn: the reading gsk.thread.k-range = table has more.
Number run_out_degrees(const reference::ThreadMilling& item);

// The value, or a rational within 2^-80 of it: values that are only enclosed cannot decide whether
// two points are one, or an arc is round.
PlaneVector near_rational(const PlaneVector& v);

}  // namespace gonogo::oracle
