// SPDX-License-Identifier: GPL-3.0-or-later
//
// The passes of G76. (X0, Z0) is where the block begins, Z1 the end of the thread.
#pragma once

#include "reference/generator.hpp"
#include "reference/rs274/thread_words.hpp"

namespace gonogo::reference::rs274 {

// mm as true lengths; depths are beyond the peak.
struct ThreadPasses {
  std::uint64_t line = 0;
  Number feed_in_force;
  FeedMode feed_mode = FeedMode::per_minute;
  Position start;  // (X0, Z0)
  ThreadWords words;
  int side = 1;                // s: 1 inside, -1 outside
  int forward = 1;             // g: the sense of Z
  bool equal_lengths = false;  // ngc.g76.slide = end

  // NGC-G76-05: the depth of pass n, from 1.
  Number depth(const Number& n) const;
  // NGC-G76-06: X of a cut.
  Number cut(const Number& depth) const;
  // NGC-G76-07: X beside the cut.
  Number withdrawn(const Number& depth) const;
  // NGC-G76-08: where the pass starts and ends along Z.
  Number begin(const Number& depth) const;
  Number end(const Number& depth) const;
};

Generator<Item> run_passes(ThreadPasses passes);

}  // namespace gonogo::reference::rs274
