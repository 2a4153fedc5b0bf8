// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of many departures have one cause: the reference with that mistake does the same as the
// subject on all of them, and what passes still passes.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "fuzz/identify/likely_cause.hpp"

namespace gonogo::identify {

struct SharedCause : LikelyCause {
  std::vector<std::size_t> symptoms;  // its own, of those that were asked for
};

struct SharedCauses {
  std::vector<SharedCause> causes;  // no symptom is of two
  std::size_t passes = 0;           // programs that the subject passes
  std::size_t tried = 0;            // mistakes
  bool given_up = false;            // a symptom reached most_records
};

// `symptoms` are programs on which the subject departs, each by itself; `others` programs of which
// those that pass must pass with a mistake, too, and the others tell mistakes apart that explain
// as many symptoms. A symptom that no mistake explains is of no cause.
// The same symptoms in the same order have the same causes. Throws SubjectUnusable.
SharedCauses find_shared_causes(oracle::Subject& subject, std::span<const ProgramAsked> symptoms,
                                std::span<const ProgramAsked> others,
                                const ExplanationOptions& options);

// Which of the given mistakes, by name, explains a departure in full: the first that
// does. Empty: none, or the subject does not depart. Throws SubjectUnusable.
std::string known_cause(oracle::Subject& subject, const ProgramAsked& symptom,
                        const std::set<std::string>& names, const ExplanationOptions& options);

}  // namespace gonogo::identify
