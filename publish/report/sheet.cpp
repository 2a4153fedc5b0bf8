// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/report/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "publish/report/pocket_area.hpp"
#include "publish/report/sheet_parts.hpp"
#include "publish/report/sheet_paths.hpp"
#include "publish/report/unfolded.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kHairline = 0.5;
constexpr double kStrip = 250;       // height of what stands below the title block
constexpr double kInsetWidth = 330;  // of it

// What is drawn of a sheet besides its paths.
struct Parts {
  Layout layout;
  Names names;
  std::optional<Limit> level;  // of the pocket that is shown
  std::optional<Unfolding> unfolding;
  std::optional<View> inset;

  bool has_strip() const { return unfolding || inset; }
};

// A ring with a cross whose lines leave the point itself free.
void append_witness(std::string& out, SheetPoint at) {
  const std::string x = svg::number(at.x);
  const std::string y = svg::number(at.y);
  out += fmt::format(
      "<g class=\"gs-witness\"><circle cx=\"{0}\" cy=\"{1}\" r=\"9\"/>"
      "<path d=\"M{0} {1}m-17 0h11m12 0h11M{0} {1}m0 -17v11m0 12v11\"/></g>\n",
      x, y);
}

// The path that is judged: the subject's where there is one.
const Path& judged_path(const Sheet& sheet) {
  return sheet.departing != nullptr && !sheet.departing->motions.empty() ? *sheet.departing
                                                                         : *sheet.reference;
}

void append_pocket(std::string& out, const View& view, const Sheet& sheet, const Parts& parts) {
  if (parts.level && looks_along(view, *parts.level->level)) {
    append_pocket_area(out, view, *parts.level, judged_path(sheet));
    append_area_legend(out, view, *parts.level->level);
  }
  for (const Limit& limit : sheet.limits) append_limit(out, view, limit);
}

void append_marks(std::string& out, const View& view, const Sheet& sheet, const Parts& parts) {
  append_start(out, view, *sheet.reference);
  append_end(out, view, *sheet.reference, 'r');
  // A run may have been stopped where it departs, or soon behind.
  if (sheet.departing != nullptr && sheet.departing->is_ended()) {
    append_end(out, view, *sheet.departing, 's');
  }
  append_names(out, view, sheet, parts.names);
  if (!sheet.witness) return;
  if (parts.level && looks_along(view, *parts.level->level)) {
    append_tool_disc(out, view, *parts.level->level, *sheet.witness);
  }
  append_witness(out, view.place(*sheet.witness));
}

// What a page needs to draw the view anew at another scale: its frame, and where points lie in it.
std::string geometry_of(const View& view) {
  const auto along = [](const Direction& d) {
    return fmt::format("{:.6g} {:.6g} {:.6g}", d.x, d.y, d.z);
  };
  return fmt::format(
      " data-frame=\"{} {} {} {}\" data-right=\"{}\" data-up=\"{}\" data-scale=\"{:.9g}\" "
      "data-middle=\"{:.9g} {:.9g}\"{}",
      svg::number(view.frame.x), svg::number(view.frame.y), svg::number(view.frame.width),
      svg::number(view.frame.height), along(view.right), along(view.up), view.scale,
      view.middle_right, view.middle_up, view.diameters ? " data-diameters=\"\"" : "");
}

void append_view(std::string& out, const View& view, const Sheet& sheet, const Parts& parts) {
  out += fmt::format("<g data-view=\"{}\"{}>\n", view.key, geometry_of(view));
  append_view_frame(out, view);
  append_pocket(out, view, sheet, parts);
  append_path(out, view, *sheet.reference, 'r');
  if (sheet.departing != nullptr) append_path(out, view, *sheet.departing, 's');
  append_marks(out, view, sheet, parts);
  out += "</g>\n";
}

// A veil over the columns of what was accepted, before the motion that departs.
void append_accepted(std::string& out, const View& view, const Path& path,
                     const std::optional<std::size_t>& departing) {
  if (!departing || *departing >= path.motions.size()) return;
  const double end = view.place(path.motions[*departing].points.front()).x;
  const double width = end - view.frame.x;
  if (width <= 0) return;
  out += fmt::format(
      "<rect class=\"gs-accepted\" style=\"fill:var(--gs-paper,#fff);fill-opacity:.55\" x=\"{}\" "
      "y=\"{}\" width=\"{}\" height=\"{}\"/>\n",
      svg::number(view.frame.x), svg::number(view.frame.y), svg::number(width),
      svg::number(view.frame.height));
}

// The paths as far as they are unfolded; as wide as the strip, for motions of any length.
void append_unfolded(std::string& out, const Sheet& sheet, const Unfolding& how, double width) {
  Path reference = unfolded(*sheet.reference, how);
  Path departing = sheet.departing != nullptr ? unfolded(*sheet.departing, how) : Path();
  align(departing, sheet.departing_motion, reference, sheet.expected_motion);
  Extent extent = extent_of_paths({&reference, &departing});
  const double high = std::max(extent.high.z - extent.low.z, kStill);
  const double wide = std::max(extent.high.x - extent.low.x, 1.0);
  const double stretch = high / wide * (width - 100) / (kStrip - 90);
  for (Path* path : {&reference, &departing}) {
    for (Motion& motion : path->motions) {
      for (Point3& point : motion.points) point.x *= stretch;
    }
  }
  View view{"MOTION BESIDE MOTION", "unfolded", {1, 0, 0}, {0, 0, 1}};
  view.spread_axis = 'X';
  view.diameters = sheet.lathe && how.axis == 'X';
  view.shown_axis = how.axis;
  set_view(view, {kMargin + 6, kSheetHeight, width, kStrip - kMargin},
           extent_of_paths({&reference, &departing}));
  out += "<g data-view=\"unfolded\">\n";
  append_view_frame(out, view);
  append_path(out, view, reference, 'r');
  append_path(out, view, departing, 's');
  append_accepted(out, view, departing, sheet.departing_motion);
  append_start(out, view, reference);
  out += "</g>\n";
}

void append_inset(std::string& out, const Sheet& sheet, const View& view) {
  out += "<g class=\"gs-inset\">\n";
  append_view_frame(out, view);
  append_inset_path(out, view, *sheet.reference, 'r');
  if (sheet.departing != nullptr) append_inset_path(out, view, *sheet.departing, 's');
  append_witness(out, view.place(*sheet.witness));
  out += "</g>\n";
}

Extent extent_of(const Sheet& sheet) {
  Extent extent = extent_of_paths({sheet.reference, sheet.departing});
  if (sheet.witness) extent.include(*sheet.witness);
  for (const Limit& limit : sheet.limits) {
    for (const Point3& point : limit.points) extent.include(point);
  }
  const std::optional<Limit> level = level_shown(sheet.limits, sheet.block, sheet.witness);
  if (level) include_swept(extent, *level->level, judged_path(sheet));
  return extent;
}

Parts parts_of(const Sheet& sheet, const Extent& extent) {
  Parts parts;
  parts.layout = lay_out(extent, sheet.lathe, kDrawingArea);
  parts.names = names_in(*sheet.reference, sheet.block);
  for (View& view : parts.layout.views) {
    view.axis_names = parts.names.axes;
    view.diameters = sheet.lathe;
  }
  parts.level = level_shown(sheet.limits, sheet.block, sheet.witness);
  parts.unfolding = unfolding_of(*sheet.reference, sheet.block);
  if (sheet.witness) {
    parts.inset = inset_view(
        parts.layout, *sheet.reference, sheet.expected, *sheet.witness,
        {kSheetWidth - kMargin - kInsetWidth, kSheetHeight, kInsetWidth - 6, kStrip - kMargin});
  }
  return parts;
}

}  // namespace

bool is_lathe(std::string_view dialect) {
  const reference::Dialect* known = reference::find_dialect(dialect);
  return known != nullptr && known->lathe;
}

std::string svg_sheet(const Sheet& sheet) {
  Extent extent = extent_of(sheet);
  const bool blank = extent.empty();
  if (blank) extent.include({});
  const Parts parts = parts_of(sheet, extent);
  const double height = kSheetHeight + (parts.has_strip() ? kStrip : 0);
  std::string out;
  append_drawing_head(out, "gs-sheet", {kSheetWidth, height}, sheet.title);
  for (const View& view : parts.layout.views) append_view(out, view, sheet, parts);
  if (blank) append_blank_note(out);
  append_title_block(out, sheet, parts.layout);
  if (parts.has_strip()) {
    out += fmt::format("<path class=\"gs-rule\" d=\"M{0} {1}H{2}\"/>\n", svg::number(kMargin),
                       svg::number(kSheetHeight - kMargin), svg::number(kSheetWidth - kMargin));
  }
  if (parts.unfolding) {
    const double width = kSheetWidth - 2 * kMargin - 12 - (parts.inset ? kInsetWidth : 0);
    append_unfolded(out, sheet, *parts.unfolding, width);
  }
  if (parts.inset) append_inset(out, sheet, *parts.inset);
  out += fmt::format(
      "<rect class=\"gs-border\" x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\"/>\n"
      "</svg>\n",
      svg::number(kMargin - kHairline), svg::number(kSheetWidth - 2 * kMargin),
      svg::number(height - 2 * kMargin));
  return out;
}

}  // namespace gonogo::oracle::report
