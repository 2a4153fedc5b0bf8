// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "expanders/ngc/machine.hpp"

namespace gonogo::expanders::ngc {

/// Where @ and ^ lead (NGC-POL-01): distances from the origin in counts, angles in degrees.
struct PolarWay {
  long double distance = 0;  ///< of the first end
  long double angle = 0;
  long double further = 0;  ///< with each hole of a cycle more
  long double turn = 0;
};

inline bool is_polar(const Block& block) {
  return block.has_any(AddressSet{"@^"});
}

/// From where the machine stands; complains about what has no angle. The words must be there.
PolarWay polar_way(Machine& machine, const Block& block);

/// Puts X and Y of end `number`, from 0, into `place`.
void lead_to(Machine& machine, const Block& block, const PolarWay& way, Fixed number, Point& place);
/// The same where all of them are known to be in reach.
void lead_to(const PolarWay& way, Fixed number, Point& place);

}  // namespace gonogo::expanders::ngc
