// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/pocket_area.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "publish/report/sheet_parts.hpp"
#include "publish/report/svg.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kSameDepth = 1e-4;  // mm

reference::Axis depth_axis(const PocketFloor& level) {
  return reference::axes_of(level.plane).d;
}

bool is_at(const PocketFloor& level, const Point3& point) {
  return std::fabs(point[depth_axis(level)] - level.depth) < kSameDepth;
}

// Whether a motion is of the level or ends the way down to it.
bool comes_to(const PocketFloor& level, const Motion& motion) {
  const bool of_block = motion.block == 0 || motion.block == level.block;
  return motion.moves() && of_block && is_at(level, motion.points.back());
}

// The feeds at the level, and where the tool comes down to it.
std::string swept(const View& view, const Path& path, const PocketFloor& level) {
  std::string d;
  const auto is_at_level = [&](const Point3& point) { return is_at(level, point); };
  for (const Motion& motion : path.motions) {
    if (!comes_to(level, motion)) continue;
    if (std::ranges::all_of(motion.points, is_at_level)) {
      svg::append_subpath(d, view, motion.points);
    } else {
      svg::append_subpath(d, view, {motion.points.back(), motion.points.back()});
    }
  }
  return d;
}

// The border at the depth of a place: at its level, or between the floor and where levels begin
// that the manual leaves open; elsewhere nothing is milled.
std::optional<Limit> at_depth_of(Limit border, const Point3& place) {
  PocketFloor& level = *border.level;
  const double depth = place[depth_axis(level)];
  if (is_at(level, place)) return border;
  if (!level.top || depth < level.depth || depth >= *level.top) return std::nullopt;
  level.depth = depth;
  for (Point3& point : border.points) point[depth_axis(level)] = depth;
  return border;
}

}  // namespace

std::optional<Limit> level_shown(const std::vector<Limit>& limits, std::uint64_t block,
                                 const std::optional<Point3>& departure) {
  const Limit* best = nullptr;
  double least = 0;
  for (const Limit& limit : limits) {
    if (!limit.level) continue;
    const PocketFloor& level = *limit.level;
    const bool of_block = block == 0 || level.block == block;
    double distance = of_block ? 0 : 1e9;
    if (departure && of_block) {
      distance += std::fabs((*departure)[depth_axis(level)] - level.depth);
    } else if (best != nullptr && best->level->block == level.block) {
      distance = least;  // of the same pocket the last level
    }
    if (best == nullptr || distance < least ||
        (!departure && distance == least && best->level->block == level.block)) {
      best = &limit;
      least = distance;
    }
  }
  if (best == nullptr) return std::nullopt;
  const bool of_block = block == 0 || best->level->block == block;
  return departure && of_block ? at_depth_of(*best, *departure) : *best;
}

void include_swept(Extent& extent, const PocketFloor& level, const Path& path) {
  Point3 reach{level.tool_radius, level.tool_radius, level.tool_radius};
  reach[depth_axis(level)] = 0;
  for (const Motion& motion : path.motions) {
    if (!comes_to(level, motion)) continue;
    for (const Point3& point : motion.points) {
      if (!is_at(level, point)) continue;
      extent.include(point - reach);
      extent.include(point + reach);
    }
  }
}

bool looks_along(const View& view, const PocketFloor& level) {
  Point3 axis;
  axis[depth_axis(level)] = 1;
  return !view.isometric && view.right.of(axis) == 0 && view.up.of(axis) == 0;
}

void append_pocket_area(std::string& out, const View& view, const Limit& border, const Path& path) {
  const PocketFloor& level = *border.level;
  const std::string tool = swept(view, path, level);
  std::string wall;
  svg::append_subpath(wall, view, border.points);
  const std::string width = svg::number(2 * level.tool_radius * view.scale);
  out += fmt::format("<clipPath id=\"{}\"><path d=\"{}Z\"/></clipPath>\n", kPocketClip, wall);
  if (!tool.empty()) {
    out += fmt::format("<path class=\"gs-swept gs-gouged\" stroke-width=\"{}\" d=\"{}\"/>\n", width,
                       tool);
  }
  out += fmt::format("<path class=\"gs-uncut\" d=\"{}Z\"/>\n", wall);
  if (!tool.empty()) {
    out += fmt::format(
        "<g clip-path=\"url(#{})\"><path class=\"gs-swept gs-cut\" stroke-width=\"{}\" "
        "d=\"{}\"/></g>\n",
        kPocketClip, width, tool);
  }
}

void append_tool_disc(std::string& out, const View& view, const PocketFloor& level,
                      const Point3& at) {
  const SheetPoint place = view.place(at);
  out += fmt::format("<circle class=\"gs-disc\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n",
                     svg::number(place.x), svg::number(place.y),
                     svg::number(level.tool_radius * view.scale));
}

void append_area_legend(std::string& out, const View& view, const PocketFloor& level) {
  double x = view.frame.x + 24 + 9 * static_cast<double>(view_title(view).size());
  const double y = view.frame.y + 18;
  const auto patch = [&](std::string_view style, std::string_view text) {
    out += fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"12\" height=\"9\"/>", style,
                       svg::number(x), svg::number(y - 9));
    svg::append_text(out, {x + 16, y}, "gs-label", text);
    x += 24 + 6.2 * static_cast<double>(text.size());
  };
  patch("gs-patch-cut", "cut");
  patch("gs-patch-uncut", "left");
  patch("gs-patch-gouged", "gouged");
  svg::append_text(out, {x, y}, "gs-label",
                   fmt::format("at depth {}, tool \xC3\x98 {}", svg::number(level.depth),
                               svg::number(2 * level.tool_radius)));
}

}  // namespace gonogo::oracle::report
