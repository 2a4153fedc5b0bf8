// SPDX-License-Identifier: GPL-3.0-or-later
//
// Any number of runs compared, case by case by id. The last of them is the current run, the others
// came before it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "publish/evidence/compare.hpp"

namespace gonogo::oracle::evidence {

// A case that is not the same in all runs that have it. In the run now it is a
//   regression  where it is NO-GO and was GO in one before,
//   mended      where it is GO and was NO-GO in one before,
//   departure   where it is NO-GO, was NO-GO in one before, and departed elsewhere there,
//   verdict     otherwise.
struct CaseOfRuns {
  Change change = Change::verdict;
  std::string id;
  std::string dialect;
  std::string cycle;
  std::vector<Json> runs;  // what compare_results has as before and after; null: not in that run
};

struct RunsComparison : ComparedCases {
  std::vector<std::string> paths;
  std::vector<Json> headers;
  std::vector<CaseOfRuns> changed;

  std::uint64_t count(Change change) const;
};

// Reads all files once, side by side; memory grows with the differences only. Throws ResultsError
// for a file that is faulty; an incomplete one is named in the notes. REQUIRES: two files or more.
RunsComparison compare_runs(const std::vector<std::string>& paths);

std::string runs_comparison_text(const RunsComparison& comparison, CompareFormat format);

}  // namespace gonogo::oracle::evidence
