// SPDX-License-Identifier: GPL-3.0-or-later
//
// Programs that no subject can be prepared for, run after a corpus: those of a hunt whose seed was
// drawn when the run began. The first departure ends it.
#pragma once

#include "fuzz/hunt/finding_files.hpp"
#include "fuzz/hunt/hunt.hpp"
#include "campaign/results.hpp"
#include "oracle/records/fresh_counts.hpp"

namespace gonogo::hunt {

struct FreshOptions {
  TrialOptions trial;
  HuntOptions hunt;                                    // its dialect and seed among them
  std::size_t programs = 0;                            // at most
  std::chrono::milliseconds time{0};                   // no program is begun after it
  std::function<void(std::size_t programs)> progress;  // after each; null: none
};

struct FreshAnswers {
  oracle::FreshCount count;
  // The first departure, reduced, as a case and as its line in the results.
  std::optional<oracle::CaseResult> departure;
};

// Writes the departure, too, as a corpus below `folder` (finding_files.hpp). Throws what a hunt and
// the writing throw.
FreshAnswers ask_fresh(const SubjectMaker& maker, const FreshOptions& options,
                       const std::string& folder, Provenance provenance);

}  // namespace gonogo::hunt
