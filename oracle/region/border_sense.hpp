// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-12: motions along the border of the reachable area go round its middle one way.
#pragma once

#include "oracle/region/line.hpp"
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {

enum class Against { no, yes, undecided };

// How a motion runs along the border: as the sense says (1), back (-1), or not at all (0).
struct Course {
  int way = 0;
  bool is_sure = true;  // that it runs along it
  double least = 0;     // its length, where it runs along it
  double most = 0;
};

class BorderSense {
 public:
  // `border`: the area E of the tool's centre. `sense`: + counterclockwise. A motion runs along the
  // border when all of it lies within `width` of it.
  BorderSense(const RoundedRectangle& border, int sense, const Number& width);

  Course of_line(const Line& line) const;
  Course of_arc(const Arc& arc, bool counterclockwise) const;

  // For pieces in a row: whether one surely runs along the border, whether a place lies on it, and
  // how a way along it, if long enough, leads from one point to another.
  bool runs_along(const Line& line) const;
  bool touches(const PlanePoint& place) const;
  bool is_long_enough(const PlanePoint& from, const PlanePoint& to) const;
  Course between(const PlanePoint& from, const PlanePoint& to) const;

 private:
  struct Track;
  bool is_nearly_inside(const IntervalVector& point) const;
  int way_of(const Track& track) const;
  Against along(std::vector<Stretch> open, const Arc& arc) const;
  Against along(const LinePiece& piece) const;
  bool is_beside(const Line& line) const;

  int sense_;
  EnclosedRectangle border_;
  RoundedRectangle outer_;                 // within `width` of the border: in this
  std::optional<RoundedRectangle> inner_;  // and not in the inside of this; none: no direction
  EnclosedRectangle enclosed_inner_;
  double shortest_;  // no shorter motion has a direction
};

// J-PKT-06: how far the path has run back along the border since it was farthest on.
class WayBack {
 public:
  // What is too far lies between `least` and `most`.
  WayBack(const Number& least, const Number& most)
      : limit_(enclose(least).inf(), enclose(most).sup()) {}
  // Adds a motion and says whether the path has run back too far. `narrow` and `wide`: how it runs
  // along the border when that is taken as narrow and as wide as it may be.
  Against add(const Course& narrow, const Course& wide);

 private:
  Interval limit_;
  Interval back_{0.0};
};

}  // namespace gonogo::oracle::region
