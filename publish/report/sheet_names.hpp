// SPDX-License-Identifier: GPL-3.0-or-later
//
// The points and planes of a cycle by name, in a view of a sheet. Private to sheet.cpp.
#pragma once

#include <string>

#include "publish/report/sheet.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// Each name where it lies on no other text, and off the paths as far as there is room. That of a
// point has data-at, its place on the sheet.
void append_names(std::string& out, const View& view, const Sheet& sheet, const Names& names);

}  // namespace gonogo::oracle::report
