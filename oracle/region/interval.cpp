// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/region/interval.hpp"

#include <cstdint>

#include "oracle/region/level.hpp"

namespace gonogo::oracle::region {
namespace {

Interval from_integer(std::int64_t value) {
  const auto rounded = static_cast<double>(value);  // exact below 2^53
  constexpr std::int64_t kExact = std::int64_t{1} << 53;
  if (value <= kExact && value >= -kExact) return {rounded, rounded};
  return {below(rounded), above(rounded)};
}

}  // namespace

Interval enclose(const exact::Number& value) {
  static const exact::Number million(1'000'000);
  static const exact::Number coarse = exact::Number::binary(1, 20);
  static const exact::Number fine = exact::Number::binary(1, 70);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (value.is_rational()) {
    if (const auto count = (value * million).to_int64()) {
      return from_integer(*count) / Interval{1e6, 1e6};
    }
  }
  // Two digits in base 2^20 and 2^50: value = whole * 2^-20 + rest * 2^-70, rest in [0, 2^50].
  const exact::Number floor = (value * coarse).floor();
  const auto whole = floor.to_int64();
  if (!whole) return {-kInfinity, kInfinity};
  const auto rest = (value * fine - floor * exact::Number::binary(1, 50)).floor().to_int64();
  if (!rest) return {-kInfinity, kInfinity};
  const Interval digits = from_integer(*rest) + Interval{0, 1};
  return from_integer(*whole) * Interval{0x1p-20, 0x1p-20} + digits * Interval{0x1p-70, 0x1p-70};
}

IntervalVector enclose(const PlanePoint& point) {
  return {enclose(point.p), enclose(point.q)};
}

exact::Number to_number(double value) {
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  return exact::Number::binary(static_cast<std::int64_t>(std::ldexp(fraction, 53)), exponent - 53);
}

}  // namespace gonogo::oracle::region
