// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one reading of the results gives the checks of verify.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "campaign/results.hpp"
#include "campaign/tally.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// What one reading of the results gives the checks.
struct ResultsFacts {
  Json header;
  Json footer;
  RunAnswer answer;
  std::set<std::string> mapped;           // entries of the alarm map that a case met
  std::vector<std::string> inconsistent;  // lines whose verdict is not what the tally makes of it
  // Cases of the corpus, by dialect, before the readings of the run are reconciled, as they were
  // when fresh programs were asked; whether one of them is NO-GO, or known to fail.
  std::map<std::string, std::size_t> judged;
  bool is_no_go = false;
  bool is_known = false;
};

// The texts of a list, of an object that may not have it.
std::vector<std::string> texts_in(const Json& object, const char* key);
// Throws ResultsError.
ResultsFacts read_results(const std::string& path);

}  // namespace gonogo::oracle::evidence
