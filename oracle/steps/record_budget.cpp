// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/record_budget.hpp"

#include <algorithm>
#include <variant>

namespace gonogo::oracle {

bool RecordBudget::runs_low(std::size_t records, std::size_t live) const {
  return counting(records) > kMostTimes * live + kMostIdle / 2;
}

bool RecordBudget::allows(std::size_t records, std::size_t live) {
  while (counting(records) > kMostTimes * std::max(counted_, live) + kMostIdle) {
    if (complete_) return false;
    if (!shown_) shown_.emplace(profile_, program_);
    const reference::Item* const item = shown_->expander.next();
    complete_ = item == nullptr;
    if (complete_) continue;
    ++counted_;
    const auto* const last = std::get_if<reference::Record>(item);
    has_end_ = last != nullptr && last->kind == reference::RecordKind::end;
  }
  return true;
}

}  // namespace gonogo::oracle
