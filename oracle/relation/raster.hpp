// SPDX-License-Identifier: GPL-3.0-or-later
//
// R8, cover: whether a region of a plane lies within reach of a path, by halving squares until one
// piece reaches all of a square, none reaches its middle, or the square is no larger than the
// raster. Places are whole numbers of a unit, far below tau.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "oracle/relation/winding.hpp"

namespace gonogo::relation {

struct Point {
  std::int64_t p = 0;
  std::int64_t q = 0;
};
struct Stroke {
  Point from;
  Point to;
};
// Whether a stroke comes within `reach` of a place.
bool is_within(const Point& place, const Stroke& stroke, std::int64_t reach);

// REQUIRES: nothing that is put on it is farther from the middle than the extent.
class Raster {
 public:
  explicit Raster(const Number& extent);
  Point point(const Offset& offset) const { return {length(offset.p), length(offset.q)}; }
  std::int64_t length(const Number& number) const;

 private:
  Number scale_;  // units of a mm
};

// A rectangle about the middle with round corners, which may be a circle; a region is one of these
// less one within it.
struct Box {
  std::int64_t half_p = 0;
  std::int64_t half_q = 0;
  std::int64_t corner = 0;
  // Whether it has a place of the square about `at`; whether it has the whole square.
  bool meets(const Point& at, std::int64_t half) const;
  bool has(const Point& at, std::int64_t half) const;
};
struct Region {
  Box outer;
  std::optional<Box> inner;
};
// All places no farther than `reach` from a stroke.
struct Stadium {
  Stroke stroke;
  std::int64_t reach = 0;
};

// `near`: the answer lies within the raster.
enum class Said : std::uint8_t { yes, no, near };
struct Cover {
  std::span<const Stroke> path;
  std::int64_t reach = 0;
  std::int64_t slack = 0;           // by which the strokes may be off
  std::int64_t raster = 1;          // half of the smallest square
  std::optional<Box> cleared = {};  // what is reached without a stroke
  Said of(const Region& region) const;
  Said of(const Stadium& stadium) const;
};

}  // namespace gonogo::relation
