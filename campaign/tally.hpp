// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run says as a whole. It is a function of its case lines and of the stale entries alone, so
// that a merge and a check elsewhere come to the same answer.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "campaign/reading_tally.hpp"
#include "oracle/records/case_head.hpp"
#include "oracle/records/rounding_census.hpp"
#include "oracle/records/run_conditions.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle {

// The facts of a case on which the answer of a run depends.
struct CaseFacts {
  CaseHead head;                                  // what lists show of the line
  VerdictKind verdict = VerdictKind::pass_exact;  // before the readings of the run are reconciled
  std::optional<OpenReadings> readings;           // of a GO that touched open readings
  std::string mapped;  // the entry of the alarm map that gave the alarm its class; empty: none
  std::optional<RoundingCensus> coordinates;  // of a GO: those that were compared
};

// The facts of a case line of results.jsonl. Throws std::runtime_error with a sentence when the
// text is no case line.
CaseFacts facts_of(std::string_view case_line);

// The answer of a run.
struct RunAnswer {
  std::map<std::string, std::size_t> totals;  // by verdict
  std::size_t cases = 0;
  std::size_t judged = 0;  // ended in GO or NO-GO
  std::size_t no_go = 0;
  std::size_t unexpected_gaps = 0;
  std::size_t oracle_errors = 0;
  bool judged_nothing = false;           // in all, or in one of the dialects
  std::string hardly_answered;           // a dialect, of its fresh programs
  std::vector<std::string> assignments;  // readings that explain all passes, "k=v k=v"
  std::string reading_conflict;  // the first case that no assignment explains with those before it
  // For all that is GO: how coordinates are rounded, by dialect.
  std::map<std::string, RoundingCensus> coordinates;
  std::string decision;     // GO, NO-GO or UNDECIDED
  std::string head;         // of what: a line
  std::string folded_head;  // the same with the names of a few features only
  RunScope scope;
  int exit_code = 0;  // of the program: 0, 1 or 3
};

class Tally {
 public:
  Tally() = default;
  // `subject`: what it declares, where that is known (RunScope).
  explicit Tally(std::optional<SubjectInfo> subject) {
    answer_.scope = RunScope(std::move(subject));
  }
  // Cases in the order of their ids. Returns the verdict of the case in the run: its own, or
  // fail.reading when no assignment explains it and all before, which may be known (J-RUN-17).
  VerdictKind add(const CaseFacts& facts);
  // For the case that was added last.
  const std::optional<ReadingConflict>& conflict() const { return conflict_; }
  // `stale`: entries of the subject's files that are no longer true. `conditions` stand in the head
  // line and decide nothing.
  RunAnswer finish(const std::vector<std::string>& stale,
                   const RunConditions& conditions = {}) const;

 private:
  RunAnswer answer_;
  ReadingTally readings_;
  std::optional<ReadingConflict> conflict_;
  std::map<std::string, std::size_t> judged_by_dialect_;
};

}  // namespace gonogo::oracle
