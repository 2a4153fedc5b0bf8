// SPDX-License-Identifier: GPL-3.0-or-later
//
// The combinations of open readings that explain a whole run.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "checker/corpus.hpp"

namespace gonogo::checker {

// "k=v k=v"
Readings parse_assignment(const std::string& text);
// Whether the assignment says nothing else than `when`. What it does not name was not asked for.
bool admits(const Readings& assignment, const Readings& when);

class Assignments {
 public:
  // A GO that each of these assignments explains, and no other of the readings in them.
  void add(const std::vector<std::string>& explaining);
  // A sentence where the run's are not those of the footer; else empty.
  std::string against(const std::vector<std::string>& stated) const;

 private:
  static constexpr std::size_t kMost = 4096;

  std::set<Readings> explaining_ = {Readings()};
  bool too_many_ = false;
};

}  // namespace gonogo::checker
