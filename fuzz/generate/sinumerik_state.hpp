// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a generated SINUMERIK program has come to. Places are known near enough to keep off the
// points where rounding decides, and exactly where they are decimals.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace gonogo::generate {

// Along one axis: millimetres, and the exact count of 0.0001 mm where there is one.
struct Coordinate {
  double mm = 0;
  std::optional<std::int64_t> steps = 0;

  static Coordinate exactly(std::int64_t steps) {
    return {static_cast<double>(steps) / 10'000, steps};
  }
  static Coordinate about(double mm) { return {mm, std::nullopt}; }
  Coordinate moved(std::int64_t by) const {
    return {mm + static_cast<double>(by) / 10'000,
            steps ? std::optional(*steps + by) : std::nullopt};
  }
};

using Place = std::array<Coordinate, 3>;  // X Y Z
using Direction = std::array<double, 3>;

// The axes of a plane: the pair in which G3 turns the first to the second, and the third.
struct PlaneOf {
  std::size_t p;
  std::size_t q;
  std::size_t d;
};
constexpr PlaneOf plane_of(int code) {
  if (code == 18) return {2, 0, 1};
  if (code == 19) return {1, 2, 0};
  return {0, 1, 2};
}

// sinumerik802s: a place of the base system is the translation and the place turned.
struct SinumerikFrame {
  Place translation;
  int plane = 17;
  std::int64_t angle = 0;  // 0.001 degrees, in [0, 360000)
};

struct SinumerikState {
  bool known = true;  // where the tool stands
  Place at;
  bool inch = false;
  bool incremental = false;
  int plane = 17;
  SinumerikFrame frame;
  int motion = -1;  // 0 to 3, 4: CIP, 5: CT; -1: none was written
  bool moved = false;
  // The direction of the last motion at its end.
  std::optional<Direction> tangent;
  // Its exact way, of a line, in 0.0001 mm.
  std::optional<std::array<std::int64_t, 3>> way;
  int helix_in = 0;  // it was a helix in this plane; 0: none
  // Something was put wrong, and the program went on: the places are not those of the tool.
  bool astray = false;
  // The pole, along the axes of the plane, and the last angle (0.001 degrees) and radius (0.0001
  // mm) about it, where a word may leave them out.
  std::array<Coordinate, 2> pole;
  // By how many steps the tool stands from it, where that is a decimal though the places are not.
  std::optional<std::array<std::int64_t, 2>> spoke;
  std::optional<std::int64_t> angle;
  std::optional<std::int64_t> radius;
  bool at_polar = false;   // the tool stands at that angle and radius
  std::int64_t speed = 0;  // S in force; 0: not known
  bool has_m6 = false;     // no text says which tool a T without M6 leaves in force then
  // R parameters in thousandths.
  std::map<int, std::int64_t> parameters;

  // Counts of a word, 0.001 mm or inch, are so many steps.
  std::int64_t steps_of_count() const { return inch ? 254 : 10; }
  double mm_of_count() const { return inch ? 0.0254 : 0.001; }
  bool exact(std::size_t axis) const { return at[axis].steps.has_value(); }
};

}  // namespace gonogo::generate
