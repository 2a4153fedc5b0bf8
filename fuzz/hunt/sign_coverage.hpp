// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which signs of the comparisons that clauses turn on (reference/predicate.hpp) programs have met:
// a limit of which one side only was tried says little of the other.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "fuzz/hunt/trial.hpp"
#include "corpus/io/corpus.hpp"
#include "reference/predicate.hpp"

namespace gonogo::hunt {

// How often below zero, at it, above it.
using Signs = std::array<std::uint64_t, 3>;

// Counts what is decided in its thread while it lives.
class SignCounter final : public reference::DecisionWatch {
 public:
  void note(const reference::Decision& decision) override;
  // By clause and expression.
  using Counts = std::map<std::pair<reference::ClauseId, std::string>, Signs>;
  const Counts& counts() const { return counts_; }

 private:
  Counts counts_;
};

// The corpus's cases of the dialect, under every alternative of readings that they leave open.
// Throws oracle::CorpusError.
SignCounter::Counts signs_of_corpus(const oracle::Corpus& corpus, std::string_view dialect);
// So many programs of a hunt with that subject, its finding nothing or something.
SignCounter::Counts signs_of_hunt(const SubjectMaker& subject, const std::string& dialect,
                                  std::uint64_t seed, std::size_t programs);

// What was met of one comparison.
struct SignRow {
  std::string clause;
  std::string what;
  Signs corpus{};
  Signs hunt{};
};
std::vector<SignRow> sign_rows(const SignCounter::Counts& corpus, const SignCounter::Counts& hunt);

// How many of three signs a comparison, times the comparisons.
struct SignSummary {
  std::size_t comparisons = 0;
  std::size_t corpus = 0;
  std::size_t hunt = 0;
  std::size_t either = 0;
};
SignSummary summary_of(const std::vector<SignRow>& rows);

// "- 0 +" with a blank in place of a sign that was not met.
std::string met(const Signs& signs);

}  // namespace gonogo::hunt
