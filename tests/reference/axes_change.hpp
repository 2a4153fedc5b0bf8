// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same program in other axes: renamed, mirrored, turned by quarters, elsewhere, larger.
#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "reference/axis.hpp"

namespace gonogo::reference::testing {

using Vector = std::array<std::int64_t, 3>;  // along X Y Z, in thousandths

inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

// Axis i becomes axis[i] times sign[i] times scale, plus shift[axis[i]].
struct AxesChange {
  std::array<std::size_t, 3> axis = {0, 1, 2};
  std::array<int, 3> sign = {1, 1, 1};
  Vector shift = {0, 0, 0};
  int scale = 1;

  Vector direction(const Vector& v) const {
    Vector result{};
    for (std::size_t i = 0; i < 3; ++i) result[axis[i]] = v[i] * sign[i] * scale;
    return result;
  }
  Vector point(const Vector& v) const { return direction(v) + shift; }
  // A coordinate along the old axis, along the new one.
  Number coordinate(std::size_t old_axis, const Number& value) const {
    return value * (sign[old_axis] * scale) + Number(shift[axis[old_axis]]) / 1'000;
  }
  Plane plane(Plane old) const {
    static constexpr Plane kByThirdAxis[] = {Plane::g19, Plane::g18, Plane::g17};
    return kByThirdAxis[axis[index(axes_of(old).d)]];
  }
  // Whether the first axis of the old plane becomes the first of the new one, not the second.
  bool in_order(Plane old) const {
    return axis[index(axes_of(old).p)] == index(axes_of(plane(old)).p);
  }
  // -1: arcs in the plane change their sense.
  int sense(Plane old) const {
    const PlaneAxes axes = axes_of(old);
    return sign[index(axes.p)] * sign[index(axes.q)] * (in_order(old) ? 1 : -1);
  }
  // An angle from the first axis of the plane, in thousandths of a degree, within a turn.
  std::int64_t angle(Plane old, std::int64_t value) const {
    const std::int64_t first =
        (in_order(old) ? 0 : 90'000) + (sign[index(axes_of(old).p)] < 0 ? 180'000 : 0);
    return (first + sense(old) * value) % 360'000;
  }
};

inline std::int64_t any_between(std::int64_t low, std::int64_t high) {
  return *rc::gen::inRange(low, high + 1);
}
inline Vector any_shift() {
  return {any_between(-90'000, 90'000), any_between(-90'000, 90'000), any_between(-90'000, 90'000)};
}
// One of the 48 symmetries of the axes.
inline AxesChange any_symmetry() {
  AxesChange change;
  for (std::int64_t swaps = any_between(0, 5); swaps > 0; --swaps) {
    std::next_permutation(change.axis.begin(), change.axis.end());
  }
  for (int& sign : change.sign) sign = any_between(0, 1) == 1 ? 1 : -1;
  return change;
}

}  // namespace gonogo::reference::testing
