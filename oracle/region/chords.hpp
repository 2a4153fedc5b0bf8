// SPDX-License-Identifier: GPL-3.0-or-later
//
// J-PKT-07: straight motions that are chords of arcs, where the certifier grants them.
#pragma once

#include <span>
#include <vector>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

// Says of each motion whether it is a chord: a line that, together with the line before or after
// it, turns by less than 90 degrees and runs nowhere farther than `limit` from the circle through
// the three ends.
std::vector<bool> find_chords(std::span<const LevelMotion> motions, const Number& limit);

// The first chord at which those in a row have turned against the sense by more than 45 degrees;
// nothing when none have. Chords no longer than `shortest` are taken together: their directions
// are rounding.
enum class Turning { as_commanded, against, undecided };
struct ChordTurning {
  Turning kind = Turning::as_commanded;
  std::size_t motion = 0;  // against: index
};
ChordTurning turning_of(std::span<const LevelMotion> motions, const std::vector<bool>& chords,
                        int sense, const Number& shortest);

}  // namespace gonogo::oracle::region
