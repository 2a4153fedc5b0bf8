// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bands as rational shapes for the exact decision: equal to the band where its radius is
// rational (a line's band: where its length is), else within it.
#pragma once

#include <vector>

#include "oracle/region/band.hpp"
#include "oracle/region/circle_sets.hpp"

namespace gonogo::oracle::region {

// Appends the shapes of the band. False when a centre or the reach is irrational.
bool append_shapes(const Band& band, const Number& reach, std::vector<Shape>& out);

}  // namespace gonogo::oracle::region
