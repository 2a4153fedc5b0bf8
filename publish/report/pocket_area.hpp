// SPDX-License-Identifier: GPL-3.0-or-later
//
// A pocket at one depth as the tool leaves it: what is cut, what is left, what is gouged. Drawn by
// layers that cover each other; no area is computed. Private to sheet.cpp.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "publish/report/figure.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// The border of the level that is drawn: that of the block and the depth of the departure, if there
// is one; else the deepest level of the first pocket. Free levels are drawn at the departure's own
// depth. Nothing: no pocket.
std::optional<Limit> level_shown(const std::vector<Limit>& limits, std::uint64_t block,
                                 const std::optional<Point3>& departure);

// With what the tool sweeps there.
void include_swept(Extent& extent, const PocketFloor& level, const Path& path);

// Whether a view looks along the depth of the level.
bool looks_along(const View& view, const PocketFloor& level);

// The swept area of the path's feeds at the level; under the paths.
void append_pocket_area(std::string& out, const View& view, const Limit& border, const Path& path);
// The tool's disc at a point.
void append_tool_disc(std::string& out, const View& view, const PocketFloor& level,
                      const Point3& at);
// What the colours mean, beside the title of the view.
void append_area_legend(std::string& out, const View& view, const PocketFloor& level);

}  // namespace gonogo::oracle::report
