// SPDX-License-Identifier: GPL-3.0-or-later
//
// The motions of pecks or passes side by side: one coordinate over the motions in their order.
// Private to sheet.cpp.
#pragma once

#include <cstdint>
#include <optional>

#include "publish/report/path.hpp"
#include "publish/report/views.hpp"

namespace gonogo::oracle::report {

// Which coordinate is shown, and of which motions.
struct Unfolding {
  char axis = 'Z';
  std::uint64_t block = 0;  // only of this block; 0: of all
};

// Where some coordinate goes to and fro often enough, along a line of its own: in the block, if it
// is not 0; else in the whole path if that is short, else in its busiest block.
std::optional<Unfolding> unfolding_of(const Path& path, std::uint64_t block);
// The same path, with as many motions, seen so: X is the place of the motion, Z the coordinate.
// Motions of other blocks do not move in it.
Path unfolded(const Path& path, const Unfolding& how);
// Lays an unfolded path beside that of the reference: the motion that departs begins in the column
// of the one that was due, and what was accepted before it has the width of what it was accepted
// for.
void align(Path& departing, const std::optional<std::size_t>& motion, const Path& reference,
           const std::optional<std::size_t>& due);

}  // namespace gonogo::oracle::report
