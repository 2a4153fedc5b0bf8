// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a site shows of one results file. Its size depends on cycles, clauses and reasons, not on
// cases.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "oracle/records/case_head.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle::site {

// What a case came to. `known`: it departs as the file of known failures says.
enum class Outcome : std::uint8_t { go, known, no_go, undecided, advice, skip };
inline constexpr std::size_t kOutcomes = 6;
// "GO", "known to depart", ...
std::string_view title(Outcome outcome);
// The class of the style sheet: "go", "known", ...
std::string_view key(Outcome outcome);
Outcome outcome_of(VerdictKind kind);
// Whether the subject did something else than the reference, known or not.
inline bool departs(Outcome outcome) {
  return outcome == Outcome::known || outcome == Outcome::no_go;
}

// Cases by what they came to.
struct Counts {
  std::array<std::uint64_t, kOutcomes> of{};

  void add(Outcome outcome) { ++of[static_cast<std::size_t>(outcome)]; }
  std::uint64_t operator[](Outcome outcome) const { return of[static_cast<std::size_t>(outcome)]; }
  std::uint64_t cases() const;
  // GO or departed.
  std::uint64_t answered() const {
    return (*this)[Outcome::go] + (*this)[Outcome::known] + (*this)[Outcome::no_go];
  }
};

// The cases that are there to test one clause.
struct ClauseCounts {
  std::uint64_t passed = 0;
  std::uint64_t departed = 0;   // at this clause
  std::uint64_t elsewhere = 0;  // at another one
  std::uint64_t undecided = 0;
};

// Run time of the judged cases.
class Speed {
 public:
  struct Slow {
    std::uint64_t microseconds = 0;
    std::string id;
  };
  void add(const std::string& id, std::uint64_t microseconds);
  std::uint64_t cases() const { return cases_; }
  std::uint64_t microseconds() const { return total_; }
  // Cases a second of run time; 0: nothing was timed.
  double rate() const;
  // Microseconds that `percent` of the cases stay below: the end of a class of times, each a
  // twelfth wider than the one before at most.
  std::uint64_t below(unsigned percent) const;
  // The slowest first, ten at most.
  const std::vector<Slow>& slowest() const { return slowest_; }

 private:
  std::map<std::uint64_t, std::uint64_t> classes_;  // end of the class -> cases
  std::uint64_t cases_ = 0;
  std::uint64_t total_ = 0;
  std::vector<Slow> slowest_;
};

// Dialect and cycle, as people count: g90 before g110.
struct CycleKey {
  std::string dialect;
  std::string cycle;
  bool operator<(const CycleKey& other) const;
  bool operator==(const CycleKey&) const = default;
};

// What a known failure is put down to.
struct Reason {
  std::uint64_t cases = 0;
  std::set<std::string> verdicts;
};

// A title as the name of a folder and a part of an address: letters in lower case, digits, dots and
// hyphens; "run" where none of these is left.
std::string folder_stem(std::string_view title);

struct Run {
  std::string name;     // of the implementation
  std::string version;  // of it; may be empty
  std::string path;     // of the results
  std::string stem;     // folder of its report: runs/STEM
  std::string corpus;   // version
  std::string corpus_sha256;
  std::string gonogo;
  std::string decision;  // GO, NO-GO, UNDECIDED; INCOMPLETE without a footer
  std::string head;
  Counts counts;
  std::map<CycleKey, Counts> cycles;
  std::map<std::string, ClauseCounts> clauses;
  std::map<std::string, Reason> reasons;
  Speed speed;
  std::set<std::string> dialects;

  std::string title() const { return version.empty() ? name : name + " " + version; }
  Counts of_cycle(const CycleKey& cycle) const;
  void add(const CaseHead& line, Outcome outcome);
};

}  // namespace gonogo::oracle::site
