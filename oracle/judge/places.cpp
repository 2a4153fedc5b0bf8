// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace gonogo::oracle {
namespace {

// Two coordinates that are rounded to doubles are off by no more than half a unit in the last place
// each: together by 2^-52 of the larger one, which is less than this.
Number rounding_of(const Number& a, const Number& b) {
  constexpr int kBits = 52;
  const double size = std::max(std::abs(estimate(a)), std::abs(estimate(b)));
  int exponent = 0;
  std::frexp(size, &exponent);
  return Number::binary(1, exponent - kBits);
}

}  // namespace

bool same_place(const Position& a, const Position& b, const JudgeTerms& terms) {
  for (Axis axis : reference::kAllAxes) {
    if (agree(a[axis], b[axis], terms.tolerance)) continue;
    if (!terms.binary64) return false;
    if (!agree(a[axis], b[axis], terms.tolerance + rounding_of(a[axis], b[axis]))) return false;
  }
  return true;
}

bool stays_at(const Position& place, const Motion& motion, const JudgeTerms& terms) {
  return same_place(motion.from, place, terms) && same_place(motion.to(), place, terms) &&
         !goes_round(motion, terms.tolerance);
}

}  // namespace gonogo::oracle
