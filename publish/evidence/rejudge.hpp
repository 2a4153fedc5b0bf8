// SPDX-License-Identifier: GPL-3.0-or-later
//
// Cases judged again: those that are not GO from the data in the results file, which are program,
// profile and trace; any from the file of its trace.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "campaign/known_failures.hpp"
#include "corpus/io/corpus.hpp"
#include "oracle/motion/tolerances.hpp"
#include "oracle/records/subject_outcome.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// What the header of a results file says of the tolerances of the run.
struct RunTolerances {
  SubjectInfo subject;
  Grants grants;
};
// Throws ResultsError for a number that is none.
RunTolerances run_tolerances(const Json& header);

// As many records as a campaign keeps; a trace of that length may have been cut.
inline constexpr std::size_t kKeptRecords = 20'000;

// How the line of a run may say what is derived again.
struct Wording {
  bool has_rules = true;    // format 2
  bool is_own = true;       // it was written by this gonogo, whose messages are the same
  bool holds_words = true;  // false: the places, records and amounts alone are held
  std::vector<std::string> additions = {};  // behind a message, from other runs of the case
};
// In what the line differs from the departure or gap that is derived again, a sentence; empty: in
// nothing. Of an xfail `now` is what is known. `reading` is not looked at.
std::string line_difference(const Json& line, const CaseRow& row, const Verdict& now,
                            const Wording& wording);

struct Rejudged {
  // Whether the line holds all that is needed: not a crash, a state leak, a trace that was cut, ...
  bool judged = false;
  std::string fault;  // in what the answer now differs from the line, a sentence; empty: in nothing
};
Rejudged rejudge(const Json& line, const RunTolerances& tolerances, const Wording& wording = {});

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
