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

// In what the verdict of the trace in that file differs from the line, a sentence; empty: in
// nothing. `test`: as the corpus and the header have it. Throws ResultsError for a trace that is
// none.
std::string trace_fault(const Json& line, const CaseRow& row, const std::string& path,
                        const Case& test, const Tolerances& tolerances, const Wording& wording);
// Whether the line names the entry of the alarm map that the alarm of the trace met, likewise.
std::string mapped_fault(const Json& line, const CaseRow& row, const std::string& path,
                         const AlarmMap& map);

}  // namespace gonogo::oracle::evidence
