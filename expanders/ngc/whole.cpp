// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {
namespace {

// The number lies `rest` counts beside a whole step, to the nearest count. Tells whether what was
// written lies further away than `rest` says.
bool lies_beyond(const Decimal& number, Fixed rest) {
  if (!number.finer) return false;
  if (rest == 0) return true;
  const bool points_away_from_0 = (rest > 0) == (number.value > 0);
  return points_away_from_0 != number.rounded_up;
}

}  // namespace

Fixed WholeNumbers::by_reading(Fixed nist, Fixed linuxcnc) const {
  if (readings_.follows("ngc.whole=nist"_reading)) return nist;
  return readings_.follows("ngc.whole=linuxcnc"_reading) ? linuxcnc : 0;
}

std::optional<Fixed> WholeNumbers::cut_steps(const Decimal& number, Fixed hundredths) {
  if (number.overflow) return std::nullopt;
  const Fixed whole = number.value / kOne;
  const Fixed rest = number.value % kOne;
  const bool is_short_of_whole = rest == 0 && number.finer && number.rounded_up;
  if (is_short_of_whole) return std::nullopt;
  Fixed rounded = magnitude(rest) * 100 / kOne;
  const Fixed beyond = magnitude(rest) * 100 % kOne * 2;
  const bool is_less = beyond == kOne && number.finer && number.rounded_up;
  if (beyond >= kOne && !is_less) ++rounded;
  if (rounded == 100) return std::nullopt;  // more than any code has
  const Fixed all = whole * 100 + (number.value < 0 ? -rounded : rounded);
  return all % hundredths == 0 ? std::optional(all / hundredths) : std::nullopt;
}

// A G code is whole in tenths: as it is written, its limit is a tenth.
std::optional<Fixed> WholeNumbers::tenths(const Decimal& code) const {
  if (readings_.follows("ngc.whole=grbl"_reading)) return cut_steps(code, 10);
  const Fixed most =
      faults_.alters("code-limit-unscaled"_fault, by_reading(kOne / 100'000, kOne / 10'000),
                     by_reading(kOne / 10'000, kOne / 10'000));
  return steps(code, kOne / 10, most);
}

std::optional<Fixed> WholeNumbers::function(const Decimal& number) const {
  if (readings_.follows("ngc.whole=grbl"_reading)) return cut_steps(number, 100);
  return steps(number, kOne, by_reading(kOne / 10'000, kOne / 10'000));
}

std::optional<Fixed> WholeNumbers::turns(const Decimal& number) const {
  return steps(number, kOne, by_reading(kOne / 10'000, kOne / 1'000));
}

// How many steps of `step` counts; `limit` is less than half a step.
std::optional<Fixed> WholeNumbers::steps(const Decimal& number, Fixed step, Fixed limit) const {
  if (number.overflow) return std::nullopt;
  Fixed steps = number.value / step;
  Fixed rest = number.value % step;
  if (2 * magnitude(rest) > step) {
    steps += sign_of(rest);
    rest -= sign_of(rest) * step;
  }
  if (magnitude(rest) > limit) return std::nullopt;
  if (magnitude(rest) == limit) {
    if (lies_beyond(number, rest)) return std::nullopt;
    if (limit != 0 && faults_.adds("whole-limit-refused"_fault)) return std::nullopt;
  }
  return faults_.alters("near-whole-cut"_fault, steps, steps - (rest < 0 ? 1 : 0));
}

}  // namespace gonogo::expanders::ngc
