// SPDX-License-Identifier: GPL-3.0-or-later
// What G110 to G117 have in common: centre, planes and depth.
#pragma once

#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {

/// What the axis words of a block of these cycles ask for.
enum class Placing { kNothing, kPosition, kMill };

/// The centre from the axis words (GSK-G110-01, 06, 14).
Flow find_centre(Machine& machine, const Block& block, Site& site, Placing& placing);

/// A cycle moves to `site.centre` only (reading gsk.missing-axis).
inline Line positioning(const Site& site) {
  return Line{site.centre, site.axes, false};
}

/// R plane and depth. `direction_free`: R may point away from the bottom. `from_initial`: an
/// incremental depth counts from the initial plane.
struct DepthRules {
  bool direction_free = false;
  bool from_initial = false;
};
Flow find_depth(Machine& machine, const Block& block, const Retained& to_r_plane,
                const DepthRules& rules, Site& site);

/// Rapid to the centre, then to the R plane (GSK-G110-06, 07; GSK-G112-03; GSK-G114-05).
bool approach(Machine& machine, const Site& site);

}  // namespace gonogo::expanders::gsk
