// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/report/sheet.hpp"

#include <fmt/format.h>

#include "oracle/report/sheet_parts.hpp"
#include "oracle/report/sheet_paths.hpp"
#include "reference/dialect.hpp"

namespace gonogo::oracle::report {
namespace {

constexpr double kHairline = 0.5;

// A ring with a cross whose lines leave the point itself free.
void append_witness(std::string& out, SheetPoint at) {
  const std::string x = svg::number(at.x);
  const std::string y = svg::number(at.y);
  out += fmt::format(
      "<g class=\"gs-witness\"><circle cx=\"{0}\" cy=\"{1}\" r=\"9\"/>"
      "<path d=\"M{0} {1}m-17 0h11m12 0h11M{0} {1}m0 -17v11m0 12v11\"/></g>\n",
      x, y);
}

void append_view(std::string& out, const View& view, const Sheet& sheet) {
  out += fmt::format("<g data-view=\"{}\">\n", view.key);
  append_view_frame(out, view);
  append_path(out, view, *sheet.reference, 'r');
  if (sheet.departing != nullptr) append_path(out, view, *sheet.departing, 's');
  append_start(out, view, *sheet.reference);
  append_end(out, view, *sheet.reference, 'r');
  if (sheet.departing != nullptr) append_end(out, view, *sheet.departing, 's');
  if (sheet.witness) append_witness(out, view.place(*sheet.witness));
  out += "</g>\n";
}

Extent extent_of(const Sheet& sheet) {
  Extent extent = extent_of_paths({sheet.reference, sheet.departing});
  if (sheet.witness) extent.include(*sheet.witness);
  return extent;
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
  const Layout layout = lay_out(extent, sheet.lathe, kDrawingArea);
  std::string out;
  append_sheet_head(out, sheet);
  for (const View& view : layout.views) append_view(out, view, sheet);
  if (blank) append_blank_note(out);
  append_title_block(out, sheet, layout);
  out += fmt::format(
      "<rect class=\"gs-border\" x=\"{0}\" y=\"{0}\" width=\"{1}\" height=\"{2}\"/>\n"
      "</svg>\n",
      svg::number(kMargin - kHairline), svg::number(kSheetWidth - 2 * kMargin),
      svg::number(kSheetHeight - 2 * kMargin));
  return out;
}

}  // namespace gonogo::oracle::report
