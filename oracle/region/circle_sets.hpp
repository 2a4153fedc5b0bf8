// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact Boolean operations on sets bounded by circles and lines. Only the .cpp knows CGAL.
#pragma once

#include <array>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

// A ring, a disc (inner = 0) or a sector of either. All numbers rational, 0 <= inner < outer.
struct CircleShape {
  PlanePoint centre;
  Number inner;
  Number outer;
  // Sector: unit directions, counterclockwise from the first, less than 180 degrees apart.
  std::optional<std::array<PlanePoint, 2>> sweep;
};

// Within a capsule: the points on the left and the right of a line, seen along the normal, and half
// discs about its ends. The capsule itself when the normal is perpendicular to the line.
struct CapsuleShape {
  PlanePoint from;
  PlanePoint to;
  PlanePoint normal;  // unit, nearly perpendicular, to the left
  Number radius;      // > 0
};

// A rounded rectangle has a radius above 0 here.
using Shape = std::variant<CircleShape, CapsuleShape, RoundedRectangle>;

// The upright square that a local question is asked for.
struct Window {
  PlanePoint centre;
  Number half;
};

// What is left of the area (in the window) when all shapes are taken away.
struct Remainder {
  bool empty = true;
  std::vector<std::array<double, 2>> samples;  // points that may lie in it
};

class CircleSetsError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Throws CircleSetsError when CGAL gives up.
Remainder uncovered_remainder(const RoundedRectangle& area, const std::optional<Window>& window,
                              const std::vector<Shape>& shapes);

}  // namespace gonogo::oracle::region
