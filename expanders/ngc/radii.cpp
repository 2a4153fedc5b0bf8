// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/radii.hpp"

#include <algorithm>

#include "expanders/common/product.hpp"

namespace gonogo::expanders::ngc {
namespace {

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
  if (tolerance.of_start && end_square > start_square) {
    return multiply(end_square, 1'000'000) > multiply(start_square, 1'002'001);
  }
  // More than 1/1000 of the larger: the smaller is below 999/1000 of it.
  const auto [smaller, larger] = std::minmax(start_square, end_square);
  return multiply(smaller, 1'000'000) < multiply(larger, 998'001);
}

}  // namespace gonogo::expanders::ngc
