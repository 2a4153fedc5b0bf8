// SPDX-License-Identifier: GPL-3.0-or-later
//
// What lists, totals and matrices show of a case line of results.jsonl, read without building the
// whole line: there are millions of them, and nearly all are GO.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace gonogo::oracle {

// Format 1 lacks `rule`, `gap` and `known`, and is read.
inline constexpr std::int64_t kResultsFormat = 2;
constexpr bool reads_results_format(std::int64_t format) {
  return format >= 1 && format <= kResultsFormat;
}

struct CaseHead {
  std::string id;  // texts that are missing or of another kind are empty
  std::string dialect;
  std::string cycle;
  std::string verdict;
  std::string clause;     // departed from
  std::string departure;  // of an advice or xfail: the verdict that it would be
  std::string rule;       // of the relation, that is broken: "R2"
  std::string gap;        // of an oracle-gap: its reason
  std::string known;      // of an xfail: the reason of its entry
  std::string feature;    // that was skipped
  std::string message;
  std::string want;                   // the reference's record or alarm that was departed from
  std::string got;                    // the subject's
  std::string deviation;              // exact
  std::string against;                // of a fail.reading: the case that shows another alternative
  std::vector<std::string> features;  // that the case needs
  std::vector<std::string> clauses;
  std::uint64_t block = 0;  // source line; 0: none
  std::uint64_t microseconds = 0;
  std::uint64_t attempts = 1;  // runs that the verdict took
  std::size_t program_blocks =
      0;  // of the program, where the line has it: lines that are not blank
  std::size_t program_bytes = 0;
  bool expected = false;  // an oracle-gap that the corpus expects
};

// False for a line that is no JSON object, and for JSON that a message of the protocol may not be
// (a key twice, deep nesting); `head` is then of no use.
bool read_case_head(std::string_view line, CaseHead& head);

// Results of format 1 have the reason and the message of an xfail in one sentence. REQUIRES: the
// line is one of an xfail without `known`. Where the message is not of that form all of it is the
// reason.
void split_known_message(std::string_view departure, std::string& known, std::string& message);

}  // namespace gonogo::oracle
