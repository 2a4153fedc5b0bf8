// SPDX-License-Identifier: GPL-3.0-or-later
//
// What surrounds the paths on a sheet: styles, grid, axes, title block. Private to sheet.cpp.
#pragma once

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
void append_sheet_head(std::string& out, const Sheet& sheet, double height);
// "TOP  X-Y  p = X"
std::string view_title(const View& view);
// Title, grid with coordinates, axes.
void append_view_frame(std::string& out, const View& view);
void append_limit(std::string& out, const View& view, const Limit& limit);
void append_blank_note(std::string& out);
// Legend, names, verdict, scale bar, projection symbol, remarks.
void append_title_block(std::string& out, const Sheet& sheet, const Layout& layout);

}  // namespace gonogo::oracle::report
