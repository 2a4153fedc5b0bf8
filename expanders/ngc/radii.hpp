// SPDX-License-Identifier: GPL-3.0-or-later
// Radii are compared by their squares, exactly: no root is taken.
#pragma once

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders::ngc {

/// How far the radii at the start and at the end of an arc may be apart; squares of counts.
struct RadiusTolerance {
  Wide always = 0;     ///< square of the difference above which no arc is accepted
  Wide relative = -1;  ///< above this one it may still be 1/1000 of the larger radius; -1: no such
  bool of_start = false;  ///< 1/1000 of the radius at the start
};

/// Whether square roots of `a` and `b` (from 0 to 8 * kLargest^2) differ by more than that of
/// `tolerance` (from 0 to kLargest^2).
bool differ_by_more(Wide a, Wide b, Wide tolerance);

/// Whether two radii, given by their squares, are further apart than allowed. `strict`: a
/// difference of just the tolerance is too much as well.
bool too_far_apart(Wide start_square, Wide end_square, const RadiusTolerance& tolerance,
                   bool strict);

}  // namespace gonogo::expanders::ngc
