// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/judge/record_budget.hpp"

#include <algorithm>

namespace gonogo::oracle {

bool RecordBudget::allows(std::size_t records, std::size_t live) {
  constexpr std::size_t kFactor = 10;
  constexpr std::size_t kSlack = 1'000;
  while (records - forgiven_ > kFactor * std::max(counted_, live) + kSlack) {
    if (complete_) return false;
    complete_ = expander_.next() == nullptr;
    if (!complete_) ++counted_;
  }
  return true;
}

}  // namespace gonogo::oracle
