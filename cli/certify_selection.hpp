// SPDX-License-Identifier: GPL-3.0-or-later
//
// What `gonogo certify` is asked to run: which cases, on which machine. All throw UsageError, with
// what to write instead, where no case or no machine is meant.
#pragma once

#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "cli/certify_options.hpp"
#include "corpus/io/corpus.hpp"

namespace gonogo::cli {

// The same options as a campaign takes them, with the files that they name read.
oracle::CampaignOptions campaign_options(const CertifyOptions& options);

// Every reading must exist, admit its value, and belong to a dialect that is judged.
void check_readings(const CertifyOptions& options);

void check_clauses(const CertifyOptions& options);

// Nobody is judged by a vector that is wrong: OutputError. The checked-in corpus is tested with the
// gauge itself.
void check_vectors(const CertifyOptions& options);

// A cycle that the corpus has not selects nothing, and says so before anything runs.
void check_cycles(const CertifyOptions& options, const oracle::Corpus& corpus);

// The same of cases, which are looked up only where fewer ran than were named.
void check_cases(const std::vector<std::string>& cases, const oracle::Corpus& corpus);

std::string none_selected(const oracle::Corpus& corpus);

// Whether a run of one built-in expander has a case; a cycle that it lacks is not asked of it.
bool take_own_cases(CertifyOptions& own, const oracle::Corpus& corpus);

// What was found in a run before (--failed-of) is run again in any case.
CertifyOptions with_failed_cases(CertifyOptions options);

}  // namespace gonogo::cli
