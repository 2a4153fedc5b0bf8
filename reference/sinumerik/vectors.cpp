// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/sinumerik/machine.hpp"

namespace gonogo::reference::sinumerik {

bool any_nonzero(std::initializer_list<Number> numbers) {
  bool undecided = false;
  for (const Number& number : numbers) {
    const std::optional<int> sign = number.try_sign();
    if (sign.value_or(0) != 0) return true;
    undecided = undecided || !sign;
  }
  if (undecided) throw exact::Undecided("exact: whether a vector is zero");
  return false;
}

Vector_2 from_centre_to_end(const PlaneAxes& axes, const Point_2& centre, const Vector_2& offset,
                            const EndPoint& end) {
  const auto along = [&](int i, Axis axis) {
    const bool is_absolute = centre[i].is_rational() && end.to[axis].is_rational();
    return is_absolute ? end.to[axis] - centre[i] : end.by[axis] - offset[i];
  };
  return {along(0, axes.p), along(1, axes.q)};
}

bool surely_equal(const Point_2& a, const Point_2& b) {
  try {
    return a == b;
  } catch (const exact::Undecided&) {
    return false;
  }
}

}  // namespace gonogo::reference::sinumerik
