// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "reference/exact/number.hpp"

namespace gonogo::exact {

// An angle in degrees as one in radians: 0, or an enclosure, for pi is in it.
Number radians(const Number& degrees);

}  // namespace gonogo::exact
