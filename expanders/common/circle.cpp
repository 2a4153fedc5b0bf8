// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/circle.hpp"

#include <cmath>

namespace gonogo::expanders {

CircleDefect centre_from_radius(const Chord& chord, Fixed radius, bool counterclockwise,
                                bool long_way, Chord& centre) {
  const Wide chord_square = chord.square();
  if (chord_square == 0) return CircleDefect::kNoChord;
  const Wide rest = 4 * squared(radius) - chord_square;
  if (rest < 0) return CircleDefect::kRadiusTooShort;
  // Distance of the centre from the middle of the chord, in half chords.
  const double ratio = std::sqrt(static_cast<double>(rest) / static_cast<double>(chord_square));
  const double side = counterclockwise == long_way ? -ratio : ratio;
  const auto p = static_cast<double>(chord.p);
  const auto q = static_cast<double>(chord.q);
  centre.p = std::llround((p - side * q) / 2);
  centre.q = std::llround((q + side * p) / 2);
  return CircleDefect::kNone;
}

bool radii_agree(Wide start_square, Wide end_square, Fixed tolerance) {
  if (tolerance == 0 || start_square == end_square) return start_square == end_square;
  constexpr long double kRounding = 1e-3L;
  const long double start = std::sqrt(static_cast<long double>(start_square));
  const long double end = std::sqrt(static_cast<long double>(end_square));
  return std::fabs(start - end) <= static_cast<long double>(tolerance) + kRounding;
}

}  // namespace gonogo::expanders
