// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "expanders/common/fixed.hpp"
#include "gonogo/subject.h"

namespace gonogo::expanders {

/// A coordinate of each axis, in the order of gonogo_axis; true lengths in mm, degrees.
using Point = std::array<Fixed, GONOGO_AXES>;

/// A set of axes, one bit each.
using Axes = unsigned;
inline constexpr Axes axis_bit(std::size_t axis) {
  return 1u << axis;
}
inline constexpr Axes kAllAxes = (1u << GONOGO_AXES) - 1u;

/// The axes of a plane: first, second, and the one normal to it (indices into Point).
struct Plane {
  int number;
  std::size_t p;
  std::size_t q;
  std::size_t d;
};

inline constexpr Plane kPlanes[] = {{17, GONOGO_X, GONOGO_Y, GONOGO_Z},
                                    {18, GONOGO_Z, GONOGO_X, GONOGO_Y},
                                    {19, GONOGO_Y, GONOGO_Z, GONOGO_X}};

inline constexpr const Plane& plane_of(int number) {
  return kPlanes[number - 17];
}

}  // namespace gonogo::expanders
