// SPDX-License-Identifier: GPL-3.0-or-later
//
// Angles in degrees. Exact at the multiples of 30 and 45 degrees; everything else is brought to
// one octant, so that equal values are equal expressions.
#include <stdexcept>

#include "reference/exact/enclosure.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::exact {
namespace {

// cos and sin of a rational angle in [0, 45].
std::array<Number, 2> cos_sin_of_octant(const Number& degrees) {
  const Number half = Number::millionths(500'000);
  if (degrees == Number(0)) return {1, 0};
  if (degrees == Number(30)) return {Number::root(0, half, 3), half};
  if (degrees == Number(45)) return {Number::root(0, half, 2), Number::root(0, half, 2)};
  return {enclosure(Operation::cos_degrees, degrees), enclosure(Operation::sin_degrees, degrees)};
}

// The same in [0, 90].
std::array<Number, 2> cos_sin_of_quadrant(const Number& degrees) {
  if (degrees <= Number(45)) return cos_sin_of_octant(degrees);
  const auto [cosine, sine] = cos_sin_of_octant(Number(90) - degrees);
  return {sine, cosine};
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

std::optional<int> try_sign(const Number& value) {
  return enclosure_node(value) != nullptr ? try_sign_of_enclosure(value) : value.sign();
}

}  // namespace

std::array<Number, 2> cos_sin_degrees(const Number& degrees) {
  if (!degrees.is_rational()) {
    return {enclosure(Operation::cos_degrees, degrees), enclosure(Operation::sin_degrees, degrees)};
  }
  const Number quarters = (degrees / Number(90)).floor();
  const Number quadrant = quarters - (quarters / Number(4)).floor() * Number(4);
  const auto [cosine, sine] = cos_sin_of_quadrant(degrees - quarters * Number(90));
  switch (*quadrant.to_int64()) {
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

Number angle_degrees(const Number& x, const Number& y) {
  const std::optional<int> sign_y = try_sign(y);
  if (sign_y && *sign_y != 0) return Number(*sign_y > 0 ? 90 : 270) - arc_tangent(x / y);
  // Near the x axis: on its positive half 0 and 360 meet, so there y must be known to be zero.
  const int sign_x = x.sign();
  if (sign_y && sign_x == 0) throw std::domain_error("exact: the angle of a vector of length zero");
  if (sign_x < 0) return sign_y ? Number(180) : Number(180) + arc_tangent(y / x);
  if (!sign_y) throw Undecided("exact: an angle is 0 or just below 360 degrees");
  return 0;
}

}  // namespace gonogo::exact
