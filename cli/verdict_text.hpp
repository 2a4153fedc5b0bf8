// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/exit_code.hpp"
#include "oracle/campaign/results.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::cli {

// A verdict for people, some lines.
std::string verdict_text(const oracle::Verdict& verdict);
// What the program ends with where it judged one program.
ExitCode exit_code_of(const oracle::Verdict& verdict);

// What the terminal shows of a campaign.
struct CampaignSummary {
  oracle::RunAnswer answer;
  oracle::ResultsFooter footer;
  std::vector<oracle::CaseResult> failures;  // the first of them, one more than are shown
  bool complete = true;                      // not stopped at the first NO-GO
};
inline constexpr std::size_t kShownFailures = 10;
// Totals, the first failures, GO or NO-GO.
std::string summary_text(const CampaignSummary& summary, const std::string& subject);

}  // namespace gonogo::cli
