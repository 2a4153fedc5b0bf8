// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles in degrees. Exact at the multiples of 30 and 45 degrees; everything else is brought to
// one octant, so that equal values are equal expressions.
#include <stdexcept>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::exact {
namespace {

enum class Wave : std::uint8_t { cosine, sine };

Wave other(Wave wave) {
  return wave == Wave::cosine ? Wave::sine : Wave::cosine;
}

// For any angle.
Number enclosed_wave(Wave wave, const Number& degrees) {
  return enclosure(wave == Wave::cosine ? Operation::cos_degrees : Operation::sin_degrees, degrees);
}

// For a rational angle in [0, 45].
Number wave_of_octant(Wave wave, const Number& degrees) {
  const Number half = Number::millionths(500'000);
  if (degrees == Number(0)) return wave == Wave::cosine ? 1 : 0;
  if (degrees == Number(30)) return wave == Wave::cosine ? Number::root(0, half, 3) : half;
  if (degrees == Number(45)) return Number::root(0, half, 2);
  return enclosed_wave(wave, degrees);
}

// A rational angle: quarters of a turn, 0 to 3, and degrees in [0, 90).
struct Reduced {
  std::int64_t quadrant;
  Number degrees;
};

Reduced reduced(const Number& degrees) {
  const Number quarters = (degrees / Number(90)).floor();
  const Number quadrant = quarters - (quarters / Number(4)).floor() * Number(4);
  return {*quadrant.to_int64(), degrees - quarters * Number(90)};
}

Number wave_of(Wave wave, const Reduced& angle) {
  const auto [quadrant, degrees] = angle;
  const Wave in_quadrant = quadrant % 2 == 0 ? wave : other(wave);
  const Number value = degrees <= Number(45)
                           ? wave_of_octant(in_quadrant, degrees)
                           : wave_of_octant(other(in_quadrant), Number(90) - degrees);
  const bool is_negative = wave == Wave::cosine ? quadrant == 1 || quadrant == 2 : quadrant >= 2;
  return is_negative ? -value : value;
}

// For any angle, in the one form.
Number wave_of(Wave wave, const Number& degrees) {
  return degrees.is_rational() ? wave_of(wave, reduced(degrees)) : enclosed_wave(wave, degrees);
}

// The angle in (-90, 90) whose tangent is `slope`.
Number arc_tangent(const Number& slope) {
  if (slope.form() != Number::Form::enclosure) {
    const int sign = slope.sign();
    const Number square = slope * slope;
    if (sign == 0) return 0;
    if (square == Number(1)) return 45 * sign;
    if (square == Number(3)) return 60 * sign;
    if (square * Number(3) == Number(1)) return 30 * sign;
  }
  return enclosure(Operation::atan_degrees, slope);
}

}  // namespace

std::array<Number, 2> cos_sin_degrees(const Number& degrees) {
  if (!degrees.is_rational()) {
    return {enclosed_wave(Wave::cosine, degrees), enclosed_wave(Wave::sine, degrees)};
  }
  const Reduced angle = reduced(degrees);
  return {wave_of(Wave::cosine, angle), wave_of(Wave::sine, angle)};
}

Number cos_degrees(const Number& degrees) {
  return wave_of(Wave::cosine, degrees);
}

Number sin_degrees(const Number& degrees) {
  return wave_of(Wave::sine, degrees);
}

Number angle_degrees(const Number& x, const Number& y) {
  const std::optional<int> sign_y = y.try_sign();
  if (sign_y && *sign_y != 0) return Number(*sign_y > 0 ? 90 : 270) - arc_tangent(x / y);
  // Near the x axis: on its positive half 0 and 360 meet, so there y must be known to be zero.
  const int sign_x = x.sign();
  if (sign_y && sign_x == 0) throw std::domain_error("exact: the angle of a vector of length zero");
  if (sign_x < 0) return sign_y ? Number(180) : Number(180) + arc_tangent(y / x);
  if (!sign_y) throw Undecided("exact: an angle is 0 or just below 360 degrees");
  return 0;
}

}  // namespace gonogo::exact
