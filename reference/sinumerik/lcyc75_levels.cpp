// SPDX-License-Identifier: GPL-3.0-or-later
//
// SIE-LC75-05, SIE-LC75-06: how the depth of a pocket is divided.
#include "reference/sinumerik/lcyc75.hpp"

namespace gonogo::reference::sinumerik {
namespace {

Number top_of(const PocketMilling& pocket) {
  return pocket.levels_from_clearance ? pocket.clearance : pocket.reference_plane;
}

}  // namespace

Number level_count(const PocketMilling& pocket) {
  return ((top_of(pocket) - pocket.floor) / pocket.infeed).ceil();
}

Number depth_of_level(const PocketMilling& pocket, const Number& k) {
  const Number top = top_of(pocket);
  if (pocket.levels == Levels::max_rest) return max(top - k * pocket.infeed, pocket.floor);
  return top - k * (top - pocket.floor) / level_count(pocket);
}

}  // namespace gonogo::reference::sinumerik
