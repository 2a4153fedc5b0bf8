// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/figure_parts.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "publish/report/figure.hpp"
#include "publish/report/sheet_paths.hpp"
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
  const auto place = place_on_line(view, points, share);
  if (!place) return {view.place(points.back()), 1, 0};
  const auto& [a, b, step, rest, length] = *place;
  const double part = std::clamp(rest / step, 0.0, 1.0);
  return {
      {a.x + part * (b.x - a.x), a.y + part * (b.y - a.y)}, (b.x - a.x) / step, (b.y - a.y) / step};
}

// Between two motions, of the line's length: upright ones have their numbers in the gap.
constexpr double kGapOfLevel = 0.06;
constexpr double kGapOfUpright = 0.1;

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

std::optional<Spread> spread_for(const Extent& extent, bool lathe) {
  const auto [x, y, z] = extent.span();
  if ((x > kStill) + (y > kStill) + (z > kStill) != 1) return std::nullopt;
  const bool level = (lathe ? z : x) > kStill;
  const double gap = (level ? kGapOfLevel : kGapOfUpright) * std::max({x, y, z});
  // To the right on the sheet, or downwards.
  if (x > kStill) return Spread{{0, 0, lathe ? gap : -gap}, 'Z'};
  return Spread{{lathe && z > kStill ? -gap : gap, 0, 0}, 'X'};
}

Path spread_out(const Path& path, const Spread& spread) {
  Path out = path;
  double times = 0;
  for (Motion& motion : out.motions) {
    // What does not move stands where the motion before it ended.
    const double place = motion.moves() ? times : std::max(0.0, times - 1);
    for (Point3& point : motion.points) point = point + place * spread.step;
    if (motion.moves()) times += 1;
  }
  return out;
}

}  // namespace gonogo::oracle::report
