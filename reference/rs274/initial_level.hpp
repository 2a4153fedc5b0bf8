// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-CYC-08: I0, the level to which G98 returns.
#pragma once

#include "reference/reading_literal.hpp"
#include "reference/rs274/machine.hpp"

namespace gonogo::reference::rs274 {

// I0 under every reading of it, so that a reading is asked for only where it matters.
class InitialLevel {
 public:
  explicit InitialLevel(const BlockContext& block);

  // f(I0), mm.
  template <typename F>
  auto of(F f) const {
    auto of_block = f(of_block_);
    if (is_one_) return of_block;
    auto of_place = f(of_place_);
    auto of_number = f(of_number_);
    const bool kept_alike = of_place == of_number;
    if (kept_alike && of_place == of_block) return of_block;
    if (readings_.is("ngc.cycle.initial=block"_reading)) return of_block;
    if (kept_alike || readings_.is("ngc.cycle.initial-kept=place"_reading)) return of_place;
    return of_number;
  }
  // Whether it holds for I0 under each of them.
  template <typename Holds>
  bool always(Holds holds) const {
    return holds(of_block_) && (is_one_ || (holds(of_place_) && holds(of_number_)));
  }

 private:
  const ReadingsInUse& readings_;
  Number of_block_;   // ngc.cycle.initial = block
  Number of_place_;   // of a series; ngc.cycle.initial-kept = place
  Number of_number_;  // ngc.cycle.initial-kept = number
  bool is_one_;       // all three are the same
};

}  // namespace gonogo::reference::rs274
