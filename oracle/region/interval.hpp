// SPDX-License-Identifier: GPL-3.0-or-later
//
// Enclosures in doubles for the region judge's filter: CGAL's intervals and its vectors over them.
// What they decide is decided; what they leave open goes to exact arithmetic.
//
// The intervals leave the rounding mode to code that computes with them: a `Rounding` stands in
// each function that the other rooms call, since to set it for each sum takes longer than the sum.
#pragma once

#include <CGAL/Interval_nt.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>

#include "reference/exact/number.hpp"

namespace gonogo::oracle::region {

struct PlanePoint;

using Interval = CGAL::Interval_nt<false>;
using Rounding = Interval::Protector;
using IntervalVector = CGAL::Simple_cartesian<Interval>::Vector_2;

// CGAL's own sets the rounding mode twice. A root that is rounded up, less the smallest number, is
// below it. REQUIRES: not all of it is negative.
inline Interval square_root(const Interval& a) {
  return Interval(CGAL::IA_sqrt_up(std::max(a.inf(), 0.0)), CGAL::IA_sqrt_up(a.sup())) +
         Interval::smallest();
}
inline Interval norm(const IntervalVector& a) {
  return square_root(a.squared_length());
}
inline IntervalVector unit(const IntervalVector& a) {
  return a / norm(a);
}

// An enclosure a few units in the last place wide; the whole line for what does not fit.
Interval enclose(const exact::Number& value);
IntervalVector enclose(const PlanePoint& point);
// The same value.
exact::Number to_number(double value);
// The point in the middle of the enclosure.
PlanePoint middle_of(const IntervalVector& place);

}  // namespace gonogo::oracle::region
