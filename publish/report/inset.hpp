// SPDX-License-Identifier: GPL-3.0-or-later
//
// A departure that is too small to be seen, drawn large. Private to sheet.cpp.
#pragma once

#include <optional>
#include <string>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// The view of `layout` in which the witness lies farthest from the path, or else from where the
// motion had to end, magnified so that it can be seen; nothing where it can be seen as it is.
std::optional<View> inset_view(const Layout& layout, const Path& reference,
                               const std::optional<Point3>& expected, const Point3& witness,
                               const SheetBox& frame);
// The path near the middle of the view: what is far outside would have coordinates that no viewer
// draws exactly. `owner` as in append_path.
void append_inset_path(std::string& out, const View& view, const Path& path, char owner);

}  // namespace gonogo::oracle::report
