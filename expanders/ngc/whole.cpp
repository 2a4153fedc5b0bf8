// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/ngc/whole.hpp"

namespace gonogo::expanders::ngc {
namespace {

// Of a number that lies `rest` counts beside a whole step, to the nearest count: whether what was
// written lies further away than `rest` says.
bool lies_beyond(const Decimal& number, Fixed rest) {
  if (!number.finer) return false;
  if (rest == 0) return true;
  const bool points_away_from_0 = (rest > 0) == (number.value > 0);
  return points_away_from_0 != number.rounded_up;
}

// How many steps of `step` counts; `limit` is less than half a step.
std::optional<Fixed> whole_steps(const Decimal& number, Fixed step, Fixed limit,
                                 const WholeRule& rule) {
  if (number.overflow) return std::nullopt;
  Fixed steps = number.value / step;
  Fixed rest = number.value % step;
  if (2 * magnitude(rest) > step) {
    steps += sign_of(rest);
    rest -= sign_of(rest) * step;
  }
  if (magnitude(rest) > limit) return std::nullopt;
  if (magnitude(rest) == limit) {
    if (lies_beyond(number, rest) || (limit != 0 && rule.limit_refused)) return std::nullopt;
  }
  return rule.cut && rest < 0 ? steps - 1 : steps;
}

}  // namespace

std::optional<Fixed> whole_tenths(const Decimal& code, const WholeRule& rule) {
  return whole_steps(code, kOne / 10, rule.code, rule);
}

std::optional<Fixed> whole_function(const Decimal& number, const WholeRule& rule) {
  return whole_steps(number, kOne, rule.function, rule);
}

std::optional<Fixed> whole_turns(const Decimal& number, const WholeRule& rule) {
  return whole_steps(number, kOne, rule.turns, rule);
}

}  // namespace gonogo::expanders::ngc
