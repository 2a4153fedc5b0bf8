// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/interval.hpp"

#include <cmath>
#include <cstdint>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {

Interval enclose(const exact::Number& value) {
  const Rounding outward;
  static const exact::Number million(1'000'000);
  static const exact::Number coarse = exact::Number::binary(1, 20);
  static const exact::Number fine = exact::Number::binary(1, 70);
  if (value.is_rational()) {
    if (const auto count = (value * million).to_int64()) return Interval(*count) / Interval(1e6);
  }
  // Two digits in base 2^20 and 2^50: value = whole * 2^-20 + rest * 2^-70, rest in [0, 2^50].
  const exact::Number floor = (value * coarse).floor();
  const auto whole = floor.to_int64();
  if (!whole) return Interval::largest();
  const auto rest = (value * fine - floor * exact::Number::binary(1, 50)).floor().to_int64();
  if (!rest) return Interval::largest();
  return Interval(*whole) * 0x1p-20 + (Interval(*rest) + Interval(0, 1)) * 0x1p-70;
}

IntervalVector enclose(const PlanePoint& point) {
  return {enclose(point.p), enclose(point.q)};
}

exact::Number to_number(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return exact::Number::binary(static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53);
}

PlanePoint middle_of(const IntervalVector& place) {
  return {to_number(median(place.x())), to_number(median(place.y()))};
}

}  // namespace gonogo::oracle::region
