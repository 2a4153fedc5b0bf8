// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results and corpora named on the command line.
#pragma once

#include <string>

namespace gonogo::cli {

// The results file itself; a folder stands for the results in it, or for the journal of a run that
// has not ended. Throws UsageError where there is none.
std::string results_in(const std::string& path);

// The folder given, or where the checked-in corpus lies: GONOGO_CORPUS, in the program itself
// (oracle::kEmbeddedFolder), beside the checkout that it was built in, or where it was installed.
// Throws UsageError when there is none.
std::string corpus_folder(const std::string& given);
// The same; empty when none is named and none is there.
std::string corpus_here(const std::string& given);

}  // namespace gonogo::cli
