// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/hnc21t/words.hpp"

namespace gonogo::reference::hnc21t {

std::optional<Number> BlockWords::length(char address) const {
  if (!has(address)) return std::nullopt;
  return modes_.inch ? inches(written(address)) : written(address);
}

std::optional<AxisWord> BlockWords::axis_word(const AxisAddresses& addresses) const {
  const bool by_letter = !has(addresses.absolute);
  std::optional<Number> value = length(by_letter ? addresses.increment : addresses.absolute);
  if (!value) return std::nullopt;
  if (addresses.axis == Axis::x && modes_.diameter) value = *value / 2;
  return AxisWord{by_letter || modes_.incremental, *value};
}

}  // namespace gonogo::reference::hnc21t
