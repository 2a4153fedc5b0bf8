// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "oracle/campaign/campaign.hpp"
#include "oracle/verdict.hpp"

namespace gonogo::cli {

// A verdict for people, some lines.
std::string verdict_text(const oracle::Verdict& verdict);
// A campaign for people: totals, the first failures, GO or NO-GO.
std::string summary_text(const oracle::CampaignSummary& summary, const std::string& subject);

}  // namespace gonogo::cli
