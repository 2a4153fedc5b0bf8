// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of G76 and their rules.
#pragma once

#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// ngc.g76.entry: how the tool goes in to where a taper begins (NGC-G76-09).
enum class TaperEntry : std::uint8_t { thread, feed, rapid };

// mm as true lengths; X is a radius.
struct ThreadWords {
  Position end;          // of the words: Z1, and under a reading X and Y of the last traverse
  Number lead;           // P
  Number peak;           // I, with its sign: below zero the thread is outside
  Number first_depth;    // J
  Number full_depth;     // K
  Number spring_passes;  // H
  Number taper;          // E
  bool taper_at_start = false;  // by L
  bool taper_at_end = false;
  TaperEntry entry = TaperEntry::thread;
  // R as a fraction in lowest terms.
  unsigned long degression = 1;
  unsigned long degression_divisor = 1;
  Number tangent;  // of Q

  // NGC-G76-05: whether pass n, from 1, is less deep than K.
  bool is_part_of_depth(const Number& n) const;
  bool enters_by_taper() const { return taper_at_start && taper.sign() > 0; }
  bool leaves_by_taper() const { return taper_at_end && taper.sign() > 0; }
};

// Nothing where the rules are broken, or the program is not read from here on.
std::optional<ThreadWords> read_thread_words(BlockContext& block);

}  // namespace gonogo::reference::rs274
