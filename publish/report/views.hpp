// SPDX-License-Identifier: GPL-3.0-or-later
//
// The views of a drawing sheet in third-angle projection: which ones, where they stand, and how
// a point of the machine becomes a point of the sheet.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "publish/report/path.hpp"

namespace gonogo::oracle::report {

// Pixels of the sheet, y downwards.
struct SheetPoint {
  double x = 0;
  double y = 0;
};
struct SheetBox {
  double x = 0;
  double y = 0;
  double width = 0;
  double height = 0;
};

// Where the part of a line within a box begins and ends, as shares of its length; nothing: it lies
// outside.
std::optional<std::pair<double, double>> part_within(const SheetBox& box, SheetPoint from,
                                                     SheetPoint to);

inline constexpr double kStill = 1e-6;  // mm: an axis that spans less does not move

// What a drawing spans, mm.
struct Extent {
  Point3 low{kNone, kNone, kNone};
  Point3 high{-kNone, -kNone, -kNone};
  void include(const Point3& point);
  bool empty() const { return low.x > high.x; }
  Point3 span() const { return high - low; }
  static constexpr double kNone = std::numeric_limits<double>::infinity();
};

// A direction of the machine along the sheet.
struct Direction {
  double x = 0;
  double y = 0;
  double z = 0;
  double of(const Point3& point) const { return x * point.x + y * point.y + z * point.z; }
};

struct View {
  std::string_view title;  // "FRONT"
  std::string_view key;    // "front"
  Direction right;
  Direction up;
  bool isometric = false;
  SheetBox frame{};         // with title and labels
  SheetBox field{};         // the drawing
  double scale = 1;         // pixels a mm
  double middle_right = 0;  // mm, at the middle of the field
  double middle_up = 0;
  bool diameters = false;  // the scale of X
  char spread_axis = 0;    // motions stand side by side along it, so it has no scale; 0: none
  char shown_axis = 0;     // of a view of one coordinate: which; 0: as its directions say
  std::map<char, char> axis_names{};  // 'p' -> 'Z', as the clauses call them

  SheetPoint place(const Point3& point) const;
};

// The axis along a direction that has one.
char axis_of(const Direction& direction);
// Where the three axes are shown in a view: beside its title.
SheetPoint corner_of_axes(const View& view);

struct Layout {
  std::vector<View> views;  // the main view first
  double scale = 1;         // of all but the isometric view
  std::string_view note;    // which views were left out and why
};

// `lathe`: Z to the right and X up in the front view, as lathes are drawn; else X right and Z up.
// When at most two axes move there is one view. REQUIRES: the extent is not empty.
Layout lay_out(const Extent& extent, bool lathe, const SheetBox& area);

// Sets one view of the extent into a frame, as large as it fits.
void set_view(View& view, const SheetBox& frame, const Extent& extent);

}  // namespace gonogo::oracle::report
