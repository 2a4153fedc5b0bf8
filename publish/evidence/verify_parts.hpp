// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of verify.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "campaign/results.hpp"
#include "campaign/tally.hpp"
#include "publish/evidence/case_row.hpp"
#include "publish/evidence/statement.hpp"
#include "publish/evidence/verify.hpp"

namespace gonogo::oracle::evidence {

// What one reading of the results gives the checks of verify.
struct ResultsFacts {
  Json header;
  Json footer;
  RunAnswer answer;
  std::set<std::string> mapped;           // entries of the alarm map that a case met
  std::vector<std::string> inconsistent;  // lines whose verdict is not what the tally makes of it
  // Cases of the corpus, by dialect, before the readings of the run are reconciled, as they were
  // when fresh programs were asked; whether one of them is NO-GO, or known to fail.
  std::map<std::string, std::size_t> judged;
  bool is_no_go = false;
  bool is_known = false;
  bool knows_failures = false;  // the run had known failures
};

// Throws ResultsError.
ResultsFacts read_results(const std::string& path);

// Collects what the checks say, and faults of one kind as one list.
class Findings {
 public:
  void add(Check::Result result, std::string sentence) {
    checks_.push_back({result, std::move(sentence)});
  }
  // What could not be derived, and a run of the subject can show.
  void add_unproven(std::string sentence) {
    checks_.push_back({Check::Result::unchecked, std::move(sentence), true});
  }
  void add_open(std::string sentence) {
    checks_.push_back({Check::Result::open, std::move(sentence), true});
  }
  // `ok` when there is no fault; of many the first are named.
  void add_list(const std::vector<std::string>& faults, std::string ok);
  std::vector<Check> take() { return std::move(checks_); }

 private:
  std::vector<Check> checks_;
};

// The traces that SHA256SUMS names.
TraceFiles trace_files_of(const std::filesystem::path& folder);

// Whether the files are those that SHA256SUMS names; none is looked into.
void check_sums(const std::filesystem::path& folder, Findings& findings);

// In what the header of a run differs from the command line that it names, that of a merged run
// from those of its shards, and what it has that no header has: sentences.
std::vector<std::string> header_faults(const Json& header);

// Totals, decision and fresh programs of the footer, derived again.
void check_footer(const ResultsFacts& facts, Findings& findings);
// What no line shows without the subject.
void tell_fresh_programs(const ResultsFacts& facts, Findings& findings);

}  // namespace gonogo::oracle::evidence
