// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/rs274/words.hpp"

#include <algorithm>

namespace gonogo::reference::rs274 {

std::optional<Number> BlockWords::length(char address) const {
  if (!has(address)) return std::nullopt;
  return modes_.length_of(written(address));
}

// NGC-UNI-01: degrees have no units. NGC-DIA-01: X may be a diameter.
std::optional<Number> BlockWords::along(const AxisLetter& axis) const {
  if (axis.axis == Axis::x && modes_.diameter && has('X')) return *length('X') / 2;
  if (is_linear(axis.axis)) return length(axis.address);
  if (!has(axis.address)) return std::nullopt;
  return written(axis.address);
}

bool BlockWords::has_axis_word() const {
  return is_polar() || std::ranges::any_of(
                           kAxisLetters, [&](const AxisLetter& axis) { return has(axis.address); });
}

}  // namespace gonogo::reference::rs274
