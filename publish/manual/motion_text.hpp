// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers, points and records as people read them.
#pragma once

#include <string>

#include "reference/record.hpp"

namespace gonogo::oracle::manual {

// Exact where a number is a short decimal, else six decimals.
std::string shown_number(const reference::Number& value);
// 'X'
char capital(reference::Axis axis);
// "X25 Z-30": the coordinates along `axes`.
std::string point_text(const reference::Position& at, const reference::AxisSet& axes);
// "feed to X25 Z-30, 300 mm/min", with shown_number.
std::string motion_text(const reference::Record& record);

}  // namespace gonogo::oracle::manual
