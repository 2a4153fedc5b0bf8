// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {
namespace {

// In counts of the number as it is written, by the outcomes of ngc.whole. A G code is whole in
// tenths: as it is written, its limit is a tenth.
constexpr Fixed kCodeLimits[] = {0, kOne / 100'000, kOne / 10'000};
constexpr Fixed kFunctionLimits[] = {0, kOne / 10'000, kOne / 10'000};
constexpr Fixed kTurnLimits[] = {0, kOne / 10'000, kOne / 1'000};

// The number lies `rest` counts beside a whole step, to the nearest count. Tells whether what was
// written lies further away than `rest` says.
bool lies_beyond(const Decimal& number, Fixed rest) {
  if (!number.finer) return false;
  if (rest == 0) return true;
  const bool points_away_from_0 = (rest > 0) == (number.value > 0);
  return points_away_from_0 != number.rounded_up;
}

}  // namespace

std::optional<Fixed> WholeNumbers::tenths(const Decimal& code) const {
  const Fixed limit =
      faults_.alters("code-limit-unscaled"_fault, kCodeLimits[reading_], kFunctionLimits[reading_]);
  return steps(code, kOne / 10, limit);
}

std::optional<Fixed> WholeNumbers::function(const Decimal& number) const {
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
