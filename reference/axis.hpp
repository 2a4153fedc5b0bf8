// SPDX-License-Identifier: GPL-3.0-or-later
//
// Axes, planes as one permutation of the linear axes, and positions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "reference/exact/number.hpp"

namespace gonogo::reference {

using exact::Number;

enum class Axis : std::uint8_t { x, y, z, a, c };
inline constexpr std::size_t kAxes = 5;
inline constexpr std::array<Axis, kAxes> kAllAxes = {Axis::x, Axis::y, Axis::z, Axis::a, Axis::c};
inline constexpr std::array<Axis, 3> kLinearAxes = {Axis::x, Axis::y, Axis::z};

constexpr std::size_t index(Axis axis) {
  return static_cast<std::size_t>(axis);
}
constexpr char letter(Axis axis) {
  return "xyzac"[index(axis)];
}
constexpr bool is_linear(Axis axis) {
  return index(axis) < 3;
}

// A set of axes.
class AxisSet {
 public:
  constexpr AxisSet() = default;
  constexpr AxisSet(std::initializer_list<Axis> axes) {
    for (Axis axis : axes) add(axis);
  }
  constexpr void add(Axis axis) { bits_ = static_cast<std::uint8_t>(bits_ | 1U << index(axis)); }
  constexpr bool has(Axis axis) const { return (bits_ >> index(axis) & 1U) != 0; }
  constexpr bool empty() const { return bits_ == 0; }
  constexpr AxisSet operator|(AxisSet other) const {
    AxisSet both;
    both.bits_ = static_cast<std::uint8_t>(bits_ | other.bits_);
    return both;
  }
  friend constexpr bool operator==(AxisSet, AxisSet) = default;

 private:
  std::uint8_t bits_ = 0;
};
inline constexpr AxisSet kEveryAxis = {Axis::x, Axis::y, Axis::z, Axis::a, Axis::c};

// A point of the machine: mm as true lengths (X of a lathe is a radius), degrees for a and c.
struct Position {
  std::array<Number, kAxes> at;
  Number& operator[](Axis axis) { return at[index(axis)]; }
  const Number& operator[](Axis axis) const { return at[index(axis)]; }
  friend bool operator==(const Position&, const Position&) = default;
};

enum class Plane : std::uint8_t { g17, g18, g19 };
constexpr int plane_code(Plane plane) {
  return 17 + static_cast<int>(plane);
}

// (p, q, d): first and second plane axis and depth axis, a right-handed triple in every plane.
struct PlaneAxes {
  Axis p;
  Axis q;
  Axis d;
};
constexpr PlaneAxes axes_of(Plane plane) {
  constexpr std::array<PlaneAxes, 3> kTable = {
      {{Axis::x, Axis::y, Axis::z}, {Axis::z, Axis::x, Axis::y}, {Axis::y, Axis::z, Axis::x}}};
  return kTable[static_cast<std::size_t>(plane)];
}

}  // namespace gonogo::reference
