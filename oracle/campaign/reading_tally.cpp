// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/reading_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gonogo::oracle {
namespace {

using Assignment = std::map<std::string, std::string>;

// The union of two assignments, or nothing when they contradict each other.
std::optional<Assignment> joined(const Assignment& a, const Assignment& b) {
  Assignment both = a;
  for (const auto& [key, value] : b) {
    auto [place, added] = both.emplace(key, value);
    if (!added && place->second != value) return std::nullopt;
  }
  return both;
}

}  // namespace

std::optional<OpenReadings> open_readings(const SessionVerdict& session) {
  if (session.open.empty() || session.explaining.empty()) return std::nullopt;
  OpenReadings readings;
  readings.verdict = session.verdict.kind;
  for (const reference::ReadingKey key : session.open) {
    readings.open.emplace_back(reference::reading(key).name);
  }
  for (const reference::ReadingChoice& choice : session.explaining) {
    std::string text;
    for (const reference::ReadingKey key : session.open) {
      // A key that this assignment never came to stays open in it.
      if (choice.is(key, "any")) continue;
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", reference::reading(key).name,
                          choice.get(key));
    }
    readings.explaining.push_back(std::move(text));
  }
  return readings;
}

ReadingTally::Assignment ReadingTally::parsed(const std::string& text) {
  Assignment assignment;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    assignment[word.substr(0, equals)] =
        equals == std::string::npos ? std::string() : word.substr(equals + 1);
  }
  return assignment;
}

bool ReadingTally::add(const OpenReadings& readings) {
  if (readings.explaining.empty() || taken_.contains(readings.explaining)) return true;
  std::vector<Assignment> choices;
  for (const std::string& text : readings.explaining) choices.push_back(parsed(text));
  std::vector<Assignment> next;
  std::set<Assignment> known;
  for (const Assignment& before : left_) {
    for (const Assignment& choice : choices) {
      auto both = joined(before, choice);
      if (both && known.insert(*both).second) next.push_back(*std::move(both));
    }
  }
  if (next.empty()) return false;
  if (next.size() <= kMost) left_ = std::move(next);
  taken_.insert(readings.explaining);
  return true;
}

std::vector<std::string> ReadingTally::texts() const {
  std::vector<std::string> texts;
  for (const Assignment& assignment : left_) {
    std::string text;
    for (const auto& [key, value] : assignment) {
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", key, value);
    }
    if (!text.empty()) texts.push_back(std::move(text));
  }
  std::ranges::sort(texts);
  return texts;
}

}  // namespace gonogo::oracle
