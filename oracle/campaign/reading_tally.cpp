// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/campaign/reading_tally.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::oracle {
namespace {

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

bool ReadingTally::add(const SessionVerdict& session) {
  if (session.open.empty() || session.explaining.empty()) return true;
  std::vector<Assignment> next;
  for (const Assignment& before : left_) {
    for (const reference::ReadingChoice& choice : session.explaining) {
      Assignment here;
      for (reference::ReadingKey key : session.open) {
        // A key that this assignment never came to stays open in it.
        if (choice.get(key) != "any") here[key] = choice.get(key);
      }
      auto both = joined(before, here);
      if (both && std::ranges::find(next, *both) == next.end()) next.push_back(*std::move(both));
    }
  }
  if (next.empty()) return false;
  if (next.size() <= kMost) left_ = std::move(next);
  return true;
}

std::vector<std::string> ReadingTally::texts() const {
  std::vector<std::string> texts;
  for (const Assignment& assignment : left_) {
    std::string text;
    for (const auto& [key, value] : assignment) {
      text += fmt::format("{}{}={}", text.empty() ? "" : " ", reference::reading(key).name, value);
    }
    if (!text.empty()) texts.push_back(std::move(text));
  }
  std::ranges::sort(texts);
  return texts;
}

}  // namespace gonogo::oracle
