// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace gonogo::oracle::evidence {

// How many cases, and the first of them.
struct CountedIds {
  std::uint64_t count = 0;
  std::vector<std::string> first;

  // `most`: that are kept by name.
  void add(const std::string& id, std::size_t most) {
    ++count;
    if (first.size() < most) first.push_back(id);
  }
};

}  // namespace gonogo::oracle::evidence
