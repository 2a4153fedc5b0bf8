// SPDX-License-Identifier: GPL-3.0-or-later
//
// R2: places and pieces that are near each other. REQUIRES: all numbers are rational.
#pragma once

#include <optional>

#include "oracle/relation/event.hpp"

namespace gonogo::relation {

Position point_at(const Event& piece, const Number& part);
bool is_near(const Position& a, const Position& b, const Number& tolerance);

struct Part01 {
  Number low = 0;
  Number high = 1;
};
// The part of a piece that is near a place; nothing: no part is.
std::optional<Part01> near_part(const Event& piece, const Position& place, const Number& tolerance);

}  // namespace gonogo::relation
