// SPDX-License-Identifier: GPL-3.0-or-later
// The circles of G02 and G03, in the plane: places counted from the start of the arc.
#pragma once

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders {

inline constexpr Wide squared(Fixed value) {
  return static_cast<Wide>(value) * value;
}

/// From one point of the plane to another.
struct Chord {
  Fixed p = 0;
  Fixed q = 0;
  constexpr Wide square() const { return squared(p) + squared(q); }
};

enum class CircleDefect { kNone, kNoChord, kRadiusTooShort };

/// Centre, from the start, of the arc over `chord` with `radius` > 0: on the left of the chord for
/// a counterclockwise arc below 180 degrees, on the other side for one of: clockwise, `long_way`.
CircleDefect centre_from_radius(const Chord& chord, Fixed radius, bool counterclockwise,
                                bool long_way, Chord& centre);

/// Whether two radii, given by their squares, differ by no more than `tolerance`.
bool radii_agree(Wide start_square, Wide end_square, Fixed tolerance);

}  // namespace gonogo::expanders
