// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-06: how far the path of a level goes back round the middle of its pocket, apart from the
// way in which each of its arcs turns.
#pragma once

#include "oracle/region/border_sense.hpp"

namespace gonogo::oracle::region {

// The angle swept about the middle by the motions of a level, in the order of time.
class Winding {
 public:
  // `sense`: + counterclockwise. A straight motion longer than `longest`, or across more than an
  // eighth of a turn, travels, and counts only where it leads the commanded way. What begins or
  // ends no farther from the middle than `blur` has no direction about it.
  Winding(const PlanePoint& middle, int sense, const Number& longest, const Number& blur);

  // Whether the path has gone back by more than three quarters of a turn, with this motion.
  Against add(const LevelMotion& motion);

 private:
  double angle_of(const LevelMotion& motion) const;

  PlanePoint middle_;
  int sense_;
  double longest_;
  double blur_;
  double back_ = 0;  // since the path was farthest on; an angle
};

}  // namespace gonogo::oracle::region
