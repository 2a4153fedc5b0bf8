// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/reading_tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace gonogo::oracle {
namespace {

using Assignment = std::map<std::string, std::string>;

// The union of two combinations; nothing when they contradict each other.
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
      // A key that this combination never met stays open in it.
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

ReadingTally::Shown ReadingTally::shown_by(const std::vector<Assignment>& choices) {
  Shown shown;
  for (const auto& [key, value] : choices.front()) {
    std::set<std::string> values;
    for (const Assignment& choice : choices) {
      const auto found = choice.find(key);
      if (found != choice.end()) values.insert(found->second);
    }
    const bool is_needed = std::ranges::all_of(
        choices, [&](const Assignment& choice) { return choice.contains(key); });
    if (is_needed) shown[key] = std::move(values);
  }
  return shown;
}

// "gsk.duplicate: gsk.basic.000060 shows alarm, this case last", of the first such case.
ReadingConflict ReadingTally::conflict(const Shown& shown) const {
  ReadingConflict found;
  for (const auto& [key, own] : shown) {
    const auto before = shown_.find(key);
    if (before == shown_.end()) continue;
    for (const auto& [values, id] : before->second) {
      const bool agree =
          std::ranges::any_of(values, [&](const auto& value) { return own.contains(value); });
      if (agree || (!found.against.empty() && found.against <= id)) continue;
      found.against = id;
      found.message = fmt::format(
          "No single combination of readings explains this case and those before it. {}: {} shows "
          "{}, this case {}.",
          key, id, fmt::join(values, " or "), fmt::join(own, " or "));
    }
  }
  if (found.message.empty()) {
    found.message = "No single combination of readings explains this case and those before it.";
  }
  return found;
}

std::optional<ReadingConflict> ReadingTally::add(const std::string& id,
                                                 const OpenReadings& readings) {
  if (readings.explaining.empty() || taken_.contains(readings.explaining)) return std::nullopt;
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
  const Shown shown = shown_by(choices);
  if (next.empty()) return conflict(shown);
  for (const auto& [key, values] : shown) shown_[key].try_emplace(values, id);
  if (next.size() <= kMost) left_ = std::move(next);
  taken_.insert(readings.explaining);
  return std::nullopt;
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
