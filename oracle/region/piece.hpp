// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is certain about a whole piece of a circle or of a line: the filter stands on these.
#pragma once

#include "oracle/region/band.hpp"

namespace gonogo::oracle::region {

// From a to b, straight.
struct LinePiece {
  IntervalVector a;
  IntervalVector b;
};

// Every point at least as far from the origin as the square root of `radius2`.
bool lies_outside(const CirclePiece& piece, Interval radius2);
// No point in the inside of the rounded rectangle.
bool lies_outside(const CirclePiece& piece, const EnclosedRectangle& shape);
bool lies_outside(const LinePiece& piece, const EnclosedRectangle& shape);
// Every point strictly within the sweep of the band, if it has one.
bool lies_within_sweep(const CirclePiece& piece, const Band& band);
// Every point in the inside of the band.
bool lies_inside(const CirclePiece& piece, const Band& band);
bool lies_inside(const LinePiece& piece, const Band& band);

}  // namespace gonogo::oracle::region
