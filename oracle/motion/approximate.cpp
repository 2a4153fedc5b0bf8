// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/motion/approximate.hpp"

#include <cstdlib>

namespace gonogo::oracle {
namespace {

// Whole numbers up to here are doubles, and then the quotient of two is correctly rounded: what the
// long way by text comes to.
constexpr std::int64_t kExactDouble = std::int64_t{1} << 53;

}  // namespace

double approximate(const exact::Number& value) {
  if (exact::NumberAccess::node(value) == nullptr) {
    const std::int64_t count = exact::NumberAccess::millionths(value);
    if (count >= -kExactDouble && count <= kExactDouble) {
      return static_cast<double>(count) / static_cast<double>(exact::detail::kUnit);
    }
  }
  // Whether an enclosure is a whole number cannot be decided, and need not be.
  if (value.is_rational()) {
    if (auto whole = value.to_int64()) return static_cast<double>(*whole);
  }
  return std::strtod(value.decimal_text(20).c_str(), nullptr);
}

}  // namespace gonogo::oracle
