// SPDX-License-Identifier: GPL-3.0-or-later
//
// A verdict derived again from the trace of its case.
#pragma once

#include <string>

#include "campaign/known_failures.hpp"
#include "corpus/io/corpus.hpp"
#include "publish/evidence/rejudge.hpp"

namespace gonogo::oracle::evidence {

// What the line says of the trace alone: an xfail what is known, and what the readings of the run
// change what it was before.
VerdictKind told_kind(const Json& line, const CaseRow& row);

// In what the line differs from the trace in that file, a sentence; empty: in nothing. `test`: as
// the corpus and the header have it; `alarms`: the entries of the run's alarm map. Throws
// ResultsError for a trace that is none.
std::string trace_fault(const Json& line, const CaseRow& row, const std::string& path,
                        const Case& test, const Tolerances& tolerances, const AlarmMap& alarms,
                        const Wording& wording);

}  // namespace gonogo::oracle::evidence
