// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a certificate on any machine.
#pragma once

#include <string>
#include <vector>

namespace gonogo::oracle::evidence {

struct Check {
  enum class Result {
    holds,
    fails,      // something in the folder is not what it says
    unchecked,  // could not be checked here
    open,       // no file of any certificate shows it
  };
  Result result = Result::holds;
  std::string sentence;
  bool shown_by_subject = false;  // unchecked: a run of the subject that comes to the same shows it
};

// Checks the sums, the results' own hash and order, the header against its own command line, the
// statement against the results, totals, readings, stale entries and decision computed again, and
// the corpus against the one in `corpus` (empty: there is none here). With the corpus of the run it
// derives which cases there are, their profiles, features and expected gaps, and each verdict from
// its trace or its line; what could not be derived is reported as unchecked (J-RUN-13). `version`
// and `commit`: of this gonogo; an empty commit is any.
std::vector<Check> verify_certificate(const std::string& folder, const std::string& corpus,
                                      const std::string& version, const std::string& commit = {});

// Whether two results files have the same cases with the same lines except for times and attempts.
std::vector<Check> same_cases(const std::string& certified, const std::string& run_again);

}  // namespace gonogo::oracle::evidence
