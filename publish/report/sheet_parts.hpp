// SPDX-License-Identifier: GPL-3.0-or-later
//
// What surrounds the paths on a sheet: styles, grid, axes, names, title block, and a departure
// drawn large. Private to the drawings.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "publish/report/sheet.hpp"
#include "publish/report/svg.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// Pixels.
inline constexpr double kSheetWidth = 1160;
inline constexpr double kSheetHeight = 820;
inline constexpr double kMargin = 12;
inline constexpr double kTitleBlock = 104;
inline constexpr SheetBox kDrawingArea{kMargin + 6, kMargin + 6, kSheetWidth - 2 * (kMargin + 6),
                                       kSheetHeight - 2 * kMargin - kTitleBlock - 12};

// The <style> of every drawing.
std::string_view sheet_style();
// Begins a drawing, with its paper; `style`: a <style> of its own.
void append_drawing_head(std::string& out, std::string_view css_class, SheetPoint size,
                         std::string_view title, std::string_view style = {});
// "TOP  X-Y  p = X"
std::string view_title(const View& view);
// Title, grid with coordinates, axes.
void append_view_frame(std::string& out, const View& view);
std::string_view style_of(Limit::Kind kind);
void append_limit(std::string& out, const View& view, const Limit& limit);
void append_blank_note(std::string& out);
// Legend, names, verdict, scale bar, projection symbol, remarks.
void append_title_block(std::string& out, const Sheet& sheet, const Layout& layout);

// The points and planes of a cycle by name, each name where it lies on no other text, and off the
// paths as far as there is room. That of a point has data-at, its place on the sheet.
void append_names(std::string& out, const View& view, const Sheet& sheet, const Names& names);

// The view of `layout` in which the witness lies farthest from the path, or else from where the
// motion had to end, magnified so that it can be seen; nothing where it can be seen as it is.
std::optional<View> inset_view(const Layout& layout, const Path& reference,
                               const std::optional<Point3>& expected, const Point3& witness,
                               const SheetBox& frame);
// The path near the middle of the view: what is far outside would have coordinates that no viewer
// draws exactly. `owner` as in append_path.
void append_inset_path(std::string& out, const View& view, const Path& path, char owner);

}  // namespace gonogo::oracle::report
