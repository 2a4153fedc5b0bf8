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

}  // namespace gonogo::expanders
