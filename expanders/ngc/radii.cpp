// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/radii.hpp"

#include <algorithm>
#include <compare>
#include <cstdint>

namespace gonogo::expanders::ngc {
namespace {

using Unsigned = unsigned __int128;

/// A product of two numbers of 128 bits.
struct Product {
  Unsigned high;
  Unsigned low;
  auto operator<=>(const Product&) const = default;
};

Product multiply(Wide a, Wide b) {
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

// The sign of |sqrt(a) - sqrt(b)| - sqrt(t): with a the larger, that of a - b - t - 2 sqrt(b t).
int compare_difference(Wide a, Wide b, Wide tolerance) {
  if (a < b) std::swap(a, b);
  const Wide rest = a - b - tolerance;
  if (rest < 0) return -1;
  const auto order = multiply(rest, rest) <=> multiply(4 * tolerance, b);
  return order < 0 ? -1 : order > 0 ? 1 : 0;
}

}  // namespace

bool differ_by_more(Wide a, Wide b, Wide tolerance) {
  return compare_difference(a, b, tolerance) > 0;
}

bool too_far_apart(Wide start_square, Wide end_square, const RadiusTolerance& tolerance,
                   bool strict) {
  const int order = compare_difference(start_square, end_square, tolerance.always);
  if (order > 0 || (strict && order == 0)) return true;
  if (tolerance.relative < 0 || !differ_by_more(start_square, end_square, tolerance.relative)) {
    return false;
  }
  // More than 1/1000 of the larger: the smaller is below 999/1000 of it.
  const auto [smaller, larger] = std::minmax(start_square, end_square);
  return multiply(smaller, 1'000'000) < multiply(larger, 998'001);
}

}  // namespace gonogo::expanders::ngc
