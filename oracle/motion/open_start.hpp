// SPDX-License-Identifier: GPL-3.0-or-later
//
// A curve whose start is open: it may begin anywhere on a circle, and every other point of it
// follows from the start by turning and scaling about the circle's centre. Each point that the
// subject shows narrows down where the start can be; the points agree with one and the same curve
// as long as a start is left.
#pragma once

#include <vector>

#include "oracle/motion/motion.hpp"

namespace gonogo::oracle {

// v -> (a v.p - b v.q, b v.p + a v.q): a turn with a scaling.
struct Similarity {
  Number a = 1;
  Number b = 0;
};
PlaneVector apply(const Similarity& map, const PlaneVector& v);
// The turn by `degrees`, counterclockwise as seen from +d.
Similarity turn_by(const Number& degrees);

class OpenStart {
 public:
  // The starts on the circle of `radius` about the origin.
  OpenStart(Number radius, Number tolerance);
  // Whether some start that is left maps to a point that agrees with `point` within the tolerance.
  // Throws exact::Undecided where that depends on the width of an enclosure.
  bool admits(const Similarity& map, const PlaneVector& point) const;
  // The same, and keeps only those starts. False (and unchanged) when none is left.
  bool narrow(const Similarity& map, const PlaneVector& point);

 private:
  // Convex, counterclockwise, rational; the starts are its points on the circle.
  using Polygon = std::vector<PlaneVector>;
  // The certain starts, and the possible ones: the same unless an enclosure has entered.
  struct Starts {
    Polygon sure;
    Polygon possible;
    bool is_certain = true;  // both are the same
  };
  Starts narrowed(const Similarity& map, const PlaneVector& point) const;
  bool meet_circle(const Starts& starts) const;
  bool meets_circle(const Polygon& polygon) const;

  Number radius_;
  Number tolerance_;
  Starts left_;
};

}  // namespace gonogo::oracle
