// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/figure_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "publish/report/figure.hpp"
#include "publish/report/svg.hpp"
#include "publish/report/text_room.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kDigit = 8;  // pixels
constexpr double kHeight = 14;
constexpr double kAside = 14;  // of a number's middle from its motion

struct Spot {
  SheetPoint at;
  double ux = 1;  // direction of the motion there
  double uy = 0;
};

// The point of a polyline at a share of its length on the sheet.
Spot spot_at(const View& view, const std::vector<Point3>& points, double share) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SheetPoint a = view.place(points[i - 1]);
    const SheetPoint b = view.place(points[i]);
    length += std::hypot(b.x - a.x, b.y - a.y);
  }
  double rest = share * length;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const SheetPoint a = view.place(points[i - 1]);
    const SheetPoint b = view.place(points[i]);
    const double step = std::hypot(b.x - a.x, b.y - a.y);
    if (step == 0 || (step < rest && i + 1 < points.size())) {
      rest -= step;
      continue;
    }
    const double part = std::clamp(rest / step, 0.0, 1.0);
    return {{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)},
            (b.x - a.x) / step,
            (b.y - a.y) / step};
  }
  return {view.place(points.back()), 1, 0};
}

}  // namespace

void append_numbers(std::string& out, const View& view, const Path& path) {
  constexpr std::array<double, 7> kShares = {0.5, 0.38, 0.62, 0.25, 0.75, 0.12, 0.88};
  TextRoom room(view, view.field, {&path});  // beside the field stand the labels of the grid
  for (const SheetBox& box : boxes_of_axes(view)) room.add_text(box);
  const std::vector<std::size_t> numbers = motion_numbers(path);
  for (std::size_t i = 0; i < path.motions.size(); ++i) {
    if (numbers[i] == 0) continue;
    const std::string text = std::to_string(numbers[i]);
    const double width = kDigit * static_cast<double>(text.size()) + 2;
    std::vector<SheetBox> boxes;
    for (const double times : {1.0, -1.0, 1.6, -1.6, 2.2, -2.2, 3.0, -3.0}) {
      const double aside = times * kAside;
      for (const double share : kShares) {
        const Spot spot = spot_at(view, path.motions[i].points, share);
        boxes.push_back({spot.at.x - spot.uy * aside - width / 2,
                         spot.at.y + spot.ux * aside - kHeight / 2, width, kHeight});
      }
    }
    const SheetBox best = boxes[room.take(boxes)];
    svg::append_text(out, {best.x + width / 2, best.y + kHeight - 2.5}, "gs-number", text,
                     "text-anchor=\"middle\"");
  }
}

}  // namespace gonogo::oracle::report
