// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/approximate.hpp"

#include <cstdlib>

namespace gonogo::oracle {

double approximate(const exact::Number& value) {
  // Whether an enclosure is a whole number cannot be decided, and need not be.
  if (value.is_rational()) {
    if (auto whole = value.to_int64()) return static_cast<double>(*whole);
  }
  return std::strtod(value.decimal_text(20).c_str(), nullptr);
}

}  // namespace gonogo::oracle
