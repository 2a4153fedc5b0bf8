// SPDX-License-Identifier: GPL-3.0-or-later
//
// `gonogo certify` of one subject, from its first start to report and certificate.
#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "campaign/results.hpp"
#include "cli/certify_options.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::cli {

// Its exit code. `report` is the folder that gets the results. Throws UsageError, OutputError.
int certify_one(CertifyOptions options, const std::string& subject, const std::string& report);

// The header of its results: who judged whom, with what, under which grants.
oracle::ResultsHeader results_header(const CertifyOptions& options, const std::string& subject,
                                     const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectInfo& info);

}  // namespace gonogo::cli
