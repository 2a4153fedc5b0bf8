// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of the results of `gonogo certify`: who judged whom, with what, under which grants.
#pragma once

#include <string>

#include "campaign/campaign.hpp"
#include "campaign/results_writer.hpp"
#include "cli/certify_options.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::cli {

oracle::ResultsHeader results_header(const CertifyOptions& options, const std::string& subject,
                                     const oracle::Corpus& corpus,
                                     const oracle::CampaignOptions& campaign,
                                     const oracle::SubjectInfo& info);

}  // namespace gonogo::cli
