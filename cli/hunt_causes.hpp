// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the findings of a campaign come from, asked of the subject itself; and what its folder then
// reports: campaign.json and index.html.
#pragma once

#include <memory>
#include <set>
#include <string>

#include "cli/trial_options.hpp"
#include "fuzz/hunt/hunt_summary.hpp"

namespace gonogo::cli {

// The findings of all shards by their causes, with both files written anew. The subject is only
// asked where there are symptoms that it was not asked for yet; one that cannot be asked has
// findings without causes. Throws std::runtime_error where a shard cannot be read,
// std::system_error.
hunt::HuntSummary tell_campaign(const std::string& folder, const TrialWords& words);

// The findings of a hunt without a folder, by their causes, the gravest first. `pool`: programs on
// which a cause is tried as well.
hunt::HuntSummary tell_findings(const std::vector<hunt::Finding>& findings, const hunt::Pool& pool,
                                const TrialWords& words);

// The mistakes that findings of a campaign that stand come from, held against a subject's later
// departures.
class KnownMistakes {
 public:
  // Throws std::runtime_error where a shard cannot be read.
  KnownMistakes(const std::string& folder, TrialWords words);
  // That which explains the finding in full; empty: none, and it is news.
  std::string cause_of(const hunt::Finding& finding);

 private:
  TrialWords words_;
  std::set<std::string> names_;
  std::unique_ptr<oracle::Subject> subject_;  // made when it is first asked
};

}  // namespace gonogo::cli
