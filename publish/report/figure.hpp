// SPDX-License-Identifier: GPL-3.0-or-later
//
// A figure for a page of text: one path, or two over each other, in the views of a drawing sheet,
// with its legend below; small enough to be read in a column.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "publish/report/path.hpp"
#include "reference/outcome.hpp"

namespace gonogo::oracle::report {

// What a tool clears at one depth.
struct PocketFloor {
  std::uint64_t block = 0;
  reference::Plane plane = reference::Plane::g17;
  double depth = 0;  // coordinate of the depth axis, mm
  double tool_radius = 0;
  // Where its levels are free: the coordinate where they begin; `depth` is then that of the floor.
  std::optional<double> top = std::nullopt;
};

// A line that is no motion: the border of what may be cut, or how far the tool's centre may go.
struct Limit {
  enum class Kind : std::uint8_t { border, reach };
  Kind kind = Kind::border;
  std::string text;  // of the legend, which names equal ones once
  std::vector<Point3> points;
  std::optional<PocketFloor> level = std::nullopt;  // of the border of a pocket
};
// What a manual fixes where it leaves the path of an item open; none for one whose path is given.
std::vector<Limit> limits_of(const reference::Item& item);

struct Figure {
  std::string title;
  bool lathe = false;           // Z to the right, X up
  const Path* path = nullptr;   // drawn broad; required
  std::string path_name;        // empty: "path"
  const Path* other = nullptr;  // drawn fine above it; null: one path
  std::string other_name;
  std::vector<Limit> limits;
};

// Motions are numbered in a figure of one path with at most this many.
inline constexpr std::size_t kMostNumbered = 16;
// The numbers that the motions of a path have in its figure, 0 for what does not move; all 0 where
// there are too many.
std::vector<std::size_t> motion_numbers(const Path& path);

// The id that the sheet of a pocket uses in its document: a page of several gives each its own.
inline constexpr std::string_view kPocketClip = "gs-pocket";

// A well-formed SVG document; empty when no linear axis moves.
std::string svg_figure(const Figure& figure);

}  // namespace gonogo::oracle::report
