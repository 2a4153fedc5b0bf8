// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where implementations agree: with the reference, against it, among themselves. One vote an
// implementation, that of its last version.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "oracle/records/case_head.hpp"
#include "publish/site/run.hpp"

namespace gonogo::oracle::site {

// How the implementations voted that answered a case: GO or a departure. Skipped and undecided ones
// have no vote.
enum class Ballot : std::uint8_t {
  agreed,    // all with the reference
  lone,      // one departs, others do not
  split,     // several depart, others do not
  against,   // all depart, and alike: none says what the reference says
  scattered  // all depart, each in its own way
};
inline constexpr std::size_t kBallots = 5;
std::string_view title(Ballot ballot);
std::string_view key(Ballot ballot);

// Cases in which the same two or more depart alike, at one clause in one way.
struct Agreement {
  // What they have in common.
  struct Key {
    Ballot ballot = Ballot::split;
    std::vector<std::size_t> alike;  // the largest group of runs that depart alike
    std::vector<std::size_t> with;   // runs that are GO
    std::vector<std::size_t> other;  // the other runs that depart
    std::string dialect;
    std::string clause;
    std::string verdict;
    auto operator<=>(const Key&) const = default;
  };
  Key key;
  std::uint64_t cases = 0;
  std::vector<std::string> first;  // ids
  std::string message;             // of the first
};

// How often two of them answered the same case, and gave the same answer.
struct Pair {
  std::uint64_t both = 0;
  std::uint64_t alike = 0;
  std::uint64_t depart_alike = 0;  // of them: against the reference
};

class Votes {
 public:
  struct Answer {
    std::size_t run = 0;
    bool go = false;
    std::string departure;  // text that equal departures share; empty: GO
    std::string verdict;
    std::string clause;
    std::string message;
  };
  // The answers to one case, of one run an implementation. Cases in the order of their ids.
  void add(const CaseHead& test, const std::vector<Answer>& answers);

  const std::map<Ballot, std::uint64_t>& ballots() const { return ballots_; }
  std::uint64_t alone() const { return alone_; }  // cases with one answer or none
  // Where none says what the reference says first, then by how many depart alike, then by cases.
  std::vector<const Agreement*> list() const;
  Pair pair(std::size_t one, std::size_t other) const;

 private:
  std::map<Ballot, std::uint64_t> ballots_;
  std::uint64_t alone_ = 0;
  std::map<Agreement::Key, Agreement> agreements_;
  std::map<std::pair<std::size_t, std::size_t>, Pair> pairs_;
};

// Departures of one case are equal if they are from one clause, by the same amount to 0.001 mm,
// since subjects round; where nothing is measured, if the subject did the same there. The name of
// an alarm does not count, nor do source lines, which not every subject knows.
std::string departure_text(const CaseHead& line);

}  // namespace gonogo::oracle::site
