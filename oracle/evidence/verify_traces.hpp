// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of verify that judges every case with a trace again, passes included, without the
// subject.
#pragma once

#include <string>

#include "oracle/evidence/verify_sums.hpp"

namespace gonogo::oracle::evidence {

// `results`, and the folder with `<id>.jsonl` of its cases; the programs are those of `corpus`.
// Throws ResultsError and CorpusError.
void check_traces(const std::string& results, const std::string& traces, const std::string& corpus,
                  Findings& findings);

}  // namespace gonogo::oracle::evidence
