// SPDX-License-Identifier: GPL-3.0-or-later
//
// results.jsonl: a header line, a line a case sorted by id, a footer. A file without its footer is
// incomplete.
#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/subject.hpp"
#include "oracle/verdict.hpp"

namespace gonogo::oracle {

// What was run.
struct ResultsHeader {
  std::string version;  // of gonogo
  std::string corpus_version;
  std::string corpus_sha256;
  std::string subject_spec;
  SubjectInfo subject;
  std::string profile;    // JSON object of what the certifier set
  std::string tolerance;  // empty: as declared
  std::string chord;      // empty: none
  std::uint64_t seed = 0;
  std::string shard = "1/1";
  std::vector<std::string> argv;
};

// One judged case.
struct CaseResult {
  std::string id;
  std::string dialect;
  std::string cycle;
  std::vector<std::string> clauses;
  Verdict verdict;
  std::string profile;             // JSON object
  std::string program;             // bytes; only when not GO
  std::vector<std::string> trace;  // records as JSON; only when not GO
  std::string notes;               // what the subject wrote to stderr; only when not GO
  std::int64_t microseconds = 0;
  int attempts = 1;
  bool expected_gap = false;  // the corpus expects that the gauge cannot say
};

struct ResultsFooter {
  std::map<std::string, std::size_t> totals;  // by verdict
  std::string decision;                       // of the run: GO, NO-GO or UNDECIDED
  std::size_t judged = 0;                     // neither skipped nor undecided
  std::vector<std::string> assignments;       // readings that explain all passes, "k=v k=v"
  std::string sha256;                         // over the case lines without `us` and `attempts`
};

// Writes a results file. Lines arrive in any order; close() sorts them by id, writes the footer and
// puts the file in place in one step. Until then <path>.part holds what has come.
class ResultsWriter {
 public:
  // Throws std::system_error when the file cannot be made.
  ResultsWriter(std::string path, const ResultsHeader& header);
  ~ResultsWriter();
  ResultsWriter(const ResultsWriter&) = delete;
  ResultsWriter& operator=(const ResultsWriter&) = delete;

  // Throws std::system_error when the disk is full.
  void add(const CaseResult& result);
  // Fills in totals and hash of the footer. Throws std::system_error.
  void close(ResultsFooter& footer);

 private:
  struct Place {
    std::string id;
    long long offset;
    std::size_t length;
  };
  std::string path_;
  std::string header_;
  std::FILE* part_ = nullptr;
  long long end_ = 0;
  std::vector<Place> places_;
  std::map<std::string, std::size_t> totals_;
};

std::string header_line(const ResultsHeader& header);
// `with_timing`: with `us` and `attempts`.
std::string case_line(const CaseResult& result, bool with_timing);

}  // namespace gonogo::oracle
