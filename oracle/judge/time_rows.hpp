// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program's times are made of, for people.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "oracle/judge/cycle_time.hpp"

namespace gonogo::oracle {

struct TimePart {
  std::string_view what;  // "cuts"
  std::string_view unit;  // "s"
  Number amount;
};
// Cuts and dwells, turns of the spindle, the length of traverses.
std::array<TimePart, 4> parts_of(const CycleTime& time);

// "30 s", "3.667 s (exactly 11/3)", "15.708 s (rounded)": exact where it is a short number, else
// rounded to three decimals, and marked so.
std::string amount_text(const TimePart& part);

// What is said of part number `part`: a sentence with a blank before it where `got` is off by a
// factor between units; empty: it is not.
std::string time_hint(std::size_t part, const Number& want, const Number& got);

}  // namespace gonogo::oracle
