// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cases that are not GO, judged again from the data in the results file: program, profile and
// trace.
#pragma once

#include <optional>
#include <string>

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

struct Rejudged {
  // Whether the line holds what it takes: not a crash, a state leak, a trace that was cut, ...
  bool judged = false;
  std::string fault;  // in what the answer now differs from the line, a sentence; empty: in nothing
};
Rejudged rejudge(const Json& line, const RunTolerances& tolerances);

}  // namespace gonogo::oracle::evidence
