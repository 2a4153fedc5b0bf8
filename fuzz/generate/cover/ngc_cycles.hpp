// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models of the cycles and threads of RS274/NGC, which stand behind those of its paths.
#pragma once

#include <vector>

#include "fuzz/generate/cover/length.hpp"
#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {

// Where a hole or a thread begins along the third axis, and its depth from R.
inline constexpr Length kHoleStart = {20'000, 0};
inline constexpr Length kHoleDepth = {-10'000, 0};

std::vector<Model> ngc_cycle_models();
// Cycles among offsets, O words and other cycles.
std::vector<Model> ngc_series_models();

}  // namespace gonogo::cover
