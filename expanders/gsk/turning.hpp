// SPDX-License-Identifier: GPL-3.0-or-later
// What G90, G92 and G94 have in common: retained words, end point and taper limit.
#pragma once

#include "expanders/gsk/machine.hpp"

namespace gonogo::expanders::gsk {

/// From the position (A) by B and C to D and back. B lies on the line of A along one plane axis,
/// which G94 takes as p and G90 and G92 as q.
struct TurningPath {
  Fixed b = 0;
  Fixed c_p = 0;
  Fixed c_q = 0;
};

/// A cycle of this family as its words fix it, with the rules checked that are common to all.
struct TurningWords {
  bool runs = false;  ///< else the block asks for nothing
  TurningPath path;   ///< b still without the taper
  Fixed taper = 0;    ///< R, a true length along the positioning axis
};

/// Takes the words of the block in. `positioning`: the plane axis on which B is reached.
TurningWords take_turning_words(Machine& machine, const Block& block, std::size_t positioning);

/// Adds `taper` to B; complains when a point of the path is out of reach.
void close_path(Machine& machine, TurningPath& path, Fixed taper);

/// G94: A by B and C to D and back.
bool cut_face(Machine& machine, const TurningPath& path);

}  // namespace gonogo::expanders::gsk
