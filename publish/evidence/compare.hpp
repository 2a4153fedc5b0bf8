// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two runs or more compared, case by case by id. The last of them is the run now, the others came
// before it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "publish/evidence/case_row.hpp"
#include "publish/evidence/counted_ids.hpp"

namespace gonogo::oracle::evidence {

// What became of a case that is not the same in all runs that have it.
enum class Change {
  regression,  // a pass in one before and none now, or NO-GO now otherwise than it was known to
               // fail
  mended,      // NO-GO in one before, GO now
  departure,   // NO-GO in one before and now, but departs elsewhere
  verdict,     // any other change of the verdict: NO-GO before, skipped now, ...
};

struct ChangedCase {
  Change change = Change::verdict;
  std::string id;
  std::string dialect;
  std::string cycle;
  // Run by run the verdict and what it rests on, keys as in results.jsonl; null: not in that run.
  std::vector<Json> runs;
};

struct Comparison {
  std::vector<std::string> paths;
  std::vector<Json> headers;
  std::vector<std::string> notes;  // sentences: in what the runs differ besides their cases
  std::vector<ChangedCase> changed;
  CountedIds added;  // that only the run now has
  CountedIds gone;   // that it lacks
  std::uint64_t same = 0;

  std::uint64_t count(Change change) const;
};

// Reads all files once, side by side; memory grows with the differences only. Throws ResultsError
// for a file that is faulty; an incomplete one is named in the notes. REQUIRES: two files or more.
Comparison compare_runs(const std::vector<std::string>& paths);

enum class CompareFormat { text, json, markdown };
std::string comparison_text(const Comparison& comparison, CompareFormat format);

}  // namespace gonogo::oracle::evidence
