// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/cover/minimise.hpp"

#include <algorithm>
#include <map>
#include <queue>

namespace gonogo::cover {
namespace {

// How many of the purposes nobody serves yet.
std::size_t use_of(const std::vector<std::size_t>& purposes, const std::vector<int>& served) {
  return static_cast<std::size_t>(
      std::ranges::count_if(purposes, [&](std::size_t purpose) { return served[purpose] == 0; }));
}

// Leaves out, from the last, the cases whose purposes others serve as well.
std::vector<std::size_t> without_superfluous(std::vector<std::size_t> kept,
                                             const std::vector<std::vector<std::size_t>>& numbered,
                                             std::vector<int>& served) {
  for (std::size_t i = kept.size(); i-- > 0;) {
    const std::vector<std::size_t>& own = numbered[kept[i]];
    if (!std::ranges::all_of(own, [&](std::size_t purpose) { return served[purpose] > 1; })) {
      continue;
    }
    for (const std::size_t purpose : own) --served[purpose];
    kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
  }
  return kept;
}

}  // namespace

std::vector<std::size_t> smallest_cover(const std::vector<std::set<std::string>>& purposes) {
  std::map<std::string, std::size_t> numbers;
  std::vector<std::vector<std::size_t>> numbered;
  for (const std::set<std::string>& own : purposes) {
    std::vector<std::size_t>& list = numbered.emplace_back();
    for (const std::string& purpose : own) {
      list.push_back(numbers.try_emplace(purpose, numbers.size()).first->second);
    }
  }
  std::vector<int> served(numbers.size());
  // A case only loses use while others are taken, so a stale entry is an upper bound.
  struct Entry {
    std::size_t use;
    std::size_t number;
    bool operator<(const Entry& other) const {
      return use != other.use ? use < other.use : number > other.number;
    }
  };
  std::priority_queue<Entry> queue;
  for (std::size_t i = 0; i < numbered.size(); ++i) queue.push({numbered[i].size(), i});
  std::vector<std::size_t> kept;
  while (!queue.empty()) {
    const Entry entry = queue.top();
    queue.pop();
    const std::size_t use = use_of(numbered[entry.number], served);
    if (use == 0) continue;
    if (use < entry.use) {
      queue.push({use, entry.number});
      continue;
    }
    for (const std::size_t purpose : numbered[entry.number]) ++served[purpose];
    kept.push_back(entry.number);
  }
  kept = without_superfluous(std::move(kept), numbered, served);
  std::ranges::sort(kept);
  return kept;
}

}  // namespace gonogo::cover
