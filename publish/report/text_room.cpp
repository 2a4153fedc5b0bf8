// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/text_room.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle::report {
namespace {

constexpr double kOnText = 100;
constexpr double kOutside = 50;
constexpr double kOnMark = 2;
constexpr double kOnLine = 1;      // a motion
constexpr double kMarkRadius = 6;  // pixels

bool meet(const SheetBox& a, const SheetBox& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

SheetBox widened(const SheetBox& box, double by) {
  return {box.x - by, box.y - by, box.width + 2 * by, box.height + 2 * by};
}

bool crosses(const SheetBox& box, const std::vector<SheetPoint>& line) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (part_within(box, line[i - 1], line[i])) return true;
  }
  return false;
}

}  // namespace

TextRoom::TextRoom(const View& view, const SheetBox& field,
                   std::initializer_list<const Path*> paths)
    : field_(field) {
  for (const Path* path : paths) {
    if (path == nullptr || path->motions.empty()) continue;
    marks_.push_back(view.place(path->motions.front().points.front()));
    marks_.push_back(view.place(path->motions.back().points.back()));
    for (const Motion& motion : path->motions) {
      if (!motion.moves()) continue;
      std::vector<SheetPoint>& line = lines_.emplace_back();
      for (const Point3& point : motion.points) line.push_back(view.place(point));
    }
  }
}

double TextRoom::cover(const SheetBox& box) const {
  constexpr double kStroke = 2;  // half the width of a line
  double covered = 0;
  for (const SheetBox& text : texts_) covered += meet(box, text) ? kOnText : 0;
  const bool outside = box.x < field_.x || box.y < field_.y ||
                       box.x + box.width > field_.x + field_.width ||
                       box.y + box.height > field_.y + field_.height;
  covered += outside ? kOutside : 0;
  for (const SheetPoint& at : marks_) {
    const SheetBox mark = widened({at.x, at.y, 0, 0}, kMarkRadius);
    covered += meet(box, mark) ? kOnMark : 0;
  }
  const SheetBox drawn = widened(box, kStroke);
  for (const auto& line : lines_) covered += crosses(drawn, line) ? kOnLine : 0;
  return covered;
}

std::size_t TextRoom::take(std::span<const SheetBox> boxes) {
  std::size_t best = 0;
  double least = cover(boxes[0]);
  for (std::size_t i = 1; i < boxes.size() && least > 0; ++i) {
    const double covered = cover(boxes[i]);
    if (covered >= least) continue;
    least = covered;
    best = i;
  }
  add_text(boxes[best]);
  return best;
}

std::vector<SheetBox> boxes_of_axes(const View& view) {
  constexpr double kTip = 15;     // pixels from the corner for an axis that is seen whole
  constexpr double kLetter = 12;  // from the tip to the middle of its letter
  constexpr double kAround = 8;   // half a letter with some room
  const SheetPoint corner = corner_of_axes(view);
  std::vector<SheetBox> boxes;
  for (const Point3& axis : {Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}}) {
    const double dx = view.right.of(axis);
    const double dy = -view.up.of(axis);
    const double length = std::hypot(dx, dy);
    if (length < 0.05) continue;
    const double far = kTip * length + kLetter;
    const SheetPoint letter{corner.x + dx / length * far, corner.y + dy / length * far};
    boxes.push_back({std::min(corner.x, letter.x) - kAround, std::min(corner.y, letter.y) - kAround,
                     std::fabs(letter.x - corner.x) + 2 * kAround,
                     std::fabs(letter.y - corner.y) + 2 * kAround});
  }
  return boxes;
}

}  // namespace gonogo::oracle::report
