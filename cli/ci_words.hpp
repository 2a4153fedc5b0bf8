// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo ci: what a pipeline runs on a change, in the night, and in between.
#pragma once

#include <string>
#include <vector>

#include "cli/certify_options.hpp"
#include "cli/hunt_words.hpp"
#include "fuzz/hunt/campaign_state.hpp"

namespace gonogo::cli {

struct CiWords {
  HuntWords hunt;  // programs 0: the mode's own
  std::string report = "report";
  std::string out;
};

// The folders of a campaign's shards, sorted. Throws UsageError where there is none.
std::vector<std::string> shards_in(const std::string& campaign);

// What is kept of a shard. Throws UsageError where it is of another dialect.
hunt::CampaignState state_for(const std::string& shard, const std::string& dialect);
// The run against the corpus that the words ask for.
CertifyOptions certify_options(const CiWords& words);

// The exit codes.
int ci_prune(const CiWords& words);
int ci_coverage(const CiWords& words);

}  // namespace gonogo::cli
