// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <vector>

#include "publish/report/sheet_parts.hpp"
#include "publish/report/text_room.hpp"

namespace gonogo::oracle::report {
namespace {

// Pixels.
constexpr double kNameAscent = 10;  // of a name above its foot
constexpr double kNameHeight = 12.5;
constexpr double kFromPlane = 4;   // of a name from its plane
constexpr double kNextPlace = 13;  // from one place that is tried to the next
constexpr double kTitleLine = 24;  // of a view, with what stands beside it

double width_of_name(std::string_view name) {
  double width = 2;
  for (const char letter : name) {
    width += std::string_view("il ,").find(letter) != std::string_view::npos ? 4.4 : 8.8;
  }
  return width;
}

struct NameSpot {
  SheetPoint foot;
  bool at_end = false;   // the text ends there
  bool upright = false;  // it is read from the right

  SheetBox box(double width) const {
    if (upright) {
      return {foot.x - kNameAscent, at_end ? foot.y : foot.y - width, kNameHeight, width};
    }
    return {at_end ? foot.x - width : foot.x, foot.y - kNameAscent, width, kNameHeight};
  }
};

std::size_t take_spot(TextRoom& room, const std::vector<NameSpot>& spots, double width) {
  std::vector<SheetBox> boxes;
  for (const NameSpot& spot : spots) boxes.push_back(spot.box(width));
  return room.take(boxes);
}

void append_name(std::string& out, const NameSpot& spot, const std::string& name,
                 const std::string& attributes = {}) {
  const std::string turn = fmt::format("transform=\"rotate(-90 {} {})\" ", svg::number(spot.foot.x),
                                       svg::number(spot.foot.y));
  svg::append_text(
      out, spot.foot, "gs-point", name,
      (spot.at_end ? "text-anchor=\"end\" " : "") + (spot.upright ? turn : "") + attributes);
}

// Along a line from the right end of the field: above it, then below.
std::vector<NameSpot> spots_along(const SheetBox& field, double y, double width) {
  std::vector<NameSpot> spots;
  const double right = field.x + field.width - kFromPlane;
  for (double x = right; x - width >= field.x || spots.empty(); x -= kNextPlace) {
    spots.push_back({{x, y - kFromPlane}, true});
    spots.push_back({{x, y + kFromPlane + kNameAscent}, true});
  }
  return spots;
}

// Along an upright line from the top of the field: to its right, then to its left, and upright
// between lines that leave no more room.
std::vector<NameSpot> spots_upright(const SheetBox& field, double x) {
  std::vector<NameSpot> spots;
  for (const bool upright : {false, true}) {
    const double right = kFromPlane + (upright ? kNameAscent : 0);
    for (double y = field.y + kNameAscent; y < field.y + field.height; y += kNextPlace) {
      spots.push_back({{x + right, y}, upright, upright});
      spots.push_back({{x - kFromPlane, y}, true, upright});
    }
  }
  return spots;
}

std::vector<NameSpot> spots_about(SheetPoint at) {
  constexpr double kRight = 9;
  constexpr double kUp = 8;
  std::vector<NameSpot> spots;
  for (const double times : {1.0, 1.9, 2.8, 3.7}) {
    const double right = kRight * times;
    for (const double up :
         {kUp, kUp * times, -kUp - kNameAscent / 2, -(kUp * times + kNameAscent / 2)}) {
      spots.push_back({{at.x + right, at.y - up}, false});
      spots.push_back({{at.x - right, at.y - up}, true});
    }
  }
  return spots;
}

// The line that a plane is seen as; nothing where it is seen as an area.
struct PlaneLine {
  SheetPoint from;
  SheetPoint to;
  bool level = false;
};

std::optional<PlaneLine> line_of(const View& view, const NamedPlane& plane) {
  const SheetPoint at =
      view.place({plane.axis == 'X' ? plane.at : 0, plane.axis == 'Y' ? plane.at : 0,
                  plane.axis == 'Z' ? plane.at : 0});
  const SheetBox& field = view.field;
  if (axis_of(view.up) == plane.axis) {
    return PlaneLine{{field.x, at.y}, {field.x + field.width, at.y}, true};
  }
  if (axis_of(view.right) == plane.axis) {
    return PlaneLine{{at.x, field.y}, {at.x, field.y + field.height}, false};
  }
  return std::nullopt;
}

// Lines first: a name that lies on the line of another plane seems to be that one's.
void append_planes(std::string& out, const View& view, const Names& names, TextRoom& room) {
  for (const NamedPlane& plane : names.planes) {
    if (const auto line = line_of(view, plane)) room.add_line(line->from, line->to);
  }
  for (const NamedPlane& plane : names.planes) {
    const auto line = line_of(view, plane);
    if (!line) continue;
    const auto& [from, to, level] = *line;
    out += fmt::format("<path class=\"gs-plane\" d=\"M{} {}{}{}\"/>", svg::number(from.x),
                       svg::number(from.y), level ? 'h' : 'v',
                       svg::number(level ? to.x - from.x : to.y - from.y));
    const double width = width_of_name(plane.name);
    const std::vector<NameSpot> spots =
        level ? spots_along(view.field, from.y, width) : spots_upright(view.field, from.x);
    append_name(out, spots[take_spot(room, spots, width)], plane.name);
  }
}

}  // namespace

void append_names(std::string& out, const View& view, const Sheet& sheet, const Names& names) {
  if (names.points.empty() && names.planes.empty()) return;
  const SheetBox& frame = view.frame;
  const SheetBox field{view.field.x, frame.y + kTitleLine, frame.x + frame.width - 2 - view.field.x,
                       view.field.y + view.field.height + 4 - frame.y - kTitleLine};
  TextRoom room(view, field, {sheet.reference, sheet.departing});
  for (const SheetBox& box : boxes_of_axes(view)) room.add_text(box);
  if (sheet.witness) room.add_mark(view.place(*sheet.witness));
  for (const NamedPoint& point : names.points) room.add_mark(view.place(point.at));
  for (const NamedPoint& point : names.points) {
    const SheetPoint at = view.place(point.at);
    const std::vector<NameSpot> spots = spots_about(at);
    append_name(out, spots[take_spot(room, spots, width_of_name(point.name))], point.name,
                fmt::format("data-at=\"{} {}\"", svg::number(at.x), svg::number(at.y)));
  }
  if (!view.isometric) append_planes(out, view, names, room);
}

}  // namespace gonogo::oracle::report
