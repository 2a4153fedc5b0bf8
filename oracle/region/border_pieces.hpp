// SPDX-License-Identifier: GPL-3.0-or-later
//
// The border of one band as pieces to walk, less what lies outside the area as a whole; and the
// questions about borders that only exact arithmetic decides: those of borders that touch.
#pragma once

#include "oracle/region/border.hpp"

namespace gonogo::oracle::region {

// Appends the pieces of the band's outside (or of its hole), none longer than 90 degrees.
void append_border(const Band& band, bool hole, const Target& target, const EnclosedRectangle& area,
                   std::vector<BorderPiece>& out);

// The outside of `small` is the hole of `large`: one circle.
bool abut_exactly(const Band& small, const Band& large, const Number& reach);
// The edge of one capsule on that side is an edge of the other, which lies beyond it.
bool abut_exactly(const Band& capsule, BorderPiece::Side side, const Band& other,
                  const Number& reach);

}  // namespace gonogo::oracle::region
