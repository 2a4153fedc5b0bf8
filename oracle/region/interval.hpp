// SPDX-License-Identifier: GPL-3.0-or-later
//
// Enclosures in doubles for the region judge's filter: only + - * / and square roots, each bound
// moved outward past the rounding error. What they decide is decided; what they leave open goes to
// exact arithmetic.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/number.hpp"

namespace gonogo::oracle::region {

struct PlanePoint;

// What is always put in line, the compiler would call: a seventh of what a level costs.

// |x| * 2^-52 is at least one unit in the last place of x, so the sum lies beyond its neighbour; so
// does 2^-500, where that is too small a double to be told from none. It is no smaller because
// products of the smallest doubles take many processors a hundred times as long.
[[gnu::always_inline]] inline double above(double x) {
  return x + (std::fabs(x) * 0x1p-52 + 0x1p-500);
}
[[gnu::always_inline]] inline double below(double x) {
  return x - (std::fabs(x) * 0x1p-52 + 0x1p-500);
}

// Every value from lo to hi. A bound that is no number makes every decision below come out "open".
struct Interval {
  double lo = 0;
  double hi = 0;

  double middle() const { return lo + (hi - lo) / 2; }
};

[[gnu::always_inline]] inline Interval operator+(Interval a, Interval b) {
  return {below(a.lo + b.lo), above(a.hi + b.hi)};
}
[[gnu::always_inline]] inline Interval operator-(Interval a, Interval b) {
  return {below(a.lo - b.hi), above(a.hi - b.lo)};
}
[[gnu::always_inline]] inline Interval operator-(Interval a) {
  return {-a.hi, -a.lo};
}
[[gnu::always_inline]] inline Interval operator*(Interval a, Interval b) {
  const double w = a.lo * b.lo;
  const double x = a.lo * b.hi;
  const double y = a.hi * b.lo;
  const double z = a.hi * b.hi;
  return {below(std::min(std::min(w, x), std::min(y, z))),
          above(std::max(std::max(w, x), std::max(y, z)))};
}
// The whole line when the divisor may be zero.
inline Interval operator/(Interval a, Interval b) {
  if (!(b.lo > 0 || b.hi < 0)) {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  }
  const double w = a.lo / b.lo;
  const double x = a.lo / b.hi;
  const double y = a.hi / b.lo;
  const double z = a.hi / b.hi;
  return {below(std::min(std::min(w, x), std::min(y, z))),
          above(std::max(std::max(w, x), std::max(y, z)))};
}
[[gnu::always_inline]] inline Interval absolute(Interval a) {
  if (a.lo >= 0) return a;
  if (a.hi <= 0) return -a;
  return {0, std::max(-a.lo, a.hi)};
}
[[gnu::always_inline]] inline Interval square(Interval a) {
  const Interval b = absolute(a);
  return {std::max(0.0, below(b.lo * b.lo)), above(b.hi * b.hi)};
}
// The root of the part that is not negative.
inline Interval square_root(Interval a) {
  return {std::max(0.0, below(std::sqrt(std::max(a.lo, 0.0)))),
          above(std::sqrt(std::max(a.hi, 0.0)))};
}
inline Interval hull(Interval a, Interval b) {
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

struct IntervalVector {
  Interval x;
  Interval y;
};

[[gnu::always_inline]] inline IntervalVector operator+(const IntervalVector& a,
                                                       const IntervalVector& b) {
  return {a.x + b.x, a.y + b.y};
}
[[gnu::always_inline]] inline IntervalVector operator-(const IntervalVector& a,
                                                       const IntervalVector& b) {
  return {a.x - b.x, a.y - b.y};
}
[[gnu::always_inline]] inline IntervalVector operator-(const IntervalVector& a) {
  return {-a.x, -a.y};
}
[[gnu::always_inline]] inline IntervalVector operator*(Interval k, const IntervalVector& a) {
  return {k * a.x, k * a.y};
}
[[gnu::always_inline]] inline Interval dot(const IntervalVector& a, const IntervalVector& b) {
  return a.x * b.x + a.y * b.y;
}
[[gnu::always_inline]] inline Interval cross(const IntervalVector& a, const IntervalVector& b) {
  return a.x * b.y - a.y * b.x;
}
[[gnu::always_inline]] inline Interval norm_squared(const IntervalVector& a) {
  return square(a.x) + square(a.y);
}
[[gnu::always_inline]] inline Interval norm(const IntervalVector& a) {
  return square_root(norm_squared(a));
}
inline IntervalVector unit(const IntervalVector& a) {
  const Interval length = norm(a);
  return {a.x / length, a.y / length};
}
inline IntervalVector exactly(double x, double y) {
  return {{x, x}, {y, y}};
}

// An enclosure a few units in the last place wide; the whole line for what does not fit.
Interval enclose(const exact::Number& value);
IntervalVector enclose(const PlanePoint& point);
// The same value.
exact::Number to_number(double value);

}  // namespace gonogo::oracle::region
