// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/whole.hpp"

#include "reference/reading_literal.hpp"

namespace gonogo::reference::rs274 {
namespace {

// NISTIR 6556, 3.3.2.1: close enough is "within 0.0001 of an integer".
const Number kOfNist = Number::millionths(100);

// As measured: LinuxCNC keeps to it for M functions and counts of holes and passes.
Number limit_of_linuxcnc(Whole what) {
  const bool is_strict = what == Whole::m_function || what == Whole::repeats;
  return is_strict ? kOfNist : Number::millionths(1000);
}

}  // namespace

NearWhole::NearWhole(const Number& value)
    : nearest_((value + Number::millionths(500'000)).floor()), off_(abs(value - nearest_)) {}

// NGC-COM-01
bool NearWhole::counts_as_whole(Whole what, const ReadingsInUse& readings) const {
  if (is_whole()) return true;
  const bool by_nist = off_ <= kOfNist;
  const bool by_linuxcnc = off_ <= limit_of_linuxcnc(what);
  if (!by_nist && !by_linuxcnc) return false;
  if (readings.is("ngc.whole=exact"_reading)) return false;
  return readings.is("ngc.whole=linuxcnc"_reading) ? by_linuxcnc : by_nist;
}

}  // namespace gonogo::reference::rs274
