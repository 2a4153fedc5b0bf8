// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "publish/report/sheet_parts.hpp"
#include "publish/report/sheet_paths.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kSeenPixels = 3;         // pixels
constexpr double kInsetPixels = 50;       // pixels that the departure takes in the inset
constexpr double kLeastDeparture = 1e-9;  // mm: below, nothing departs

Point3 between(const Point3& a, const Point3& b, double share) {
  return a + share * (b - a);
}

double squared(const Point3& a, const Point3& b) {
  return dot(a - b, a - b);
}

Point3 nearest_on(const Point3& from, const Point3& to, const Point3& point) {
  const double length = squared(from, to);
  if (length == 0) return from;
  return between(from, to, std::clamp(dot(point - from, to - from) / length, 0.0, 1.0));
}

// The point of the path that is nearest; of a path that only stands, where it stands.
std::optional<Point3> nearest(const Path& path, const Point3& point) {
  std::optional<Point3> best;
  for (const Motion& motion : path.motions) {
    for (std::size_t i = 1; i < motion.points.size(); ++i) {
      const Point3 here = nearest_on(motion.points[i - 1], motion.points[i], point);
      if (!best || squared(here, point) < squared(*best, point)) best = here;
    }
  }
  return best;
}

// Pixels between two points in a view of scale 1.
double apart(const View& view, const Point3& a, const Point3& b) {
  return std::hypot(view.right.of(a) - view.right.of(b), view.up.of(a) - view.up.of(b));
}

// The part of a segment within a box of the sheet, as a subpath.
void append_clipped(std::string& d, SheetPoint from, SheetPoint to, const SheetBox& box) {
  const auto part = part_within(box, from, to);
  if (!part) return;
  const auto [begin, end] = *part;
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  svg::append_line(d, {from.x + begin * dx, from.y + begin * dy},
                   {from.x + end * dx, from.y + end * dy});
}

std::optional<View> inset_between(const Layout& layout, const Point3& witness, const Point3& from,
                                  const SheetBox& frame) {
  const View* best = nullptr;
  for (const View& view : layout.views) {
    if (view.isometric) continue;
    if (best == nullptr || apart(view, witness, from) > apart(*best, witness, from)) best = &view;
  }
  const double size = best == nullptr ? 0 : apart(*best, witness, from);
  if (size < kLeastDeparture || size * best->scale >= kSeenPixels) return std::nullopt;
  View inset = *best;
  inset.title = "DEPARTURE";
  inset.key = "inset";
  inset.frame = frame;
  inset.field = {frame.x + 76, frame.y + 34, frame.width - 94, frame.height - 64};
  inset.scale = kInsetPixels / size;
  const Point3 middle = between(witness, from, 0.5);
  inset.middle_right = inset.right.of(middle);
  inset.middle_up = inset.up.of(middle);
  return inset;
}

}  // namespace

std::optional<View> inset_view(const Layout& layout, const Path& reference,
                               const std::optional<Point3>& expected, const Point3& witness,
                               const SheetBox& frame) {
  if (const auto on_path = nearest(reference, witness)) {
    if (auto inset = inset_between(layout, witness, *on_path, frame)) return inset;
  }
  if (!expected) return std::nullopt;
  return inset_between(layout, witness, *expected, frame);
}

void append_inset_path(std::string& out, const View& view, const Path& path, char owner) {
  for (const std::string_view style : {"gs-rapid", "gs-feed", "gs-thread"}) {
    std::string d;
    for (const Motion& motion : path.motions) {
      if (style_of(motion) != style) continue;
      for (std::size_t i = 1; i < motion.points.size(); ++i) {
        append_clipped(d, view.place(motion.points[i - 1]), view.place(motion.points[i]),
                       view.field);
      }
    }
    if (!d.empty()) out += fmt::format("<path class=\"gs-{} {}\" d=\"{}\"/>\n", owner, style, d);
  }
}

}  // namespace gonogo::oracle::report
