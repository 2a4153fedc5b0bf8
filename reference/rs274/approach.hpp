// SPDX-License-Identifier: GPL-3.0-or-later
//
// The way of a cycle to its first hole.
#pragma once

#include <vector>

#include "reference/rs274/initial_level.hpp"

namespace gonogo::reference::rs274 {

// Traverses one behind the other; no negligible one.
struct Approach {
  std::vector<Record> traverses;
  std::size_t lifts = 0;  // how many of them come before the tool crosses to the hole

  // Whether both lead over the same places.
  friend bool operator==(const Approach& a, const Approach& b);
};

// Where a cycle begins: the block, the hole (its place in the plane, at R), and I0.
struct HoleAhead {
  const BlockContext& block;
  const InitialLevel& initial;
  Position hole;

  const Number& r_plane() const { return hole[axes_of(block.machine.plane).d]; }
};

// NGC-CYC-10: C, the clear level.
Number clear_level(const HoleAhead& ahead);
// NGC-CYC-11, NGC-CYC-12.
Approach approach(const HoleAhead& ahead);
// Whether `holds` is true of it under every reading.
bool always_approached(const HoleAhead& ahead, bool (*holds)(const Approach&));

}  // namespace gonogo::reference::rs274
