// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a path must come within reach of.
#pragma once

#include <optional>

#include "oracle/region/rectangle.hpp"

namespace gonogo::oracle::region {

struct Target {
  RoundedRectangle area;  // about the origin; its radius is above 0
  // What need not be reached: covered before, it counts as a part of the path's bands.
  std::optional<RoundedRectangle> cleared;
  Number reach;  // > 0
  // How much farther than the reach a point must lie to prove that it is not covered.
  Number margin;
};

}  // namespace gonogo::oracle::region
