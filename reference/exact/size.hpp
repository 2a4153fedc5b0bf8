// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much of a computer an exact number takes: programs that calculate can make it grow without
// end.
#pragma once

#include <cstddef>

#include "reference/exact/number.hpp"

namespace gonogo::exact {

struct Size {
  std::size_t bits = 0;   // of numerator and denominator, of a root's parts too; at least 0
  std::size_t depth = 0;  // operations one upon the other, of an enclosure
};
Size size_of(const Number& value);

}  // namespace gonogo::exact
