// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far arcs of one sense turn together, or chords of one.
#pragma once

#include <numbers>

#include "oracle/region/constants.hpp"
#include "reference/exact/number.hpp"

namespace gonogo::oracle {

class SweptTurns {
 public:
  void add(double turns) {
    turns_ += turns;
    lost_ += kLost;
  }
  // For the evidence.
  double estimate() const { return turns_; }
  // Whether they make more than one turn, by more than `beyond` mm on a circle of `radius` mm.
  // Throws exact::Undecided where the doubles do not tell.
  bool exceed_a_turn(double beyond, double radius) const {
    const double over = turns_ - 1 - beyond / (2 * std::numbers::pi * radius);
    if (over > lost_) return true;
    if (over > -lost_) {
      throw exact::Undecided("whether arcs make more than one turn is too close to tell");
    }
    return false;
  }

 private:
  double turns_ = 0;
  double lost_ = 0;
};

}  // namespace gonogo::oracle
