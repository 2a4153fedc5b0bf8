// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/pool.hpp"

#include <algorithm>

namespace gonogo::hunt {

bool Pool::offer(const Specimen& specimen, const Coverage& coverage) {
  constexpr std::size_t kMostEntries = 4096;
  const auto fresh = static_cast<std::size_t>(std::ranges::count_if(
      coverage.features, [&](std::uint64_t feature) { return seen_.insert(feature).second; }));
  if (fresh == 0) return false;
  if (entries_.size() == kMostEntries)
    entries_.erase(entries_.begin(), entries_.begin() + kMostEntries / 4);
  entries_.push_back({specimen, fresh, coverage.cost, 0});
  return true;
}

std::vector<generate::GeneratedProgram> Pool::programs() const {
  std::vector<generate::GeneratedProgram> programs;
  for (const Entry& entry : entries_) programs.push_back(entry.specimen.program);
  return programs;
}

const Specimen& Pool::pick(program::Dice& dice) {
  // The best of three at random.
  constexpr int kTries = 3;
  constexpr std::size_t kMostFresh = 32;
  constexpr std::size_t kCheap = 100;
  auto worth = [&](const Entry& entry) {
    return std::min(entry.fresh, kMostFresh) * 64 / (1 + entry.picked) / (1 + entry.cost / kCheap);
  };
  Entry* best = &dice.pick(entries_);
  for (int i = 1; i < kTries; ++i) {
    Entry& other = dice.pick(entries_);
    if (worth(other) > worth(*best)) best = &other;
  }
  ++best->picked;
  return best->specimen;
}

}  // namespace gonogo::hunt
