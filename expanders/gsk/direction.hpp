// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::gsk {

/// A unit vector. Its parts are exact where they are 0, 1/2 or 1.
struct Direction {
  long double cosine = 1;
  long double sine = 0;
};

/// The angle of `part` / `whole` turns; `part` from 0 to below `whole`.
Direction direction_of(Fixed part, Fixed whole);

/// The angles of both, the second taken `sense` times (1 or -1).
Direction turned(const Direction& from, const Direction& by, int sense);

}  // namespace gonogo::expanders::gsk
