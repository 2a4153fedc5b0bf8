// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/sheet_paths.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "publish/report/svg.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kArrowRoom = 30;        // pixels that a motion takes before it gets an arrowhead
constexpr std::size_t kMostArrows = 60;  // motions of a path that still get one
constexpr std::size_t kMostSubpaths = 128;  // of one <path>: browsers are slow on longer ones

// The motions of one style of one path, as one <path> whose subpaths keep their order.
struct Strand {
  std::vector<std::size_t> records;
  std::string d;
};

// Writes the strand and empties it.
void append_strand(std::string& out, Strand& strand, char owner, std::string_view style) {
  if (strand.records.empty()) return;
  out += fmt::format("<path class=\"gs-{} {}\" data-p=\"{}\" data-m=\"{}\" d=\"{}\"/>\n", owner,
                     style, owner, svg::ranges(strand.records), strand.d);
  strand = {};
}

// An arrowhead half way along a polyline, pointing the way.
bool append_arrowhead(std::string& d, const View& view, const std::vector<Point3>& points) {
  const auto place = place_on_line(view, points, 0.55);
  if (!place || place->length < kArrowRoom) return false;
  const auto& [a, b, step, rest, length] = *place;
  const double ux = (b.x - a.x) / step;
  const double uy = (b.y - a.y) / step;
  const SheetPoint tip{a.x + ux * rest + ux * 5, a.y + uy * rest + uy * 5};
  const SheetPoint left{tip.x - ux * 11 + uy * 4, tip.y - uy * 11 - ux * 4};
  const SheetPoint right{tip.x - ux * 11 - uy * 4, tip.y - uy * 11 + ux * 4};
  svg::append_line(d, left, tip);
  d += fmt::format("L{} {}Z", svg::number(right.x), svg::number(right.y));
  return true;
}

}  // namespace

std::string_view style_of(const Motion& motion) {
  return motion.rapid ? "gs-rapid" : motion.is_thread() ? "gs-thread" : "gs-feed";
}

std::optional<LinePlace> place_on_line(const View& view, const std::vector<Point3>& points,
                                       double share) {
  std::vector<LinePlace> segments;
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SheetPoint a = view.place(points[i - 1]);
    const SheetPoint b = view.place(points[i]);
    segments.push_back({a, b, std::hypot(b.x - a.x, b.y - a.y)});
    length += segments.back().step;
  }
  double rest = share * length;
  for (LinePlace& segment : segments) {
    if (segment.step == 0 || (segment.step < rest && &segment != &segments.back())) {
      rest -= segment.step;
      continue;
    }
    segment.rest = rest;
    segment.length = length;
    return segment;
  }
  return std::nullopt;
}

Extent extent_of_paths(std::initializer_list<const Path*> paths) {
  Extent extent;
  for (const Path* path : paths) {
    if (path == nullptr) continue;
    for (const Motion& motion : path->motions) {
      for (const Point3& point : motion.points) extent.include(point);
    }
  }
  return extent;
}

void append_path(std::string& out, const View& view, const Path& path, char owner) {
  Strand rapids;
  Strand feeds;
  Strand threads;
  Strand heads;
  const auto moving = std::ranges::count_if(path.motions, &Motion::moves);
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    const Motion& motion = path.motions[i];
    if (!motion.moves()) continue;
    Strand& strand = motion.rapid ? rapids : motion.is_thread() ? threads : feeds;
    strand.records.push_back(i);
    svg::append_subpath(strand.d, view, motion.points);
    if (strand.records.size() == kMostSubpaths) {
      append_strand(out, strand, owner, style_of(motion));
    }
    if (moving <= static_cast<std::ptrdiff_t>(kMostArrows) &&
        append_arrowhead(heads.d, view, motion.points)) {
      heads.records.push_back(i);
    }
  }
  append_strand(out, rapids, owner, "gs-rapid");
  append_strand(out, feeds, owner, "gs-feed");
  append_strand(out, threads, owner, "gs-thread");
  append_strand(out, heads, owner, "gs-head");
}

void append_start(std::string& out, const View& view, const Path& path) {
  if (path.motions.empty()) return;
  const SheetPoint start = view.place(path.motions.front().points.front());
  out += fmt::format("<circle class=\"gs-start\" cx=\"{}\" cy=\"{}\" r=\"5.5\"/>\n",
                     svg::number(start.x), svg::number(start.y));
}

void append_end(std::string& out, const View& view, const Path& path, char owner) {
  if (path.motions.empty()) return;
  const SheetPoint end = view.place(path.motions.back().points.back());
  out += fmt::format("<rect class=\"gs-end gs-{}\" x=\"{}\" y=\"{}\" width=\"7\" height=\"7\"/>\n",
                     owner, svg::number(end.x - 3.5), svg::number(end.y - 3.5));
}

}  // namespace gonogo::oracle::report
