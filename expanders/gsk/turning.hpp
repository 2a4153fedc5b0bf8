// SPDX-License-Identifier: GPL-3.0-or-later
// What G90, G92 and G94 have in common: retained words, end point and taper limit.
#pragma once

#include "expanders/gsk/plan.hpp"

namespace gonogo::expanders::gsk {

/// A cycle of this family as its words fix it, with the rules checked that are common to all.
struct TurningWords {
  bool runs = false;  ///< else the block asks for nothing
  TurningPath path;   ///< b still without the taper
  Fixed taper = 0;    ///< R, a true length along the positioning axis
};

/// Takes the words of the block in. `positioning`: the plane axis on which B is reached.
Flow take_turning_words(Machine& machine, const Block& block, std::size_t positioning,
                        TurningWords& words);

/// Adds `taper` to B; false when a point of the path is out of reach.
bool close_path(TurningPath& path, Fixed taper);

}  // namespace gonogo::expanders::gsk
