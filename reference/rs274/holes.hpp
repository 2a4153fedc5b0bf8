// SPDX-License-Identifier: GPL-3.0-or-later
//
// The holes of one block of a cycle, and the records of which a cycle makes one.
#pragma once

#include <functional>

#include "reference/rs274/polar_words.hpp"

namespace gonogo::reference::rs274 {

// Ready to run; coordinates in mm. Levels are coordinates of the third axis.
struct Holes {
  std::uint64_t line = 0;
  PlaneAxes axes{};
  Position start;                        // A
  std::vector<Record> approach;          // to the first hole
  std::array<Number, 2> first;           // place of the first hole in the plane
  std::array<Number, 2> step{};          // from one hole to the next; 0: all in one place
  std::optional<PolarSteps> polar = {};  // the same by polar words under G91
  Number count;                          // L
  Number r_plane;                        // R
  Number bottom;                         // B
  Number clear;                          // where a hole leaves the tool: C, except G73
  Number feed_in_force;
  FeedMode feed_mode = FeedMode::per_minute;
  Number dwell_time;  // s
  int spindle = 5;    // the sense that it has: M3, M4, M5

  // NGC-CYC-13, NGC-CYC-14: of hole k, from 1.
  std::array<Number, 2> place(const Number& k) const;

  // Records along the third axis, or of none.
  Record rapid(ClauseId clause, const Number& level) const;
  Record feed(ClauseId clause, const Number& level) const;
  Record dwell(ClauseId clause) const;
  // NGC-CYC-28
  Record spindle_function(ClauseId clause, int m) const;

 private:
  Record along(RecordKind kind, ClauseId clause, const Number& level) const;
};

// What a cycle does in a hole, from R to where the tool leaves it.
using Hole = std::function<Generator<Item>(const Holes&)>;

// All motion of the block. A motion of no length has no record.
Generator<Item> run_holes(Holes holes, Hole hole);

}  // namespace gonogo::reference::rs274
