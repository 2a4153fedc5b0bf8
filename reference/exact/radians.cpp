// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/exact/radians.hpp"

#include "reference/exact/enclosure.hpp"

namespace gonogo::exact {

Number radians(const Number& degrees) {
  if (degrees.is_rational() && degrees == Number(0)) return 0;
  return enclosure(Operation::radians, degrees);
}

}  // namespace gonogo::exact
