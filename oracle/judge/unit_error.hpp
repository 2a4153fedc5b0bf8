// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a feed, a lead, a dwell or a time that is off may come from: it is off by a factor between
// units. It explains a departure, and decides nothing.
#pragma once

#include <cstdint>
#include <string>

#include "reference/exact/number.hpp"

namespace gonogo::oracle {

using exact::Number;

// rotary_feed: of a rotary axis that moves alone; time: of cuts.
enum class Quantity : std::uint8_t { feed, rotary_feed, lead, dwell, time };

// A sentence with a blank before it where `got` is `want` times a factor between units, to
// `tolerance` in got (below a hundredth of it); empty: it is not.
// REQUIRES: want >= 0, got >= 0. What cannot be decided counts as no unit error.
std::string unit_error(Quantity quantity, const Number& want, const Number& got,
                       const Number& tolerance);

}  // namespace gonogo::oracle
