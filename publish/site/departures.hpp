// SPDX-License-Identifier: GPL-3.0-or-later
//
// The departures of many runs, each once, with who has it. Memory depends on clauses, verdicts and
// runs, not on cases.
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "oracle/records/case_head.hpp"
#include "oracle/records/finding.hpp"
#include "publish/site/run.hpp"

namespace gonogo::oracle::site {

// The cases in which runs depart in one way: dialect, verdict, clause, and what it is about.
struct Departure {
  // For one run.
  struct Share {
    std::uint64_t cases = 0;
    std::uint64_t known = 0;  // of them
    std::string first;        // id
  };
  // A case to look at, and in which run.
  struct Example {
    std::string id;
    std::string message;
    std::size_t blocks = 0;  // of its program; 0: not kept
    std::size_t bytes = 0;
    std::size_t run = 0;
  };
  Finding::Key key;
  std::uint64_t cases = 0;  // in which any run has it
  std::map<std::size_t, Share> shares;
  std::set<std::string> cycles;
  Example smallest;

  std::string text() const;  // "fail.geometry at GSK-G94-02 (rapid)"
};

class Departures {
 public:
  // A case of one run that departs, or that is undecided without the corpus expecting it. Cases in
  // the order of their ids.
  void add(const CaseHead& line, VerdictKind kind, std::size_t run);
  // Those that most runs have first, then by gravity.
  std::vector<const Departure*> list() const;
  bool empty() const { return departures_.empty(); }

 private:
  std::map<Finding::Key, Departure> departures_;
  std::map<Finding::Key, std::string> last_;  // the case that was counted last
};

}  // namespace gonogo::oracle::site
