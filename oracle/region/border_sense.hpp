// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-12: motions along the border of the reachable area go round its middle one way.
#pragma once

#include "oracle/region/line.hpp"
#include "oracle/region/piece.hpp"

namespace gonogo::oracle::region {

// Whether a motion goes along the border against the sense.
enum class Against { no, yes, undecided };

class BorderSense {
 public:
  // `border`: the area E of the tool's centre. `sense`: + counterclockwise. A motion runs along the
  // border when all of it lies within `width` of it.
  BorderSense(const RoundedRectangle& border, int sense, const Number& width);

  Against of_line(const Line& line) const;
  Against of_arc(const Arc& arc, bool counterclockwise) const;

  // Whether, of pieces in a row, one surely runs along the border, or a place lies on it, and
  // whether a way along it from one point to another, long enough, goes against the sense.
  bool runs_along(const Line& line) const;
  bool touches(const PlanePoint& place) const;
  bool is_long_enough(const PlanePoint& from, const PlanePoint& to) const;
  bool goes_against(const PlanePoint& from, const PlanePoint& to) const;

 private:
  struct Track;
  bool is_nearly_inside(const IntervalVector& point) const;
  bool goes_against(const Track& track) const;
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

}  // namespace gonogo::oracle::region
