// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-10: whether a level mills the floor, where only the contour is to be milled.
#pragma once

#include "oracle/region/distance.hpp"
#include "oracle/region/rectangle.hpp"

namespace gonogo::oracle::region {

class MilledFloor {
 public:
  // `area`: of the floor. `roughed`: where the centre of a tool of that radius goes without
  // touching the strip of the contour. The infeed is in the middle of both.
  MilledFloor(const RoundedRectangle& area, const Number& radius, const RoundedRectangle& roughed)
      : area_(area), radius_(radius), roughed_(enclose(roughed)) {}

  void add(const LevelMotion& motion);
  // A milled place of the floor, where too much of it is milled: in what roughing left the path is
  // longer than twice the way to the contour and back, and mills more than half of the rest of the
  // floor, or more than the tool does along that way.
  std::optional<PlanePoint> milled_place() const;

 private:
  void add_way(const IntervalVector& from, const IntervalVector& to);
  bool is_milled(const PlanePoint& place) const;

  RoundedRectangle area_;
  Number radius_;
  EnclosedRectangle roughed_;
  Path path_;                           // its lines and round arcs
  std::vector<IntervalVector> places_;  // of spirals
  Interval way_ = 0;                    // at least
};

}  // namespace gonogo::oracle::region
