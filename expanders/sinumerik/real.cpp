// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/sinumerik/real.hpp"

#include <cmath>
#include <numbers>

namespace gonogo::expanders::sinumerik {
namespace {

// The quarter turns nearest to `degrees`, 0 to 3, and what is left, -45 to 45 degrees. Angles come
// from sums in binary64: what is less than their error is nothing.
int split_quarters(Real degrees, Real& rest) {
  constexpr Real kNothing = 90 * 4 * std::numeric_limits<double>::epsilon();
  const Real turn = std::fmod(degrees, Real{360});
  const Real quarters = std::nearbyint(turn / 90);
  rest = turn - 90 * quarters;
  if (std::fabs(rest) <= kNothing) rest = 0;
  return static_cast<int>(quarters) & 3;
}

}  // namespace

Direction2 direction_of(Real degrees) {
  Real rest = 0;
  const int quarters = split_quarters(degrees, rest);
  const Real radians = rest * (std::numbers::pi_v<Real> / 180);
  const Real cosine = std::cos(radians);
  const Real sine = std::sin(radians);
  switch (quarters) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

Wide to_whole(Real value) {
  constexpr Real kFixed = 9e18L;
  // Beyond that a Real of 64 digits is whole.
  return std::fabs(value) < kFixed ? Wide{std::llround(value)} : static_cast<Wide>(value);
}

}  // namespace gonogo::expanders::sinumerik
