// SPDX-License-Identifier: GPL-3.0-or-later
//
// The likely causes of a departure: the mistakes with which the reference does all that the subject
// does, over some programs like the one that departs.
#pragma once

#include <string>
#include <vector>

#include "corpus/io/corpus.hpp"
#include "fuzz/identify/likely_cause.hpp"

namespace gonogo::identify {

struct Cause {
  std::string name;
  std::size_t departures = 0;  // that it explains in full
  std::size_t cut_short = 0;   // that it explains up to where it makes the reference refuse
  std::size_t passes = 0;      // programs that are GO and would be with it
  std::string opposite = {};   // as of the variant
  bool is_misread = false;     // as of the variant
  std::size_t place = 0;       // among the mistakes that were tried, the simplest first
  std::vector<std::string> explained = {};  // the departures, by their ids
  bool is_by_path = true;                   // held against what the subject does, not a verdict
};

struct Attribution {
  std::vector<Observation> programs;  // the one that was asked for first
  std::size_t departures = 0;
  std::size_t tried = 0;        // mistakes
  bool given_up = false;        // at most_records; nothing is complete or partial then
  std::vector<Cause> complete;  // explain every departure, and that the others pass
  std::vector<Cause>
      partial;  // explain some of it; those that explain most first, then the simplest

  std::size_t passes() const { return programs.size() - departures; }
};

// Runs the program on the subject, and similar programs of the corpus. Throws
// SubjectUnusable, CorpusError.
Attribution attribute(oracle::Subject& subject, const oracle::Corpus& corpus,
                      const ProgramAsked& asked, const ExplanationOptions& options);

// The simplest of those that explain most. Empty: no mistake explains more than half of what
// departs, three quarters of it and two programs where a word or a code is misread, and all that
// passes; or too many do for what was seen.
LikelyCause likely_cause(const Attribution& attribution);

std::string attribution_text(const Attribution& attribution);

}  // namespace gonogo::identify
