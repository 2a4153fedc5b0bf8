// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/steps/assignment_set.hpp"

#include <algorithm>
#include <map>

namespace gonogo::oracle {

using reference::Reading;
using reference::ReadingChoice;
using reference::ReadingKey;

namespace {

const std::vector<ReadingKey>& openable_in(std::string_view dialect) {
  static const auto kByDialect = [] {
    std::map<std::string_view, std::vector<ReadingKey>> keys;
    for (const Reading& reading : reference::readings()) {
      if (reading.by_properties) continue;
      for (const std::string_view its : {reading.dialect, reading.also}) {
        keys[its].push_back(reading.key);
      }
    }
    return keys;
  }();
  static const std::vector<ReadingKey> kNone;
  const auto found = kByDialect.find(dialect);
  return found == kByDialect.end() ? kNone : found->second;
}

}  // namespace

AssignmentSet::AssignmentSet(const reference::Profile& profile)
    : choice_(profile.readings), openable_(&openable_in(profile.dialect)) {}

const AssignmentSet::Left* AssignmentSet::find(ReadingKey key) const {
  const auto found = std::ranges::find(left_, key, &Left::key);
  return found == left_.end() ? nullptr : &*found;
}

std::vector<std::string_view>& AssignmentSet::left_of(ReadingKey key) {
  const auto found = std::ranges::find(left_, key, &Left::key);
  if (found != left_.end()) return found->values;
  const reference::Alternatives& all = reference::reading(key).alternatives;
  return left_.emplace_back(Left{key, {all.begin(), all.end()}}).values;
}

std::span<const std::string_view> AssignmentSet::values(ReadingKey key) const {
  const Reading& reading = reference::reading(key);
  if (reading.by_properties || !choice_.is(key, "any")) return {};
  const Left* left = find(key);
  if (left != nullptr) return left->values;
  return reading.alternatives;
}

bool AssignmentSet::leaves_open() const {
  return std::ranges::any_of(*openable_, [&](ReadingKey key) { return choice_.is(key, "any"); });
}

ReadingChoice AssignmentSet::taken() const {
  ReadingChoice choice = choice_;
  for (const Left& left : left_) choice.set(left.key, left.values.front());
  return choice;
}

AssignmentSet AssignmentSet::with(ReadingKey key, std::string_view value) const {
  AssignmentSet set = *this;
  set.left_of(key) = {value};
  return set;
}

void AssignmentSet::leave_out(ReadingKey key, std::string_view value) {
  std::erase(left_of(key), value);
}

std::vector<ReadingChoice> AssignmentSet::choices() const {
  std::vector<ReadingChoice> choices = {choice_};
  for (const Left& left : left_) {
    std::vector<ReadingChoice> more;
    for (ReadingChoice& choice : choices) {
      for (const std::string_view value : left.values) {
        choice.set(left.key, value);
        more.push_back(choice);
      }
    }
    choices = std::move(more);
  }
  return choices;
}

std::vector<ReadingKey> AssignmentSet::settled() const {
  std::vector<ReadingKey> keys;
  for (const Left& left : left_) keys.push_back(left.key);
  return keys;
}

}  // namespace gonogo::oracle
