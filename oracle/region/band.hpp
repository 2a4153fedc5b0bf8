// SPDX-License-Identifier: GPL-3.0-or-later
//
// The closed sets within reach of the path, as discs, sectors of rings and capsules: what must
// cover the target. The band of a line is its capsule, that of a round arc its sector and the discs
// about its ends, exactly; a spiral is cut into sectors that lie within reach of it, and the discs
// about the joints. What an earlier level cleared is a band of its own, a rounded rectangle.
#pragma once

#include <cstdint>
#include <vector>

#include "oracle/region/constants.hpp"
#include "oracle/region/distance.hpp"
#include "oracle/region/rectangle.hpp"

namespace gonogo::oracle::region {

// What an earlier level cleared.
struct Cleared {
  RoundedRectangle exact;
  EnclosedRectangle enclosed;
};

struct Band {
  enum class Shape : std::uint8_t { disc, ring, sector, capsule, rectangle } shape = Shape::disc;
  bool wide = false;       // sector: more than 180 degrees
  IntervalVector c{0, 0};  // capsule: where its line begins
  Interval inner = 0;      // radii; without a hole: 0 or less
  Interval outer;          // capsule: half its width; rectangle: the radius of its corners
  IntervalVector ua;       // sector: its directions, counterclockwise; capsule: the line's
  IntervalVector ub;
  IntervalVector to;    // capsule: where its line ends
  Interval length = 0;  // of that line
  // The exact middle line, a circle (a point: radius 0). The centre is null for the joints of
  // spirals, the squared radius for all their parts. Owned by the path, the points, or static.
  const PlanePoint* centre = nullptr;
  const Number* radius2 = nullptr;
  const Sweep* sweep = nullptr;      // sector of a round arc
  const Line* line = nullptr;        // capsule
  const Cleared* cleared = nullptr;  // rectangle

  Interval inner2 = 0;
  Interval outer2;
  std::uint32_t unit = 0;  // of a path in the order of time (order.hpp): which part of it

  // After `inner` and `outer`.
  void square_radii() {
    inner2 = square(CGAL::max(inner, Interval(0)));
    outer2 = square(outer);
  }
  bool has_hole() const { return inner.sup() > 0; }
  const EnclosedRectangle& rectangle() const { return cleared->enclosed; }
};

// The path's end points, so that bands may refer to them; and the bands.
struct Bands {
  std::vector<PlanePoint> points;
  std::vector<Band> bands;
};

// The bands of the path. A spiral is cut until the radius changes by no more than `width` in a
// part. Nothing when that takes more than kMaximumBands.
std::optional<Bands> make_bands(const Path& path, const Number& reach, double width);

// Adds what was cleared before, which must outlive the bands.
void add_cleared(Bands& bands, const Cleared& cleared);

// Appends the bands of a stretch of an arc, less the discs about its ends; they know no exact
// middle line. False when they are too many.
bool append_stretch(const Arc& arc, const Stretch& stretch, Interval reach, double width,
                    std::vector<Band>& out);
// The band of a line that is known by its enclosures only, with the discs about its ends.
void append_line(const IntervalVector& from, const IntervalVector& to, Interval reach,
                 std::vector<Band>& out);
// The disc about a point.
Band disc_about(const IntervalVector& point, Interval reach);

// About how far the point is outside the band (negative: inside). Doubles: a hint only.
double rough_distance(const Band& band, double x, double y);

}  // namespace gonogo::oracle::region
