// SPDX-License-Identifier: GPL-3.0-or-later
//
// The likely causes of the gravest findings of a campaign, found with the subject itself.
#pragma once

#include <cstddef>

#include "campaign/campaign.hpp"
#include "cli/verdict_text.hpp"
#include "publish/evidence/causes.hpp"

namespace gonogo::cli {

// A bound on the trials for a finding: neither a run nor a hunt waits for its explanation.
inline constexpr std::size_t kMostRecordsToExplain = 1'000'000;

// Causes of at most `most` findings in their order, and of others that have one of these; a
// breakdown has none. A subject that cannot run any more has none either.
oracle::evidence::Causes find_causes(const CampaignSummary& summary, const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectMaker& make, std::size_t most);

}  // namespace gonogo::cli
