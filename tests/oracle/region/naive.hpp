// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances from arcs as they come, by angles and square roots: nothing shared with the judge.
#pragma once

#include <functional>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

double approximate(const Number& value);

bool is_round(const LevelMotion& motion);
// REQUIRES: the arc is round.
Number exact_distance(const LevelMotion& motion, const PlanePoint& point);
// In doubles, made once for many points.
std::function<double(double x, double y)> rough_distance_to_arc(const LevelMotion& motion);

}  // namespace gonogo::oracle::region
