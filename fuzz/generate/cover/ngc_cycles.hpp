// SPDX-License-Identifier: GPL-3.0-or-later
//
// The models of the cycles and threads of RS274/NGC, which stand behind those of its paths.
#pragma once

#include <vector>

#include "fuzz/generate/cover/model.hpp"

namespace gonogo::cover {

std::vector<Model> ngc_cycle_models();

}  // namespace gonogo::cover
