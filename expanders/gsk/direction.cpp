// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/gsk/direction.hpp"

#include <cmath>
#include <numbers>

namespace gonogo::expanders::gsk {
namespace {

// `part` / `whole` of a right angle. 60 and 30 degrees stay exact: there run-outs become straight.
Direction within_right_angle(Fixed part, Fixed whole) {
  constexpr long double kRootOfThreeQuarters = std::numbers::sqrt3_v<long double> / 2;
  if (part == 0) return {1, 0};
  if (static_cast<Wide>(part) * 3 == whole) return {kRootOfThreeQuarters, 0.5L};
  if (static_cast<Wide>(part) * 3 == static_cast<Wide>(whole) * 2) {
    return {0.5L, kRootOfThreeQuarters};
  }
  const long double angle = static_cast<long double>(part) / static_cast<long double>(whole) *
                            (std::numbers::pi_v<long double> / 2);
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

Direction direction_of(Fixed part, Fixed whole) {
  const Wide quarters = static_cast<Wide>(part) * 4;
  Direction direction = within_right_angle(static_cast<Fixed>(quarters % whole), whole);
  for (auto quarter = static_cast<int>(quarters / whole); quarter > 0; --quarter) {
    direction = {-direction.sine, direction.cosine};
  }
  return direction;
}

Direction turned(const Direction& from, const Direction& by, int sense) {
  const long double sine = sense < 0 ? -by.sine : by.sine;
  return {from.cosine * by.cosine - from.sine * sine, from.sine * by.cosine + from.cosine * sine};
}

}  // namespace gonogo::expanders::gsk
