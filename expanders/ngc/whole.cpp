// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {
namespace {

// In counts of the number as it is written, by the outcomes of ngc.whole. A G code is whole in
// tenths: as it is written, its limit is a tenth. For grbl codes and functions have another rule.
constexpr Fixed kCodeLimits[] = {0, kOne / 100'000, kOne / 10'000};
constexpr Fixed kFunctionLimits[] = {0, kOne / 10'000, kOne / 10'000};
constexpr Fixed kTurnLimits[] = {0, kOne / 10'000, kOne / 1'000, 0};

// The number lies `rest` counts beside a whole step, to the nearest count. Tells whether what was
// written lies further away than `rest` says.
bool lies_beyond(const Decimal& number, Fixed rest) {
  if (!number.finer) return false;
  if (rest == 0) return true;
  const bool points_away_from_0 = (rest > 0) == (number.value > 0);
  return points_away_from_0 != number.rounded_up;
}

}  // namespace

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

std::optional<Fixed> WholeNumbers::tenths(const Decimal& code) const {
  if (reading_ == kGrbl) return cut_steps(code, 10);
  const Fixed limit =
      faults_.alters("code-limit-unscaled"_fault, kCodeLimits[reading_], kFunctionLimits[reading_]);
  return steps(code, kOne / 10, limit);
}

std::optional<Fixed> WholeNumbers::function(const Decimal& number) const {
  if (reading_ == kGrbl) return cut_steps(number, 100);
  return steps(number, kOne, kFunctionLimits[reading_]);
}

std::optional<Fixed> WholeNumbers::turns(const Decimal& number) const {
  return steps(number, kOne, kTurnLimits[reading_]);
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
