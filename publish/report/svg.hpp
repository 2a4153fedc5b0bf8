// SPDX-License-Identifier: GPL-3.0-or-later
//
// Building blocks of SVG text. Private to the drawing sheet.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "publish/report/views.hpp"

namespace gonogo::oracle::report::svg {

// At most two decimals, no trailing zeros, never in exponents.
std::string number(double value);

void append_line(std::string& out, SheetPoint from, SheetPoint to);  // "M0 0L1 1"

// <text> with escaped content; `attributes` is markup of ours.
void append_text(std::string& out, SheetPoint at, std::string_view css_class,
                 std::string_view content, std::string_view attributes = {});

// A polyline in a view as a subpath. Points that lie on the chord of those kept, within a twentieth
// of a pixel, are left out, but never the end.
void append_subpath(std::string& out, const View& view, const std::vector<Point3>& points);

// "0 1 2 7" as "0-2 7".
std::string ranges(const std::vector<std::size_t>& numbers);

// 1, 2 or 5 times a power of ten, the smallest one that is not below `least`.
double nice_step(double least);
// A multiple of a nice step, with the decimals that it needs.
std::string step_label(double value, double step);

}  // namespace gonogo::oracle::report::svg
