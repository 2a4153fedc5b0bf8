// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers beside the motions of a figure. Private to figure.cpp.
#pragma once

#include <string>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// Puts each number where it covers no other, beside its motion as far as there is room.
void append_numbers(std::string& out, const View& view, const Path& path);

}  // namespace gonogo::oracle::report
