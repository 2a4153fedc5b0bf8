// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is not GO judged again from what the results file holds of it: program, profile and trace.
#pragma once

#include <optional>
#include <string>

#include "oracle/evidence/case_row.hpp"
#include "oracle/judge/terms.hpp"
#include "oracle/subject.hpp"

namespace gonogo::oracle::evidence {

// What the header of a results file says of the terms of the run.
struct RunTerms {
  SubjectInfo subject;
  Grants grants;
};
// Throws ResultsError for a number that is none.
RunTerms run_terms(const Json& header);

struct Rejudged {
  // Whether the line holds what it takes: not a crash, a state leak, a trace that was cut, ...
  bool judged = false;
  std::string fault;  // in what the answer now differs from the line, a sentence; empty: in nothing
};
Rejudged rejudge(const Json& line, const RunTerms& terms);

}  // namespace gonogo::oracle::evidence
