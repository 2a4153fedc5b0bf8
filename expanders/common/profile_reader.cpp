// SPDX-License-Identifier: GPL-3.0-or-later
#include "expanders/common/profile_reader.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>

namespace gonogo::expanders {
ConfigurationResult ProfileReader::read(std::string_view text) {
  const Json json = Json::parse(text.begin(), text.end(), nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    message_ = "The configuration is no JSON object.";
    return ConfigurationResult::kMalformed;
  }
  return document(json) ? ConfigurationResult::kRead : ConfigurationResult::kUnsupported;
}

bool ProfileReader::document(const Json& json) {
  for (const auto& [key, value] : json.items()) {
    if (key == "dialect") {
      if (!dialect(value)) return false;
    } else if (key == "profile") {
      if (value.is_null()) continue;
      if (!value.is_object()) return refuse(key, value);
      if (!profile(value)) return false;
    } else if (key != "cmd") {
      return refuse(key, value);
    }
  }
  return true;
}

bool ProfileReader::refuse(const std::string& key, const Json& value) {
  message_ = "The profile's " + key + " = " + value.dump() + " is not implemented.";
  return false;
}

bool ProfileReader::dialect(const Json& value) {
  return value == dialect_ || refuse("dialect", value);
}

bool ProfileReader::each(const std::string& name, const Json& json, Part part) {
  if (!json.is_object()) return refuse(name, json);
  for (const auto& [key, value] : json.items()) {
    if (!(this->*part)(key, value)) return false;
  }
  return true;
}

bool ProfileReader::profile(const Json& json) {
  return each("profile", json, &ProfileReader::entry);
}

bool ProfileReader::entry(const std::string& key, const Json& value) {
  Fixed resolution = 0;
  if (key == "dialect") return dialect(value);
  if (key == "units") return word(key, value, "mm", "inch", common_.inch);
  // The gauge's tolerance follows from it; the output here is finer than any.
  if (key == "resolution") return decimal(key, value, resolution);
  if (key == "block_skip") return boolean(key, value, common_.block_skip);
  if (key == "alarm_timing") return value == "block" || refuse(key, value);
  if (key == "initial") return each(key, value, &ProfileReader::initial);
  if (key == "readings") return each(key, value, &ProfileReader::reading);
  return setting(key, value);
}

bool ProfileReader::foreign(const std::string& key, const Json& value) {
  const bool table = key == "offsets" || key == "parameters" || key == "tools";
  const bool standard = (key == "increment" && value == "ISB") ||
                        (key == "x_diameter" && value == false) ||
                        (table && value.is_object() && value.empty());
  return standard || refuse(key, value);
}

bool ProfileReader::is_any(const Json& json) {
  return text_of(json) == "any";
}

std::string ProfileReader::text_of(const Json& json) {
  return json.is_string() ? json.get<std::string>() : json.dump();
}

bool ProfileReader::decimal(const std::string& key, const Json& json, Fixed& value) {
  const std::optional<Fixed> number = fixed_of(text_of(json));
  if (!number) return refuse(key, json);
  value = *number;
  return true;
}

bool ProfileReader::not_negative(const std::string& key, const Json& json, Fixed& value,
                                 Fixed most) {
  if (!decimal(key, json, value)) return false;
  return (value >= 0 && value <= most) || refuse(key, json);
}

bool ProfileReader::axis(const std::string& key, const Json& json, Point& point) {
  static constexpr std::string_view kNames = "xyzac";  // in the order of gonogo_axis
  if (key.size() != 1 || kNames.find(key[0]) == std::string_view::npos) return refuse(key, json);
  return decimal(key, json, point[kNames.find(key[0])]);
}

bool ProfileReader::point(const std::string& key, const Json& json, Point& point) {
  if (!json.is_object()) return refuse(key, json);
  for (const auto& [name, value] : json.items()) {
    if (!axis(name, value, point)) return false;
  }
  return true;
}

bool ProfileReader::code(const std::string& key, const Json& json, int lowest, int highest,
                         int& value) {
  const std::string text = text_of(json);
  const char* first = text.data();
  const char* last = first + text.size();
  if (first != last && (*first == 'G' || *first == 'g')) ++first;
  int number = -1;
  const auto [stop, error] = std::from_chars(first, last, number);
  if (error != std::errc{} || stop != last || number < lowest || number > highest) {
    return refuse(key, json);
  }
  value = number;
  return true;
}

bool ProfileReader::boolean(const std::string& key, const Json& json, bool& value) {
  if (!json.is_boolean()) return refuse(key, json);
  value = json.get<bool>();
  return true;
}

bool ProfileReader::word(const std::string& key, const Json& json, std::string_view no,
                         std::string_view yes, bool& value) {
  const std::string text = text_of(json);
  if (text != no && text != yes) return refuse(key, json);
  value = text == yes;
  return true;
}

}  // namespace gonogo::expanders
