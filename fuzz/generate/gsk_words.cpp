// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/gsk_writer.hpp"
#include "reference/reading_literal.hpp"

namespace gonogo::generate {

using reference::Increment;
using reference::Plane;
using reference::Units;

int GskWriter::decimals() const {
  return (units_ == Units::inch ? 4 : 3) + (profile_.increment == Increment::isc ? 1 : 0);
}

std::array<std::size_t, 3> GskWriter::plane_axes() const {
  switch (plane_) {
    case Plane::g17:
      return {0, 1, 2};
    case Plane::g18:
      return {2, 0, 1};
    case Plane::g19:
      return {1, 2, 0};
  }
  return {0, 1, 2};
}

std::string GskWriter::axis_word(std::size_t axis, std::int64_t most_mm) {
  const bool increment = choices_.one_in(3);
  std::int64_t value = length(most_mm);
  if (choices_.one_in(2)) value = -value;
  return word((increment ? "UVW" : "XYZ")[axis], value);
}

std::string GskWriter::stray_word() {
  return axis_word(choices_.below(3), 20);
}

bool GskWriter::may_have(Fault fault, const std::string& word) const {
  // A straight run-out along the tangent meets the thread itself.
  return fault != Fault::zero || word[0] != 'K' ||
         !profile_.readings.is("gsk.thread.runout=tangent"_reading);
}

}  // namespace gonogo::generate
