// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/places.hpp"

#include <algorithm>
#include <cmath>

namespace gonogo::oracle {

// Two coordinates that are rounded to doubles are off by no more than half a unit in the last place
// each, together by less than this.
bool same_place(const Position& a, const Position& b, const Tolerances& tolerances) {
  for (Axis axis : reference::kAllAxes) {
    if (agree(a[axis], b[axis], tolerances.tolerance)) continue;
    if (!tolerances.binary64) return false;
    const double size = std::max(std::abs(estimate(a[axis])), std::abs(estimate(b[axis])));
    if (!agree(a[axis], b[axis], tolerances.tolerance + two_units_of_double(size))) return false;
  }
  return true;
}

bool stays_at(const Position& place, const Motion& motion, const Tolerances& tolerances) {
  return same_place(motion.from, place, tolerances) && same_place(motion.to(), place, tolerances) &&
         !goes_round(motion, tolerances.tolerance);
}

}  // namespace gonogo::oracle
