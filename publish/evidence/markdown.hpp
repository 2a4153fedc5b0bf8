// SPDX-License-Identifier: GPL-3.0-or-later
//
// The run on one page of Markdown, for the step summary of a CI job.
#pragma once

#include <map>
#include <string>

#include "oracle/records/finding.hpp"
#include "publish/evidence/run_state.hpp"

namespace gonogo::oracle::evidence {

class MarkdownSummary {
 public:
  explicit MarkdownSummary(const Json& header);
  // `finding`: what the case belongs to, null: none; whether it is the smallest of it so far.
  void add(const CaseRow& facts, const Finding* finding, bool is_smallest);
  std::string text(const RunState& state) const;

 private:
  static constexpr std::size_t kShown = 10;

  std::string head(const RunState& state) const;
  std::string findings(const RunState& state) const;
  static std::string failure(const CaseRow& facts);

  Json header_;
  std::map<std::size_t, CaseRow> smallest_;  // by the number of the finding
};

// | verdict | | cases |
std::string totals_table(const Json& totals);
// Lists of the groups of a scope, as of the summary; empty where there are none.
std::string not_claimed_list(const Json& scope);
std::string declared_but_skipped_list(const Json& scope);
std::string advice_list(const Json& scope);
// How coordinates are rounded, by dialect; empty where it is unknown.
std::string coordinates_list(const RunState& state);
inline constexpr const char* kNotClaimedTitle = "Not claimed by the subject: not judged";
inline constexpr const char* kAdvicesTitle = "Advices: departures from what no text states";
inline constexpr const char* kCoordinatesTitle = "Coordinates of what is GO";
// `a`, `b`, ...: the first cases of a group.
std::string named_cases(const Json& group);
// A list of what a run did not check; `state.summary` says it.
std::string not_checked_list(const RunState& state);

}  // namespace gonogo::oracle::evidence
