// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the gravest findings of a campaign are likely to come from, found with the subject itself.
#pragma once

#include <cstddef>

#include "cli/verdict_text.hpp"
#include "oracle/campaign/campaign.hpp"
#include "oracle/evidence/causes.hpp"

namespace gonogo::cli {

// Causes of at most `most` findings in their order; a breakdown has none. A subject that cannot be
// asked any more names none either.
oracle::evidence::Causes find_causes(const CampaignSummary& summary, const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectMaker& make, std::size_t most);

}  // namespace gonogo::cli
