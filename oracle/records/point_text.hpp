// SPDX-License-Identifier: GPL-3.0-or-later
//
// Numbers and points of a verdict as people read them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "reference/record.hpp"

namespace gonogo::oracle {

// A number as a record writes it; nothing of one that is too long to be read, or is none.
std::optional<reference::Number> number_of(const nlohmann::ordered_json& json);
// Rounded to nine decimals.
std::string millimetres_text(const reference::Number& value);
// J-CMP-12: the text of a point with decimals of nine places behind it, where it holds anything
// else: {"x":"7/3"} = x 2.333333333. Nothing of nothing; what is no point comes back as it is.
std::string point_for_people(const std::string& point);

}  // namespace gonogo::oracle
