// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which of many departures come from one mistake: those that the reference shows as the subject
// does with that one mistake, while it does what passes as it did before.
#pragma once

#include <cstddef>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "identify/explanation.hpp"

namespace gonogo::identify {

struct SharedCause {
  std::string name;                // of the mistake: what the subject does
  std::vector<std::size_t> faces;  // of those that were asked for; each is explained in full
  std::size_t passes = 0;          // programs that are GO and would be with it
};

struct SharedCauses {
  std::vector<SharedCause> causes;  // no face is of two
  std::size_t passes = 0;           // programs that the subject passes
  std::size_t tried = 0;            // mistakes
  bool given_up = false;            // a face reached most_records
};

// `faces` are programs on which the subject departs, each by itself; `others` programs of which
// those that pass must pass with a mistake, too. A face that no mistake explains is of no cause.
// The same faces in the same order have the same causes. Throws SubjectUnusable.
SharedCauses find_shared_causes(oracle::Subject& subject, std::span<const ProgramAsked> faces,
                                std::span<const ProgramAsked> others,
                                const ExplanationTerms& terms);

// Which of the mistakes that are known by their names explains a departure in full: the first that
// does. Empty: none, or the subject does not depart. Throws SubjectUnusable.
std::string known_cause(oracle::Subject& subject, const ProgramAsked& face,
                        const std::set<std::string>& names, const ExplanationTerms& terms);

}  // namespace gonogo::identify
