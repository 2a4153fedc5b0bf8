// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gonogo::cover {
namespace {

std::vector<std::string_view> split(std::string_view text, char at) {
  std::vector<std::string_view> parts;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(at), text.size());
    if (end > 0) parts.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parts;
}

// The text before `at`, and the text behind it, which is empty where `at` does not occur.
std::pair<std::string_view, std::string_view> cut(std::string_view text, char at) {
  const std::size_t place = text.find(at);
  if (place == std::string_view::npos) return {text, {}};
  return {text.substr(0, place), text.substr(place + 1)};
}

Class class_of(std::string_view text) {
  Class made;
  const bool fault = text.starts_with('!');
  if (fault) text.remove_prefix(1);
  made.is_unsaid = fault && text.starts_with('?');
  if (made.is_unsaid) text.remove_prefix(1);
  const std::size_t alarm_place = text.rfind('@');
  if (fault != (alarm_place != std::string_view::npos)) {
    throw ModelError(fmt::format("A class is marked ! exactly where it names an alarm: {}", text));
  }
  if (fault) {
    for (const std::string_view alarm : split(text.substr(alarm_place + 1), '+')) {
      made.alarms.emplace_back(alarm);
    }
    text = text.substr(0, alarm_place);
  }
  const bool has_value = text.find('=') != std::string_view::npos;
  const auto [name, value] = cut(text, '=');
  made.name = name;
  made.value = has_value ? value : name;
  std::ranges::replace(made.value, '&', ' ');
  return made;
}

Rule rule_of(const Parameters& parameters, const std::vector<std::string_view>& words) {
  Rule rule;
  for (const std::string_view word : words) {
    const auto [name, classes] = cut(word, '=');
    Rule::Member member{parameters.find(name), {}};
    member.classes.resize(parameters.list[member.parameter].classes.size());
    for (const std::string_view one : split(classes, ',')) {
      member.classes[parameters.find_class(member.parameter, one)] = true;
    }
    rule.members.push_back(std::move(member));
  }
  return rule;
}

void check(const Parameters& parameters) {
  for (const Parameter& parameter : parameters.list) {
    if (parameter.classes.empty() || parameter.classes.size() >= kOpen) {
      throw ModelError(fmt::format("The parameter {} has no class, or too many.", parameter.name));
    }
    if (parameter.classes.front().is_fault()) {
      throw ModelError(fmt::format("The first class of {} must be a valid one.", parameter.name));
    }
  }
}

}  // namespace

std::size_t Parameters::find(std::string_view name) const {
  const auto found = std::ranges::find(list, name, &Parameter::name);
  if (found == list.end()) throw ModelError(fmt::format("There is no parameter {}.", name));
  return static_cast<std::size_t>(found - list.begin());
}

std::size_t Parameters::find_class(std::size_t parameter, std::string_view name) const {
  const std::vector<Class>& classes = list[parameter].classes;
  const auto found = std::ranges::find(classes, name, &Class::name);
  if (found == classes.end()) {
    throw ModelError(fmt::format("{} has no class {}.", list[parameter].name, name));
  }
  return static_cast<std::size_t>(found - classes.begin());
}

Parameters parse_parameters(std::string_view text) {
  Parameters parameters;
  for (const std::string_view line : split(text, '\n')) {
    std::vector<std::string_view> words = split(line, ' ');
    if (words.empty() || words.front().starts_with('#')) continue;
    if (!words.front().ends_with(':')) {
      throw ModelError(
          fmt::format("A line of parameters begins with a name and a colon: {}", line));
    }
    const std::string_view name = words.front().substr(0, words.front().size() - 1);
    words.erase(words.begin());
    if (name == "no") {
      parameters.rules.push_back(rule_of(parameters, words));
      continue;
    }
    Parameter parameter{std::string(name), {}};
    for (const std::string_view word : words) parameter.classes.push_back(class_of(word));
    parameters.list.push_back(std::move(parameter));
  }
  check(parameters);
  return parameters;
}

}  // namespace gonogo::cover
