// SPDX-License-Identifier: GPL-3.0-or-later
//
// Two runs compared, case by case by id.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "campaign/results_reader.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// What became of a case that is not the same in both runs.
enum class Change {
  regression,  // a pass before and none now, or a known failure that is NO-GO otherwise now
  mended,      // NO-GO before, GO now
  departure,   // NO-GO in both, but departs elsewhere
  verdict,     // any other change of the verdict: NO-GO before, skipped now, ...
};

struct ChangedCase {
  Change change = Change::verdict;
  std::string id;
  std::string dialect;
  std::string cycle;
  Json before;  // verdict and what it rests on, keys as in results.jsonl
  Json after;
};

// What a comparison of two runs or of many says besides the cases that changed.
struct ComparedCases {
  std::vector<std::string> notes;  // sentences: in what the runs differ besides their cases
  // Cases that only the current run has, and those that it lacks: how many, and the first of them.
  std::uint64_t added = 0;
  std::vector<std::string> first_added;
  std::uint64_t gone = 0;
  std::vector<std::string> first_gone;
  std::uint64_t same = 0;
};

struct Comparison : ComparedCases {
  Json old_header;
  Json new_header;
  std::vector<ChangedCase> changed;

  std::uint64_t count(Change change) const;
};

// Reads both files once, side by side; memory grows with the differences only. Throws ResultsError
// for a file that is faulty; an incomplete one is named in the notes.
Comparison compare_results(const std::string& before, const std::string& after);

enum class CompareFormat { text, json, markdown };
std::string comparison_text(const Comparison& comparison, CompareFormat format);

}  // namespace gonogo::oracle::evidence
