// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-05: the proof that a place of a level's path is not supported by anything before it. All
// of the path before it is looked at, in enclosures.
#pragma once

#include <optional>
#include <span>

#include "oracle/region/order.hpp"

namespace gonogo::oracle::region {

struct Support {
  IntervalVector plunge;
  Interval step;
  Interval reach;
};

// How far, at least, what could support the place is from it; nothing unless that is surely beyond
// the reach. `at`: a place of the unit; `behind`: of an arc's unit, the stretch before the place.
std::optional<double> distance_from_support(std::span<const CutUnit> units, std::size_t unit,
                                            const Stretch& behind, const IntervalVector& at,
                                            const Support& support);

}  // namespace gonogo::oracle::region
