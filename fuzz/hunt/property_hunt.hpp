// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hunt without a reference: a subject's answers to related programs must agree with each
// other. Neither the reference nor the judge is run.
#pragma once

#include <set>

#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/hunt/reduce.hpp"
#include "fuzz/hunt/trial.hpp"
#include "fuzz/program/mutator/dice.hpp"
#include "fuzz/relations/trace.hpp"

namespace gonogo::hunt {

// What the subject puts out of the program, stopped behind 5,000 records.
relations::Trace trace_of(oracle::Subject& subject, const generate::GeneratedProgram& program);

struct PropertyOptions : GivenMachine {
  std::string dialect;
  std::uint64_t seed = 1;
  generate::GeneratorSettings settings;
  std::optional<reference::Number>
      tolerance;  // mm; nothing: the subject's resolution, else the machine's
  std::chrono::milliseconds run_limit{2'000};
  bool blind = false;  // for the check of the bench: everything agrees
};

// Two programs whose answers disagree.
struct PropertyFinding {
  const relations::Relation* relation = nullptr;
  std::size_t variant = 0;
  generate::GeneratedProgram program;
  generate::GeneratedProgram other;
  relations::Difference difference;
  std::string code;             // in force where they differ: "G94"
  std::size_t number = 0;       // of the program in the hunt, from 1
  std::size_t reduce_runs = 0;  // that the reduction took
  bool is_reduced = false;      // nothing smaller shows the same
  // "translation feed/feed in G94"
  std::string signature() const;
};

struct PropertyCount {
  std::size_t programs = 0;
  std::size_t pairs = 0;      // that were compared
  std::size_t skipped = 0;    // without an answer, or too long
  std::size_t different = 0;  // pairs; those of known signatures among them
};

class PropertyHunt {
 public:
  // REQUIRES: the dialect has a generator. Throws oracle::SubjectUnusable.
  PropertyHunt(SubjectMaker make, PropertyOptions options);

  // Tries one more program and its relations. A finding is one of a signature that none before had.
  std::optional<PropertyFinding> step();
  // Reduces both programs, with the same signature. What `also` is given holds of the result.
  void reduce(PropertyFinding& finding, ReduceLimits limits, const StillShows& also = nullptr);

  // Whether the answers to the program and its relation disagree.
  bool differs(const generate::GeneratedProgram& program, const relations::Relation& relation,
               std::size_t variant);

  const PropertyCount& count() const { return count_; }
  const oracle::SubjectInfo& info() const { return subject_->info(); }

 private:
  relations::Trace run(const generate::GeneratedProgram& program);
  std::optional<PropertyFinding> compare(const relations::Relation& relation, std::size_t variant,
                                         const generate::GeneratedProgram& program,
                                         const relations::Trace& trace);
  std::optional<PropertyFinding> alone(const PropertyFinding& finding);
  reference::Number tolerance_of(const relations::Relation& relation,
                                 const reference::Profile& profile) const;
  bool can_show(const relations::Relation& relation) const;

  SubjectMaker make_;
  PropertyOptions options_;
  const generate::Generator& generator_;
  std::unique_ptr<oracle::Subject> subject_;
  program::Dice dice_;
  std::set<std::string> known_;
  PropertyCount count_;
};

}  // namespace gonogo::hunt
