// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mutants by operator, judged and counted.
#pragma once

#include <map>
#include <set>
#include <string>

#include "operator.hpp"
#include "statement.hpp"

namespace gonogo::mutations {

struct Row {
  long mutants = 0;
  long wrong = 0;                         // that must be rejected
  long no_go = 0;                         // of these
  long advice = 0;                        // of these
  long gap = 0;                           // of these: undecided, a survivor
  long uncounted = 0;                     // no statement
  std::map<std::string, long> explained;  // passed and right, by kind
  long survivors = 0;
};

struct Survivor {
  std::string id;
  std::string op;
  std::string rule;  // that is broken, by the definition (docs/relation.md); empty: not asked
  std::string why;
  std::string verdict;
  std::string text;  // program and trace
  std::size_t size = 0;
};

class Bench {
 public:
  explicit Bench(const RawCases& cases) : cases_(cases) {}
  // Mutants of all groups in turn, until so many are judged that must be rejected.
  void run(Chance& chance, long wanted);
  void print() const;
  long wrong() const;
  const std::vector<Survivor>& survivors() const { return survivors_; }
  // Conditions of an open part that its shown path breaks: faults of the bench.
  const std::set<std::string>& faults() const { return faults_; }
  // Groups of which no mutant was judged.
  std::vector<std::string> untried() const;

 private:
  void try_specimen(const Specimen& specimen, Chance& chance);
  void try_operator(const Specimen& specimen, const Operator& op, Chance& chance);
  void count(const Specimen& specimen, const Operator& op, const Statement& statement,
             const Trace& mutant, const oracle::Verdict& verdict);

  const RawCases& cases_;
  std::vector<Operator> operators_ = wrong_operators();
  std::map<std::string_view, Row> rows_;
  std::map<std::string, long> by_group_;
  std::map<std::string, long> no_go_by_rule_;
  std::vector<Survivor> survivors_;
  // Right by the bench, NO-GO by the judge: printed, for the alternatives' test to pursue.
  std::vector<Survivor> harsh_;
  std::set<std::string> faults_;
  long unusable_ = 0;
};

std::string trace_text(const Trace& trace);

}  // namespace gonogo::mutations
