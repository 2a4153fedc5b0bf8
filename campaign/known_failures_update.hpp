// SPDX-License-Identifier: GPL-3.0-or-later
//
// The file of known failures after a run: entries that are no longer true are pruned, new failures
// are added, a cause for each finding.
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "campaign/known_failures.hpp"
#include "campaign/tally.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::oracle {

class KnownFailuresUpdate {
 public:
  explicit KnownFailuresUpdate(std::vector<KnownCause> before);

  // A case line of the run, with its verdict there. `finding`: the finding to which it belongs;
  // null: none.
  void add(const CaseFacts& facts, VerdictKind kind, const Finding* finding);

  struct Result {
    std::vector<KnownCause> causes;
    std::size_t added = 0;     // cases
    std::size_t pruned = 0;    // cases that an entry named and that do not fail so any more
    std::size_t unsteady = 0;  // NO-GO as state-leak: no entry says how they fail
  };
  // `corpus`: the ids of all its cases. What was not run or not judged keeps its entries.
  // `smallest`: the program of a finding, by its number; without one the cause names none.
  Result result(const std::vector<std::string>& corpus,
                const std::map<std::size_t, std::string>& smallest) const;

 private:
  using Place = std::pair<std::size_t, std::size_t>;  // of a failure: its cause, its number there
  struct New {
    std::string reason;
    std::size_t finding = 0;
    std::map<std::pair<VerdictKind, std::string>, std::vector<std::string>> cases;  // by deviation
  };

  std::vector<std::string> kept(const Place& place, const std::vector<std::string>& corpus,
                                std::size_t& pruned) const;

  std::vector<KnownCause> before_;
  std::vector<std::pair<Place, KnownFailure>> entries_;  // of it, in its order
  std::map<std::string, Place> explained_;               // xfail: the failure that names the case
  std::set<std::string> judged_;
  std::map<Finding::Key, New> new_;
  std::size_t unsteady_ = 0;
};

// Globs that cover exactly these ids: those that differ in their last digit only are one.
std::vector<std::string> globs_of_ids(std::vector<std::string> ids);

}  // namespace gonogo::oracle
