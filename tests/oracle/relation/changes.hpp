// SPDX-License-Identifier: GPL-3.0-or-later
//
// Operators that change one thing in a trace.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "reference/record.hpp"
#include "tests/chance.hpp"

namespace gonogo::relation {

struct Change {
  std::string_view name;
  // False where it cannot be applied.
  bool (*apply)(std::vector<reference::Record>& records, const reference::Number& tau,
                Chance& chance);
};
std::span<const Change> changes();

}  // namespace gonogo::relation
