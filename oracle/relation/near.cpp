// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/relation/near.hpp"

#include <algorithm>

namespace gonogo::relation {

using reference::Axis;
using reference::kAllAxes;

Position point_at(const Event& piece, const Number& part) {
  Position point;
  for (const Axis axis : kAllAxes) {
    point[axis] = piece.from[axis] + (piece.to[axis] - piece.from[axis]) * part;
  }
  return point;
}

bool is_near(const Position& a, const Position& b, const Number& tolerance) {
  return std::ranges::all_of(kAllAxes, [&](Axis axis) {
    const Number apart = a[axis] - b[axis];
    return apart <= tolerance && -apart <= tolerance;
  });
}

std::optional<Part01> near_part(const Event& piece, const Position& place,
                                const Number& tolerance) {
  Part01 part;
  for (const Axis axis : kAllAxes) {
    const Number& from = piece.from[axis];
    const Number& to = piece.to[axis];
    const Number low = place[axis] - tolerance;
    const Number high = place[axis] + tolerance;
    if (max(from, to) < low || min(from, to) > high || low > high) return std::nullopt;
    const bool rises = from <= to;
    // Where it comes near on this axis, and where it leaves.
    const Number& entry = rises ? low : high;
    const Number& exit = rises ? high : low;
    if (rises ? from < entry : from > entry) part.low = max(part.low, (entry - from) / (to - from));
    if (rises ? to > exit : to < exit) part.high = min(part.high, (exit - from) / (to - from));
  }
  if (part.low > part.high) return std::nullopt;
  return part;
}

}  // namespace gonogo::relation
