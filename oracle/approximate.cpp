// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/approximate.hpp"

#include <cstdlib>

namespace gonogo::oracle {

double approximate(const exact::Number& value) {
  // Both are doubles without rounding, and so their quotient is the nearest one to the value.
  constexpr std::int64_t kEveryInteger = std::int64_t{1} << 53;
  if (exact::NumberAccess::node(value) == nullptr) {
    const std::int64_t count = exact::NumberAccess::millionths(value);
    if (-kEveryInteger < count && count < kEveryInteger) return static_cast<double>(count) / 1e6;
  }
  // Whether an enclosure is a whole number cannot be decided, and need not be.
  if (value.is_rational()) {
    if (auto whole = value.to_int64()) return static_cast<double>(*whole);
  }
  return std::strtod(value.decimal_text(20).c_str(), nullptr);
}

}  // namespace gonogo::oracle
