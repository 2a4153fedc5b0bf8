// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fresh programs of a certification: for which subjects, how many, and for how long.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "campaign/campaign.hpp"
#include "campaign/results_writer.hpp"
#include "cli/certify_options.hpp"

namespace gonogo::cli {

// A judged run of the corpus.
struct JudgedCorpus {
  const oracle::Corpus& corpus;
  const oracle::CampaignOptions& campaign;
  const oracle::SubjectMaker& maker;
  const std::string& subject;
  std::chrono::milliseconds took;
};

// Runs programs that are in no corpus on the subject and adds its departures to the results; where
// the corpus made the run NO-GO, none. Throws UsageError where the subject cannot run them.
oracle::FreshCounts ask_fresh_programs(const CertifyOptions& options, const JudgedCorpus& judged,
                                       const std::string& report, oracle::ResultsWriter& results);

// Runs as many fresh programs of the run again: the id of the one on which the subject departs,
// with which they end; nothing where it departs on none.
std::optional<std::string> fresh_departure(const JudgedCorpus& judged,
                                           const oracle::FreshCounts& counts,
                                           const std::string& scratch);

}  // namespace gonogo::cli
