// SPDX-License-Identifier: GPL-3.0-or-later
//
// Many results files read in parallel, once, case by case by id.
#pragma once

#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "publish/evidence/counted_ids.hpp"
#include "publish/site/departures.hpp"
#include "publish/site/run.hpp"
#include "publish/site/vote.hpp"

namespace gonogo::oracle::site {

// Why these results make no site, a sentence with what to do instead.
class SiteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A results file as it was named by the caller.
struct Source {
  std::string path;
  std::string name;     // of the implementation; empty: as the subject names itself
  std::string version;  // likewise
};

struct GatherOptions {
  bool partial = false;       // take files without a footer
  bool mixed_corpus = false;  // take results of several corpora: cases of one id are compared
};

// From one version of an implementation to the next.
struct Step {
  std::size_t before = 0;  // runs
  std::size_t after = 0;
  std::uint64_t compared = 0;   // cases that both answered
  evidence::CountedIds lost;    // GO before, not GO now
  evidence::CountedIds mended;  // departs before, GO now
  evidence::CountedIds moved;   // departs in both, in another way
};

struct Gathered {
  std::vector<Run> runs;  // by name, then by version, as people count
  std::vector<std::string> notes;
  Departures departures;
  Votes votes;
  std::vector<Step> steps;
  std::uint64_t cases = 0;          // that any run has
  std::vector<std::size_t> voters;  // the last version of each implementation

  // The runs of each implementation, in their order.
  std::vector<std::vector<std::size_t>> implementations() const;
  // That any run has.
  std::set<CycleKey> cycles() const;
};

// Throws SiteError where the results do not go together, ResultsError for a file that is faulty.
// What comes out does not depend on the order of the sources.
Gathered gather(const std::vector<Source>& sources, const GatherOptions& options);

}  // namespace gonogo::oracle::site
