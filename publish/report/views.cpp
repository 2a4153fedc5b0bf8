// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/views.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gonogo::oracle::report {
namespace {

constexpr Direction kX{1, 0, 0};
constexpr Direction kY{0, 1, 0};
constexpr Direction kZ{0, 0, 1};

// Room inside a view's frame for its title and the labels of its grid.
constexpr double kLeft = 58;
constexpr double kRight = 18;
constexpr double kTop = 34;
constexpr double kBottom = 34;
constexpr double kFill = 0.94;  // of a field by its drawing

Direction operator-(const Direction& a) {
  return {-a.x, -a.y, -a.z};
}

struct Range {
  double low = 0;
  double high = 0;
  double span() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

// The extent seen along a direction, corner by corner.
Range range_along(const Direction& direction, const Extent& extent) {
  Range range{Extent::kNone, -Extent::kNone};
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Point3 point{(corner & 1U) != 0 ? extent.high.x : extent.low.x,
                       (corner & 2U) != 0 ? extent.high.y : extent.low.y,
                       (corner & 4U) != 0 ? extent.high.z : extent.low.z};
    range.low = std::min(range.low, direction.of(point));
    range.high = std::max(range.high, direction.of(point));
  }
  return range;
}

double fit(const Range& right, const Range& up, double width, double height) {
  const double by_width = right.span() > kStill ? width / right.span() : Extent::kNone;
  const double by_height = up.span() > kStill ? height / up.span() : Extent::kNone;
  const double scale = kFill * std::min(by_width, by_height);
  return std::isfinite(scale) ? scale : 1;
}

void settle(View& view, const SheetBox& frame, const Extent& extent, double scale) {
  view.frame = frame;
  view.field = {frame.x + kLeft, frame.y + kTop, frame.width - kLeft - kRight,
                frame.height - kTop - kBottom};
  view.scale = scale;
  view.middle_right = range_along(view.right, extent).middle();
  view.middle_up = range_along(view.up, extent).middle();
}

struct Flat {
  View view;
  std::string_view note;
};

// The one plane that a path with at most two moving axes lies in.
Flat flat_view(const std::array<bool, 3>& moves, bool lathe) {
  const auto [x, y, z] = moves;
  if (y && z) {
    return {{"SIDE", "side", kY, kZ}, "X does not move: one view shows everything."};
  }
  if (y) return {{"TOP", "top", kX, kY}, "Z does not move: one view shows everything."};
  View front{"FRONT", "front", lathe ? kZ : kX, lathe ? kX : kZ};
  if (x || z) return {front, "Y does not move: one view shows everything."};
  return {front, "No linear axis moves."};
}

Layout four_views(const Extent& extent, bool lathe, const SheetBox& area) {
  // R to the right, U up, T towards the viewer of the front view; back is -T.
  const Direction right = lathe ? kZ : kX;
  const Direction up = lathe ? kX : kZ;
  const Direction back = lathe ? -kY : kY;
  const Range r = range_along(right, extent);
  const Range u = range_along(up, extent);
  const Range t = range_along(back, extent);
  const double width = area.width - 2 * (kLeft + kRight);
  const double height = area.height - 2 * (kTop + kBottom);
  // No view takes so much that the others and the isometric one become unreadable.
  double scale = std::min(width / (r.span() + t.span()), height / (u.span() + t.span()));
  for (const Range& span : {r, t}) scale = std::min(scale, 0.7 * width / span.span());
  for (const Range& span : {u, t}) scale = std::min(scale, 0.7 * height / span.span());
  scale *= kFill;
  const double first_column =
      std::clamp(r.span() * scale + (width - (r.span() + t.span()) * scale) / 2, 0.3 * width,
                 0.7 * width) +
      kLeft + kRight;
  const double first_row =
      std::clamp(t.span() * scale + (height - (u.span() + t.span()) * scale) / 2, 0.3 * height,
                 0.7 * height) +
      kTop + kBottom;
  const double second_column = area.width - first_column;
  const double second_row = area.height - first_row;
  const double x2 = area.x + first_column;
  const double y2 = area.y + first_row;

  Layout layout;
  layout.scale = scale;
  layout.views = {
      {"FRONT", "front", right, up}, {"TOP", "top", right, back}, {"RIGHT SIDE", "side", back, up}};
  settle(layout.views[0], {area.x, y2, first_column, second_row}, extent, scale);
  settle(layout.views[1], {area.x, area.y, first_column, first_row}, extent, scale);
  settle(layout.views[2], {x2, y2, second_column, second_row}, extent, scale);

  // Seen from the corner between right, front and top.
  const double c = std::sqrt(0.5);
  const double s = std::sqrt(1.0 / 6);
  View isometric{"ISOMETRIC",
                 "isometric",
                 {c * (right.x + back.x), c * (right.y + back.y), c * (right.z + back.z)},
                 {s * (2 * up.x - right.x + back.x), s * (2 * up.y - right.y + back.y),
                  s * (2 * up.z - right.z + back.z)},
                 true};
  set_view(isometric, {x2, area.y, second_column, first_row}, extent);
  layout.views.push_back(isometric);
  return layout;
}

}  // namespace

std::optional<std::pair<double, double>> part_within(const SheetBox& box, SheetPoint from,
                                                     SheetPoint to) {
  double begin = 0;
  double end = 1;
  const auto cut = [&](double start, double way, double low, double high) {
    if (way == 0) return start >= low && start <= high;
    const double a = (low - start) / way;
    const double b = (high - start) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
    return begin <= end;
  };
  const bool is_in = cut(from.x, to.x - from.x, box.x, box.x + box.width) &&
                     cut(from.y, to.y - from.y, box.y, box.y + box.height);
  return is_in ? std::optional(std::pair(begin, end)) : std::nullopt;
}

void Extent::include(const Point3& point) {
  low = {std::min(low.x, point.x), std::min(low.y, point.y), std::min(low.z, point.z)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y), std::max(high.z, point.z)};
}

SheetPoint View::place(const Point3& point) const {
  return {field.x + field.width / 2 + (right.of(point) - middle_right) * scale,
          field.y + field.height / 2 - (up.of(point) - middle_up) * scale};
}

char axis_of(const Direction& direction) {
  if (direction.x != 0) return 'X';
  return direction.y != 0 ? 'Y' : 'Z';
}

SheetPoint corner_of_axes(const View& view) {
  return {view.frame.x + view.frame.width - 46, view.frame.y + 32};
}

Layout lay_out(const Extent& extent, bool lathe, const SheetBox& area) {
  const Point3 span = extent.span();
  const std::array<bool, 3> moves = {span.x > kStill, span.y > kStill, span.z > kStill};
  if (moves[0] && moves[1] && moves[2]) return four_views(extent, lathe, area);
  auto [view, note] = flat_view(moves, lathe);
  set_view(view, area, extent);
  Layout layout;
  layout.scale = view.scale;
  layout.note = note;
  layout.views = {view};
  return layout;
}

void set_view(View& view, const SheetBox& frame, const Extent& extent) {
  settle(view, frame, extent, 1);
  view.scale = fit(range_along(view.right, extent), range_along(view.up, extent), view.field.width,
                   view.field.height);
}

}  // namespace gonogo::oracle::report
