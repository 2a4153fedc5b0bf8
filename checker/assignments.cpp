// SPDX-License-Identifier: GPL-3.0-or-later
#include "checker/assignments.hpp"

#include <algorithm>
#include <sstream>

namespace gonogo::checker {

Readings parse_assignment(const std::string& text) {
  Readings readings;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) readings[word.substr(0, equals)] = word.substr(equals + 1);
  }
  return readings;
}

bool admits(const Readings& assignment, const Readings& when) {
  return std::ranges::all_of(when, [&](const auto& choice) {
    const auto found = assignment.find(choice.first);
    return found == assignment.end() || found->second == choice.second;
  });
}

void Assignments::add(const std::vector<std::string>& explaining) {
  std::set<Readings> both;
  for (const std::string& text : explaining) {
    const Readings one = parse_assignment(text);
    for (const Readings& before : explaining_) {
      const bool contradict = std::ranges::any_of(one, [&](const auto& choice) {
        const auto found = before.find(choice.first);
        return found != before.end() && found->second != choice.second;
      });
      if (contradict) continue;
      Readings joined = before;
      joined.insert(one.begin(), one.end());
      both.insert(std::move(joined));
    }
  }
  too_many_ = too_many_ || both.size() > kMost;
  if (!too_many_) explaining_ = std::move(both);
}

std::string Assignments::against(const std::vector<std::string>& stated) const {
  if (too_many_) return "More than 4096 combinations of readings may explain the run.";
  std::set<Readings> told;
  for (const std::string& text : stated) told.insert(parse_assignment(text));
  // Where no reading is open the footer says nothing, or the one empty assignment.
  if (told.empty()) told.insert(Readings());
  if (told == explaining_) return {};
  return "The footer names " + std::to_string(stated.size()) +
         " combinations of readings that explain the run; the lines leave " +
         std::to_string(explaining_.size()) + ", and not the same.";
}

}  // namespace gonogo::checker
