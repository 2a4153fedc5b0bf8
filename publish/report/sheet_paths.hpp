// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths in a view of a drawing: their motions by style, arrowheads, start and end. Private to the
// drawings.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// For all motions; a null path has none.
Extent extent_of_paths(std::initializer_list<const Path*> paths);
std::string_view style_of(const Motion& motion);  // "gs-rapid", "gs-thread", else "gs-feed"
// `owner` is 'r' (drawn broad) or 's' (drawn fine, above it).
void append_path(std::string& out, const View& view, const Path& path, char owner);
void append_start(std::string& out, const View& view, const Path& path);
void append_end(std::string& out, const View& view, const Path& path, char owner);

}  // namespace gonogo::oracle::report
