// SPDX-License-Identifier: GPL-3.0-or-later
//
// The summary of a run: totals, the matrix of clauses and cycles, and what it did not check. Takes
// case lines one at a time; its memory depends on clauses and cycles, not on cases.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "oracle/records/case_head.hpp"
#include "oracle/records/finding.hpp"
#include "oracle/records/run_conditions.hpp"
#include "oracle/records/run_scope.hpp"
#include "oracle/records/verdict.hpp"

namespace gonogo::oracle::report {

using Json = nlohmann::ordered_json;

// An unknown name counts as NO-GO, so that nothing unknown passes.
Decision decision_of(const std::string& verdict);

// The cases of one cycle that hit one clause.
struct MatrixCell {
  std::uint64_t passed = 0;
  std::uint64_t failed = 0;  // departed at this clause
  std::uint64_t undecided = 0;
  std::uint64_t elsewhere = 0;  // hit it, but departed at another one, or failed as expected
};

class Summary {
 public:
  // `header`: of the results.
  explicit Summary(const Json& header);
  // The finding that the case belongs to; null: it is none.
  const Finding* add(const CaseHead& line);
  // What a finding is likely to come from, as find_causes() of the program says it.
  void set_cause(const Finding::Key& key, Cause cause) {
    findings_.set_cause(key, std::move(cause));
  }
  const Findings& findings() const { return findings_; }
  // `footer` null when the file has none; `bad_lines` could not be read.
  Json finish(const Json& header, const Json* footer, std::uint64_t bad_lines) const;
  const RunScope& scope() const { return scope_; }

  // What the readings of a run's footer say of its subject (followed_readings); null: no footer.
  static std::string follows(const Json* footer);

 private:
  Json headline(const Json& header, const Json* footer, std::uint64_t bad_lines) const;
  bool is_whole(const RunConditions& conditions, const Json* footer) const;
  Json matrix() const;
  Json not_checked(const Json& header) const;

  std::uint64_t cases_ = 0;
  std::map<std::string, std::uint64_t> totals_;  // by verdict
  std::map<std::string, std::uint64_t> judged_;  // by dialect: neither skipped nor undecided
  std::map<std::string, std::map<std::string, MatrixCell>> cells_;  // clause -> cycle
  std::set<std::string> cycles_;
  RunScope scope_;
  Findings findings_;
};

}  // namespace gonogo::oracle::report
