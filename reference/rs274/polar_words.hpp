// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-POL: @ and ^, the end of a motion by its distance from the program's origin in X and Y and
// the angle from +X toward +Y.
#pragma once

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// Under G91: from where the polar words of the block count, and what they add. REQUIRES: the block
// has such words.
struct PolarSteps {
  PolarPlace from;
  PolarStep step;

  // NGC-POL-01: behind so many equal steps.
  PolarPlace after(const Number& steps) const;
};
PolarSteps polar_steps(const BlockContext& block);

// Where the polar words of the block lead; where that is an alarm, the place of the machine.
PlaceInXy polar_end(const BlockContext& block);

// NGC-POL-03, NGC-POL-04: the rules of polar words.
void check_polar_words(BlockContext& block);
// Behind the motion of any block: whether polar words say where the tool is.
void keep_polar_place(BlockContext& block);

}  // namespace gonogo::reference::rs274
