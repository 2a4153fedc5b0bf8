// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which part of a dialect programs reached, and which of it a subject answered: by clause, with the
// ways in which each decided something, and by feature.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "fuzz/hunt/coverage.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::hunt {

enum class ProgramSource { corpus, campaign };

// Programs, by where they are from, and what became of them.
struct ReachCount {
  std::size_t corpus = 0;
  std::size_t campaign = 0;
  std::size_t judged = 0;  // GO or NO-GO
  std::size_t no_go = 0;
  std::size_t skipped = 0;

  std::size_t programs() const { return corpus + campaign; }
};

struct ClauseReach {
  ReachCount count;              // programs with a record or an alarm of the clause
  std::size_t about = 0;         // cases of the corpus that are about it
  std::set<std::uint64_t> ways;  // in which it decided something, of all programs
  std::set<std::uint64_t> judged_ways;
};

class Reach {
 public:
  // The dialect's whole catalog and vocabulary.
  explicit Reach(const std::string& dialect);

  // `verdict`: nothing where the subject's answer was too long to be judged. `features`: that the
  // program is known to need, beside those that its codes and words show.
  void add(ProgramSource source, const generate::GeneratedProgram& program,
           const std::optional<oracle::Verdict>& verdict,
           const std::vector<std::string>& features = {});
  // A case of the corpus is about the clause.
  void add_about(const std::string& clause);

  const ReachCount& programs() const { return programs_; }
  const std::map<std::string, ClauseReach>& clauses() const { return clauses_; }
  const std::map<std::string, ReachCount>& features() const { return features_; }
  // A table for people, and the same as JSON.
  std::string text() const;
  std::string json(const std::string& subject) const;

 private:
  std::string dialect_;
  ReachCount programs_;
  std::map<std::string, ClauseReach> clauses_;
  std::map<std::string, ReachCount> features_;
};

}  // namespace gonogo::hunt
