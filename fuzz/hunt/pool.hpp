// SPDX-License-Identifier: GPL-3.0-or-later
//
// The programs of a hunt that showed something new of the reference.
#pragma once

#include <unordered_set>

#include "fuzz/hunt/coverage.hpp"
#include "fuzz/hunt/specimen.hpp"
#include "fuzz/program/mutator/dice.hpp"

namespace gonogo::hunt {

class Pool {
 public:
  // Takes the program in if it has a feature that none before had. Whether it has.
  bool offer(const Specimen& specimen, const Coverage& coverage);
  bool empty() const { return entries_.empty(); }
  std::size_t size() const { return entries_.size(); }
  std::size_t features() const { return seen_.size(); }
  // Those that it holds, oldest first.
  std::vector<generate::GeneratedProgram> programs() const;
  // One of the programs: rather one that showed much at little cost and has been picked seldom.
  // REQUIRES: !empty()
  const Specimen& pick(program::Dice& dice);

 private:
  struct Entry {
    Specimen specimen;
    std::size_t fresh = 0;   // features that it was the first to have
    std::size_t cost = 0;    // as of coverage_of()
    std::size_t picked = 0;  // times
  };
  std::vector<Entry> entries_;
  std::unordered_set<std::uint64_t> seen_;
};

}  // namespace gonogo::hunt
