// SPDX-License-Identifier: GPL-3.0-or-later
//
// Members of JSON objects that may be missing or of another kind than they should be.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace gonogo::oracle::report {

// The string; empty when it is missing or no string.
inline std::string text_of(const nlohmann::ordered_json& object, const char* key) {
  if (!object.is_object()) return {};
  auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// The whole number that is not negative.
inline std::optional<std::uint64_t> count_of(const nlohmann::ordered_json& object,
                                             const char* key) {
  if (!object.is_object()) return std::nullopt;
  auto found = object.find(key);
  if (found == object.end() || !found->is_number_unsigned()) return std::nullopt;
  return found->get<std::uint64_t>();
}

}  // namespace gonogo::oracle::report
