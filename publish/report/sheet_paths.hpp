// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths in a view of a drawing: their motions by style, arrowheads, start and end. Private to the
// drawings.
#pragma once

#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// For all motions; a null path has none.
Extent extent_of_paths(std::initializer_list<const Path*> paths);
std::string_view style_of(const Motion& motion);  // "gs-rapid", "gs-thread", else "gs-feed"

// A place on a polyline as it is drawn: its segment, and how far along it.
struct LinePlace {
  SheetPoint from;
  SheetPoint to;
  double step = 0;    // length of the segment
  double rest = 0;    // of it up to the place
  double length = 0;  // of the whole line
};
// At a share of the length; nothing: the line has none.
std::optional<LinePlace> place_on_line(const View& view, const std::vector<Point3>& points,
                                       double share);

// `owner` is 'r' (drawn broad) or 's' (drawn fine, above it).
void append_path(std::string& out, const View& view, const Path& path, char owner);
void append_start(std::string& out, const View& view, const Path& path);
void append_end(std::string& out, const View& view, const Path& path, char owner);

}  // namespace gonogo::oracle::report
