// SPDX-License-Identifier: GPL-3.0-or-later
//
// The hunt over machining operations: one list, written for every dialect that the subjects have,
// with cycles and without. All answers must be one path, and none may break the rules of
// safety. Neither the reference nor the judge is run.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fuzz/hunt/trial.hpp"
#include "fuzz/relations/operation_path.hpp"

namespace gonogo::hunt {

struct OperationOptions {
  std::uint64_t seed = 1;
  std::vector<std::string> dialects;           // only these; empty: all that the subjects declare
  std::optional<reference::Number> tolerance;  // mm; nothing: the coarsest of the two resolutions
  std::chrono::milliseconds run_limit{2'000};
};

// A program of the list, and who ran it.
struct WrittenProgram {
  std::string subject;  // as it was named
  relations::Notation notation;
  std::string text;
  // "rs274 with cycles"
  std::string way() const;
};

struct OperationFinding {
  relations::OperationList list;
  // Two programs of one path that are not; or a rule that the second one's path breaks.
  std::optional<WrittenProgram> first;
  WrittenProgram second;
  std::optional<relations::PathDifference> difference;
  std::optional<relations::Breach> breach;
  std::string breakdown;   // no answer: what happened
  std::size_t number = 0;  // of the list in the hunt, from 1
  // What is wrong, in which ways of writing: "traverse-in-stock: rs274 with cycles".
  std::string shape() const;
  // The same with the first operation of the list: "holes (peck), ...".
  std::string signature() const;
};

struct OperationCount {
  std::size_t lists = 0;
  std::size_t programs = 0;  // that were answered
  std::size_t skipped = 0;   // without an answer
  std::size_t pairs = 0;     // of paths that were compared
  std::size_t findings = 0;  // those of known signatures among them
};

class OperationHunt {
 public:
  struct Named {
    std::string name;
    SubjectMaker make;
  };
  // Throws oracle::SubjectUnusable.
  OperationHunt(std::vector<Named> subjects, OperationOptions options);

  // Tries one more list. Findings are those of signatures that none before had, reduced.
  std::vector<OperationFinding> step();

  const OperationCount& count() const { return count_; }
  // The ways in which lists are written, as "builtin:gsk gsk988ta with cycles"; empty: the subjects
  // name no dialect with them.
  std::vector<std::string> ways() const;

 private:
  struct Seat {
    std::string name;
    SubjectMaker make;
    std::unique_ptr<oracle::Subject> subject;
    std::vector<relations::Notation> notations;
  };
  struct Answer {
    WrittenProgram program;
    relations::Trace trace;
    std::vector<relations::Leg> legs;
    reference::Number tolerance;
  };

  std::optional<Answer> answer(Seat& seat, const relations::Notation& notation,
                               const relations::OperationList& list);
  std::vector<OperationFinding> findings_of(const relations::OperationList& list);
  OperationFinding reduced(OperationFinding finding);

  std::vector<Seat> seats_;
  OperationOptions options_;
  program::Dice dice_;
  std::set<std::string> known_;
  std::map<std::string, std::size_t> reductions_;  // by subject and shape
  OperationCount count_;
};

}  // namespace gonogo::hunt
