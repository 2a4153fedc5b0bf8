// SPDX-License-Identifier: GPL-3.0-or-later
// Products of squares of lengths, in full.
#pragma once

#include <compare>
#include <cstdint>

#include "expanders/common/fixed.hpp"

namespace gonogo::expanders {

/// A product of two numbers of 128 bits.
struct Product {
  unsigned __int128 high;
  unsigned __int128 low;
  constexpr auto operator<=>(const Product&) const = default;
};

/// `a`, `b`: not negative.
constexpr Product multiply(Wide a, Wide b) {
  using Unsigned = unsigned __int128;
  constexpr Unsigned kMask = ~std::uint64_t{0};
  const auto left = static_cast<Unsigned>(a);
  const auto right = static_cast<Unsigned>(b);
  const Unsigned low = (left & kMask) * (right & kMask);
  const Unsigned first = (left >> 64) * (right & kMask);
  const Unsigned second = (left & kMask) * (right >> 64);
  // Each term is below 2^64: the sum does not overflow.
  const Unsigned middle = (low >> 64) + (first & kMask) + (second & kMask);
  return {(left >> 64) * (right >> 64) + (first >> 64) + (second >> 64) + (middle >> 64),
          (middle << 64) | (low & kMask)};
}

/// a * b / c to the nearest whole number, halves upward; a, b not negative, c > 0. False: it is
/// too large for Wide.
inline bool divide_product(Wide a, Wide b, Wide c, Wide& quotient) {
  using Unsigned = unsigned __int128;
  const Product product = multiply(a, b);
  const auto divisor = static_cast<Unsigned>(c);
  if (product.high >= divisor) return false;
  // A bit a step; the rest stays below the divisor, which leaves room for one more bit.
  Unsigned rest = product.high;
  Unsigned result = 0;
  for (int bit = 127; bit >= 0; --bit) {
    rest = (rest << 1) | ((product.low >> bit) & 1);
    result <<= 1;
    if (rest < divisor) continue;
    rest -= divisor;
    result |= 1;
  }
  if (rest >= divisor - rest) ++result;
  quotient = static_cast<Wide>(result);
  return quotient >= 0;
}

}  // namespace gonogo::expanders
