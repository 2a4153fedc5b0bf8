// SPDX-License-Identifier: GPL-3.0-or-later
//
// The fresh programs of a certification: who is asked any, how many, and for how long.
#pragma once

#include <chrono>
#include <string>

#include "cli/certify_options.hpp"
#include "oracle/campaign/campaign.hpp"
#include "oracle/campaign/results_writer.hpp"

namespace gonogo::cli {

// A judged run of the corpus.
struct JudgedCorpus {
  const oracle::Corpus& corpus;
  const oracle::CampaignOptions& campaign;
  const oracle::SubjectMaker& maker;
  const std::string& subject;
  std::chrono::milliseconds took;
};

// Asks the subject programs that are in no corpus and adds what it departs on to the results; where
// the corpus made the run NO-GO, none. Throws UsageError where the subject cannot be asked.
oracle::FreshCounts ask_fresh_programs(const CertifyOptions& options, const JudgedCorpus& judged,
                                       const std::string& report, oracle::ResultsWriter& results);

}  // namespace gonogo::cli
