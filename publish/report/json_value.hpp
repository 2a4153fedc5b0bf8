// SPDX-License-Identifier: GPL-3.0-or-later
//
// Members of JSON objects that may be missing or of another kind than they should be.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gonogo::oracle::report {

// The string; empty when it is missing or no string.
inline std::string text_of(const nlohmann::ordered_json& object, const char* key) {
  if (!object.is_object()) return {};
  auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// The strings of the list; none when it is missing or no list.
inline std::vector<std::string> texts_of(const nlohmann::ordered_json& object, const char* key) {
  std::vector<std::string> texts;
  if (!object.is_object()) return texts;
  const auto found = object.find(key);
  if (found == object.end() || !found->is_array()) return texts;
  for (const auto& one : *found) {
    if (one.is_string()) texts.push_back(one.get<std::string>());
  }
  return texts;
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
