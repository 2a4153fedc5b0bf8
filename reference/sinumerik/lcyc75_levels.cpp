// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-05, SIE-LC75-06: how the depth of a pocket is divided.
#include "reference/outcome.hpp"

namespace gonogo::reference {

Number PocketMilling::top() const {
  return levels_from_clearance ? clearance : reference_plane;
}

Number PocketMilling::level_count() const {
  return ((top() - floor) / infeed).ceil();
}

Number PocketMilling::depth_of_level(const Number& k) const {
  if (levels == Levels::max_rest) return max(top() - k * infeed, floor);
  return top() - k * (top() - floor) / level_count();
}

}  // namespace gonogo::reference
