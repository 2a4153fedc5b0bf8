// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks a certificate on whatever machine it has come to.
#pragma once

#include <string>
#include <vector>

namespace gonogo::oracle::evidence {

struct Check {
  enum class Result {
    holds,
    fails,      // something in the folder is not what it says
    unchecked,  // could not be checked here
  };
  Result result = Result::holds;
  std::string sentence;
};

// Checks the sums, the results' own hash and order, the statement against the results, totals,
// readings and decision worked out again, the reasons of the waivers, the corpus against the one in
// `corpus` (empty: there is none here), and every NO-GO with a trace by judging it again; with
// traces in the certificate, and the corpus of the run here, every case that has one, passes too.
// `version` and `commit`: of this gonogo; an empty commit is any.
std::vector<Check> verify_certificate(const std::string& folder, const std::string& corpus,
                                      const std::string& version, const std::string& commit = {});

// Whether two results files have the same cases with the same lines but for times and attempts.
std::vector<Check> same_cases(const std::string& certified, const std::string& run_again);

}  // namespace gonogo::oracle::evidence
