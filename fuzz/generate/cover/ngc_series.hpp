// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models of cycles of RS274/NGC among offsets, O words and other cycles.
#pragma once

#include <vector>

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {

std::vector<Model> ngc_series_models();

}  // namespace gonogo::cover
