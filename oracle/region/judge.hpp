// SPDX-License-Identifier: GPL-3.0-or-later
//
// The region judge with a choice of method, for the tests.
#pragma once

#include <span>

#include "oracle/region/coverage.hpp"
#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

LevelVerdict judge_level_by(Method method, const CircularLevel& level,
                            std::span<const LevelMotion> motions);
LevelVerdict judge_level_by(Method method, const RectangularLevel& level,
                            std::span<const LevelMotion> motions);

}  // namespace gonogo::oracle::region
