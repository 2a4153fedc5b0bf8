// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a text has room in a view: on no other text, and on lines and marks as little as can be.
// Private to the drawings.
#pragma once

#include <initializer_list>
#include <span>
#include <vector>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

class TextRoom {
 public:
  // `field` is where texts may stand; null paths are skipped.
  TextRoom(const View& view, const SheetBox& field, std::initializer_list<const Path*> paths);

  // What stands there already, and is no part of a path.
  void add_text(const SheetBox& box) { texts_.push_back(box); }
  void add_mark(SheetPoint at) { marks_.push_back(at); }
  void add_line(SheetPoint from, SheetPoint to) { lines_.push_back({from, to}); }

  // How much a text would cover: 0 is nothing, and another text weighs most.
  double cover(const SheetBox& box) const;
  // Takes the first of the boxes that cover least. REQUIRES: there is one.
  std::size_t take(std::span<const SheetBox> boxes);

 private:
  SheetBox field_;
  std::vector<std::vector<SheetPoint>> lines_;  // a motion each, and others
  std::vector<SheetPoint> marks_;
  std::vector<SheetBox> texts_;
};

// The axes of a view in its corner, as boxes that hold an arrow with its letter each.
std::vector<SheetBox> boxes_of_axes(const View& view);

}  // namespace gonogo::oracle::report
