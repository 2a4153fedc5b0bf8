// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers beside the motions of a figure, and a path along one line, such as the pecks of a hole,
// drawn motion beside motion. Private to figure.cpp.
#pragma once

#include <optional>
#include <string>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// Puts each number where it covers no other, beside its motion as far as there is room.
void append_numbers(std::string& out, const View& view, const Path& path);

// Where motions of one line go to be seen: a step across it for each.
struct Spread {
  Point3 step;      // mm
  char axis = 'X';  // along which they stand side by side
};
// Nothing where the extent has more than one direction.
std::optional<Spread> spread_for(const Extent& extent, bool lathe);
Path spread_out(const Path& path, const Spread& spread);

}  // namespace gonogo::oracle::report
