// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arcs whose every point of interest is rational, for the models of all dialects.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/generate/cover/drawing.hpp"

namespace gonogo::cover {

// Seen from the start, along p and q.
struct ArcWays {
  std::array<Length, 2> centre;
  std::array<Length, 2> end;
  Length radius;
};

// `centre`: along-p (10, 0), along-q (0, -10), both (6, 8), each at the radius 10. `end`: left and
// right, a quarter of a turn on as seen from the centre; opposite; full, the start.
ArcWays arc_ways(std::string_view centre, std::string_view end);

// The code and the words of the end, by the parameters `code`, `full` (whether the end of a full
// circle is written) and `helix`, where there is one.
std::vector<std::string> arc_words(const Pick& pick, const Drawing& drawing, const ArcWays& ways);

// The words of the centre or of R, by the parameters `form` and `zeros` (whether zeros are
// written).
void add_arc_form(const Pick& pick, const Drawing& drawing, const ArcWays& ways,
                  std::vector<std::string>& words);

}  // namespace gonogo::cover
