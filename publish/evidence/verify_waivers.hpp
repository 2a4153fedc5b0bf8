// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the known failures of a run make of its case lines.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "campaign/known_failures.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// The verdict of a line before the readings of the run were reconciled.
VerdictKind kind_before(const Json& line);

class RunWaivers {
 public:
  explicit RunWaivers(std::vector<KnownFailure> entries) : entries_(std::move(entries)) {}
  // Why no run with these entries has written the line so, a sentence; empty: one may have.
  // `holds_words`: messages are those of this gonogo, too.
  std::string fault(const Json& line, const CaseRow& row, bool holds_words) const;
  // Whether it is an xfail by an entry that is flaky alone: no trace tells in how many runs it
  // failed. REQUIRES: the line has no fault.
  bool rests_on_runs(const CaseRow& row) const;
  // What may stand behind the message of such a departure: that it came in more runs than a flaky
  // entry allows.
  std::vector<std::string> additions(const CaseRow& row) const;

 private:
  std::string fault_of_pass(const Json& line, const CaseRow& row) const;
  // The entry by which a pass of the case is none; null: there is none.
  const KnownFailure* steady_entry(const std::string& id) const;
  bool is_steady(const CaseRow& row) const;

  std::vector<KnownFailure> entries_;
};

}  // namespace gonogo::oracle::evidence
