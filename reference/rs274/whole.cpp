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
    : nearest_((value + Number::millionths(500'000)).floor()),
      off_(abs(value - nearest_)),
      is_beyond_(abs(value) > abs(nearest_)) {}

// grbl cuts a number at its point and rounds what is behind it to hundredths, of which a code may
// have tenths. P is no number of turns.
bool NearWhole::counts_for_grbl(Whole what) const {
  const Number half_a_hundredth = Number::millionths(5000);
  switch (what) {
    case Whole::turns:
      return false;
    case Whole::g_tenths: {
      const Number half = half_a_hundredth * 10;
      const Number whole_codes = nearest_ / 10;
      const bool has_tenths = whole_codes.floor() != whole_codes;
      return is_beyond_ ? off_ < half : has_tenths && off_ <= half;
    }
    case Whole::m_function:
    case Whole::repeats:
      return is_beyond_ && off_ < half_a_hundredth;
  }
  return false;
}

// NGC-COM-01
bool NearWhole::counts_as_whole(Whole what, const ReadingsInUse& readings) const {
  if (is_whole()) return true;
  const bool by_nist = off_ <= kOfNist;
  const bool by_linuxcnc = off_ <= limit_of_linuxcnc(what);
  const bool by_grbl = counts_for_grbl(what);
  if (!by_nist && !by_linuxcnc && !by_grbl) return false;
  if (readings.is("ngc.whole=exact"_reading)) return false;
  if (readings.is("ngc.whole=grbl"_reading)) return by_grbl;
  return readings.is("ngc.whole=linuxcnc"_reading) ? by_linuxcnc : by_nist;
}

}  // namespace gonogo::reference::rs274
