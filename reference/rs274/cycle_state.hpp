// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a cycle of holes leaves to the blocks behind it.
#pragma once

#include <optional>

#include "reference/exact/number.hpp"

namespace gonogo::reference::rs274 {

using exact::Number;

// NGC-CYC-03: words that hold until they are written anew. Numbers as written: they are read in the
// units and the distance mode of the block that uses them (NGC-CYC-19).
struct StickyWords {
  std::optional<Number> r;
  std::optional<Number> depth;  // of the third axis
  std::optional<Number> p;
  std::optional<Number> q;
};

// Coordinates of the third axis, mm.
struct CycleLevels {
  Number r_plane;  // R
  Number bottom;   // B
  friend bool operator==(const CycleLevels&, const CycleLevels&) = default;
};

// NGC-CYC-08: cycles one behind the other. Where the tool stood before them along the third axis.
struct Series {
  std::optional<Number> place;  // mm; nothing since the plane has changed (NGC-CYC-09)
  Number number;                // of the program that began it, in the units of that block
};

struct CycleState {
  StickyWords words;                  // of the cycle in force
  std::optional<CycleLevels> levels;  // of its last block
  std::optional<Series> series;
  std::optional<Number> last_p;  // of the last block of a cycle that had one in force

  // NGC-CYC-03: another code is in force.
  void forget_words() {
    words = {};
    levels.reset();
  }
  // NGC-CYC-09
  void leave_plane() {
    if (series) series->place.reset();
  }
};

}  // namespace gonogo::reference::rs274
