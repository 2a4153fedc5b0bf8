// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mistake that is named as the cause of departures, with what it explains of those that were
// tried; a run and a hunt say it in the same words.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "fuzz/identify/explanation.hpp"
#include "oracle/records/finding.hpp"

namespace gonogo::identify {

struct LikelyCause {
  std::string name;                      // of the mistake; empty: there is none
  std::vector<std::string> explained;    // departures that it explains in full, by their ids
  std::vector<std::string> unexplained;  // the others that were tried
  std::size_t passes = 0;                // programs that are GO and would be with it
  std::vector<std::string> rivals;       // mistakes that explain as much
  std::set<std::string> dialects = {};   // that those programs are of

  bool empty() const { return name.empty(); }
  // Those that it does not count yet.
  void add(const LikelyCause& other);
  std::string evidence() const;
  oracle::Cause told() const { return {name, empty() ? std::string() : evidence()}; }
};

// Whether a mistake that explains so many of the departures is worth a name: more than half of
// them, and three quarters where it is one of reading a word.
bool is_most(bool is_misread, std::size_t explained, std::size_t departures);

// Programs of one dialect: those that a finding departs on, the smallest first, and others, of
// which those that pass must pass with its cause, too.
struct FindingAsked {
  std::span<const ProgramAsked> departures;
  std::span<const ProgramAsked> others;
};

// Which of the causes that have been named explains another finding, perhaps in another dialect:
// the first that explains its smallest program and most of all. It counts them, and loses rivals
// that explain less of them; where a rival alone explains them, the cause is named after that.
// Null: none. Throws SubjectUnusable.
LikelyCause* recognise(std::vector<LikelyCause>& named, oracle::Subject& subject,
                       const FindingAsked& finding, const ExplanationOptions& options);

}  // namespace gonogo::identify
