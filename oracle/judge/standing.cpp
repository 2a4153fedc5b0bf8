// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/standing.hpp"

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

bool may_mean_none(const Motion& motion, const Number& tolerance,
                   std::span<const Record> dropped_arcs) {
  if (!goes_round(motion, tolerance)) return true;
  const Record& got = motion.record;
  return got.kind == RecordKind::arc && std::abs(got.rot) == 1 &&
         std::ranges::any_of(dropped_arcs, [&](const Record& arc) {
           return arc.plane == got.plane && (arc.rot < 0) == (got.rot < 0) &&
                  agree(arc.centre[0], got.centre[0], tolerance) &&
                  agree(arc.centre[1], got.centre[1], tolerance);
         });
}

}  // namespace gonogo::oracle
