// SPDX-License-Identifier: GPL-3.0-or-later
//
// Readings that are lengths: any length may be followed, so the subject's own departure from the
// default says which one to try.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/identify/identifier.hpp"

namespace gonogo::identify {

using oracle::Decision;

namespace {

constexpr std::size_t kEnough = 3;

}  // namespace

// Whether the default or a length taken from a departure explains the run under any assignment.
bool Identifier::explain_length(Item& item, ReadingKey key) {
  const std::string_view name = reference::reading(key).name;
  const std::string fallback(base_.get(key));
  const auto any_passes = [&] { return !explaining(item, item.probe->by_reading).empty(); };
  ProbeRun& run = found_.runs[*item.run];
  if (any_passes()) {
    run.learnt.push_back(fmt::format("{} is {} mm", name, fallback));
    return true;
  }
  for (const Outcomes::Leaf& leaf : item.probe->by_reading.leaves) {
    const oracle::Verdict verdict = judge(item, leaf.readings);
    if (!admits(reference::reading(key), verdict.deviation_exact)) continue;
    base_.set(key, verdict.deviation_exact);
    if (any_passes()) {
      run.learnt.push_back(fmt::format("{} is {} mm, not {}", name, base_.get(key), fallback));
      return true;
    }
    base_.set(key, fallback);
  }
  return false;
}

void Identifier::find_lengths() {
  for (const ReadingKey key : kinds_.lengths) {
    unknown_lengths_.insert(key);
    std::vector<Item*> shows;
    for (Item& item : items_) {
      if (item.probe->lengths == std::set<ReadingKey>{key}) shows.push_back(&item);
    }
    std::ranges::sort(shows, {}, [](const Item* item) { return item->probe->program.size(); });
    std::size_t tried = 0;
    for (Item* item : shows) {
      unknown_lengths_.erase(key);
      const bool can = usable(*item);
      unknown_lengths_.insert(key);
      if (!can || tried++ == kEnough) continue;
      const bool explained = ask(*item) != nullptr && explain_length(*item, key);
      if (!explained) continue;
      known_lengths_.insert(key);
      unknown_lengths_.erase(key);
      strike(*item);
      break;
    }
  }
}

}  // namespace gonogo::identify
