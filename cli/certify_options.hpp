// SPDX-License-Identifier: GPL-3.0-or-later
//
// The words of a campaign against the corpus, for the commands that run one.
#pragma once

#include <string>
#include <vector>

#include "cli/options.hpp"

namespace gonogo::cli {

struct CertifyOptions {
  std::vector<std::string> subjects;
  std::vector<std::string> dialects;
  std::string corpus;
  std::string report;
  std::string certificate;
  std::string traces;
  std::string profile;
  std::vector<std::string> readings;
  std::vector<std::string> only;
  std::vector<std::string> cases;
  std::string failed_of;
  std::vector<std::string> cycles;
  std::vector<std::string> clauses;
  std::string shard = "1/1";
  long seed = -1;   // less than 0: is drawn
  long fresh = -1;  // programs of a dialect beside the corpus; less than 0: as many as were judged
  long jobs = 0;
  long causes = 3;
  std::string order = "gravity";  // of the findings
  bool fail_fast = false;
  bool resume = false;
  std::string known_failures;
  std::string write_known_failures;
  std::string alarm_map;
  LimitOptions limits;
  std::vector<std::string> argv;
};

// gonogo certify: the exit code. Throws UsageError, OutputError.
int certify(const CertifyOptions& asked);

}  // namespace gonogo::cli
