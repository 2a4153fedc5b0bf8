// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers as doubles: for drawings, for estimates, never for a verdict.
#pragma once

#include "reference/exact/number.hpp"

namespace gonogo::oracle {

// Within one unit in the last place of the value.
double approximate(const exact::Number& value);

}  // namespace gonogo::oracle
