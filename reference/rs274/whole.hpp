// SPDX-License-Identifier: GPL-3.0-or-later
//
// NGC-COM-01: numbers that must be whole, and how near to a whole one is near enough.
#pragma once

#include "reference/exact/number.hpp"
#include "reference/reading.hpp"

namespace gonogo::reference::rs274 {

using exact::Number;

// What the number is; interpreters are not equally strict with all of them.
enum class Whole { g_tenths, m_function, turns, repeats };

class NearWhole {
 public:
  explicit NearWhole(const Number& value);

  bool is_whole() const { return off_.sign() == 0; }
  const Number& nearest() const { return nearest_; }
  // Whether the number is taken as the nearest whole one. The reading ngc.whole is asked for only
  // where it matters.
  bool counts_as_whole(Whole what, const ReadingsInUse& readings) const;

 private:
  bool counts_for_grbl(Whole what) const;

  Number nearest_;
  Number off_;              // how far away it is, from 0 to 1/2
  bool is_beyond_ = false;  // farther from zero than the nearest, or that is zero
};

}  // namespace gonogo::reference::rs274
