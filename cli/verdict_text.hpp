// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "campaign/results.hpp"
#include "cli/exit_code.hpp"
#include "oracle/records/finding.hpp"
#include "oracle/records/verdict.hpp"
#include "oracle/relation/definition.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::cli {

// "NO-GO: fail.geometry" as a line.
std::string verdict_head(const oracle::Verdict& verdict);
// The same with the details below it; `facts` are those of the verdict and of its program.
std::string verdict_text(const oracle::Verdict& verdict, oracle::FindingFacts facts);
// The same of what the definition says.
std::string answer_text(const relation::Answer& answer);
// What the program ends with where it judged one program.
ExitCode exit_code_of(const oracle::Verdict& verdict);

// What the terminal shows of a campaign.
struct CampaignSummary {
  oracle::ResultsFooter footer;
  oracle::Findings findings;
  std::map<std::size_t, oracle::evidence::CaseRow> smallest;  // case of a finding, by its number
  std::size_t causes_asked = 0;       // findings of which a cause was looked for
  std::string_view no_cause_because;  // why it was looked for in none; empty: it was, or not asked
  std::size_t run_again = 0;          // cases that took more than two runs
  std::size_t further_runs = 0;       // that they took beside two
  oracle::Findings::Order order = oracle::Findings::Order::gravity;
  bool complete = true;  // not stopped at the first NO-GO
};
// What was found, each kind once, totals, GO or NO-GO.
std::string summary_text(const CampaignSummary& summary, const std::string& subject, bool colour);

}  // namespace gonogo::cli
