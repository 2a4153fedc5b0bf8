// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/followed_readings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <set>
#include <sstream>

#include "reference/reading.hpp"

namespace gonogo::oracle {
namespace {

// The values of each reading, over all assignments.
std::map<std::string, std::set<std::string>> values_in(std::span<const std::string> assignments) {
  std::map<std::string, std::set<std::string>> values;
  for (const std::string& assignment : assignments) {
    std::istringstream words(assignment);
    for (std::string word; words >> word;) {
      const std::size_t equals = word.find('=');
      if (equals == std::string::npos) continue;
      values[word.substr(0, equals)].insert(word.substr(equals + 1));
    }
  }
  return values;
}

bool is_default(const std::string& key, const std::string& value) {
  const reference::Reading* reading = reference::find_reading(key);
  return reading != nullptr && reference::ReadingChoice().shown().get(reading->key) == value;
}

}  // namespace

std::string followed_readings(std::span<const std::string> assignments) {
  std::size_t defaults = 0;
  std::vector<std::string> others;
  std::vector<std::string> several;
  for (const auto& [key, values] : values_in(assignments)) {
    if (values.size() > 1) {
      several.push_back(fmt::format("{}={}", key, fmt::join(values, " or ")));
    } else if (is_default(key, *values.begin())) {
      ++defaults;
    } else {
      others.push_back(fmt::format("{}={}", key, *values.begin()));
    }
  }
  std::string text;
  const auto add = [&](std::string_view before, const std::vector<std::string>& list) {
    if (!list.empty()) text += fmt::format("{}{}", before, fmt::join(list, ", "));
  };
  if (defaults > 0)
    text = fmt::format("the defaults of {} reading{}", defaults, defaults == 1 ? "" : "s");
  add(text.empty() ? "" : ", except ", others);
  add(text.empty() ? "cannot be told apart: " : "; cannot be told apart: ", several);
  return text;
}

}  // namespace gonogo::oracle
