// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings that are judged by properties unless a path is named. All that follows a named path has
// the properties too, so that "any" is never ruled out: what is found is the one named path that
// explains every run, if there is one.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/identifier.hpp"

namespace gonogo::identify {

using oracle::Decision;

namespace {

// Programs for one reading.
constexpr std::size_t kEnough = 2;
// Assignments of the other readings under which a path is tried.
constexpr std::size_t kMostPropertyRows = 64;

}  // namespace

// One that was run already; else the one that shows the most different paths.
Identifier::Item* Identifier::best_property_item(ReadingKey key,
                                                 const std::set<const Item*>& tried) {
  Item* best = nullptr;
  for (Item& item : items_) {
    const Outcomes& outcomes = item.probe->by_property;
    if (!outcomes.tells_apart(key) || tried.contains(&item)) continue;
    if (item.run && !found_.runs[*item.run].outcome.answered()) continue;
    if (!item.run && !usable(item)) continue;
    const auto rank = [](const Item& one) {
      return std::pair(one.run.has_value(), one.probe->by_property.different);
    };
    if (best == nullptr || rank(item) > rank(*best)) best = &item;
  }
  return best;
}

void Identifier::narrow_properties(Item& item) {
  const Outcomes& outcomes = item.probe->by_property;
  const auto rows = choices_.joined(item.probe->by_reading.keys, kMostPropertyRows);
  if (!rows || !properties_.joined(outcomes.keys, kMostPropertyRows)) return;
  std::vector<PartialAssignment> left;
  for (const Outcomes::Leaf& leaf : outcomes.leaves) {
    const bool explains = std::ranges::any_of(rows->rows, [&](const auto& row) {
      PartialAssignment readings = leaf.readings;
      for (std::size_t i = 0; i < row.size(); ++i) readings.emplace_back(rows->keys[i], row[i]);
      return decision(judge(item, readings).kind) != Decision::no_go;
    });
    if (explains) left.push_back(leaf.readings);
  }
  if (!properties_.keep(outcomes.keys, left, kMostPropertyRows)) return;
  seen_properties_.insert(outcomes.keys.begin(), outcomes.keys.end());
}

void Identifier::find_properties() {
  for (const ReadingKey key : kinds_.properties) {
    std::set<const Item*> tried;
    for (std::size_t i = 0; i < kEnough; ++i) {
      Item* item = best_property_item(key, tried);
      if (item == nullptr) break;
      tried.insert(item);
      ProbeRun* run = ask(*item);
      if (run == nullptr) continue;
      const auto before = properties_.values(key);
      narrow_properties(*item);
      if (properties_.values(key).size() < before.size()) {
        run->learnt.push_back(
            fmt::format("{} is narrowed by its path", reference::reading(key).name));
      }
    }
  }
}

// A named path that alone explains every run is followed.
void Identifier::fix_properties() {
  for (const ReadingKey key : kinds_.properties) {
    if (!seen_properties_.contains(key)) continue;
    const Reading& reading = reference::reading(key);
    std::vector<ReadingValue> values = properties_.values(key);
    std::erase(values, value_of_none(reading));
    if (values.size() == 1) base_.set(key, text_of(reading, values.front()));
  }
}

}  // namespace gonogo::identify
