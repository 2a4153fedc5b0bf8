// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "reference/exact/number.hpp"

namespace gonogo::oracle {

// As it stands in a record.
inline nlohmann::ordered_json json_of(const exact::Number& value) {
  std::string text;
  value.append_json(text);
  return nlohmann::ordered_json::parse(text);
}

}  // namespace gonogo::oracle
