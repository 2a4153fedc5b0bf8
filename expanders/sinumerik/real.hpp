// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers of directions and circles, between whole counts.
#pragma once

#include <algorithm>
#include <array>
#include <limits>

#include "expanders/common/axes.hpp"

namespace gonogo::expanders::sinumerik {

/// A flat arc magnifies the error of its direction by the square of radius over chord: no digit of
/// the processor is spared.
using Real = long double;

/// Whole numbers up to this are Reals without error, and products of two are Wide.
inline constexpr Fixed kLargestWhole = Fixed{1} << std::min(62, std::numeric_limits<Real>::digits);

/// What rounding to counts took from a place, along each axis: the place meant is their sum.
using Remainder = std::array<Real, GONOGO_AXES>;

/// Lengths from angles, roots and long decimals are right to a count or two: differences up to this
/// are none.
inline constexpr Fixed kRounding = 4;
/// As much of an angle, in radians.
inline constexpr Real kAngleDoubt = kRounding * 1.8e-11L;

/// What is not known to less than this, in counts, is not put out: half the finest resolution.
inline constexpr Real kSharp = 4e-4L * kOne;

/// Cosine and sine of an angle.
struct Direction2 {
  Real cosine;
  Real sine;
};

/// Of an angle in degrees; exact for whole quarter turns.
Direction2 direction_of(Real degrees);

/// `value`, below 2^126, to the nearest whole number.
Wide to_whole(Real value);

}  // namespace gonogo::expanders::sinumerik
