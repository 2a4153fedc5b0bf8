// SPDX-License-Identifier: GPL-3.0-or-later
//
// JUnit XML: a test suite a dialect, a test case a case.
#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "oracle/records/finding.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/evidence/run_state.hpp"

namespace gonogo::oracle::evidence {

// Where the answer to a case stands in JUnit's terms: <failure> for a NO-GO, <error> where the
// subject or the gauge broke down, <skipped> for skips, advices, known failures and what is
// undecided.
enum class JunitMark { passed, failure, error, skipped };
JunitMark junit_mark(const CaseRow& facts);

// Takes the cases in any order of dialects. A suite begins with its numbers, so each suite waits in
// a file of its own until the end.
class JunitWriter {
 public:
  // Throws std::system_error, as all others.
  JunitWriter(std::filesystem::path path, const Json& header);
  ~JunitWriter();
  JunitWriter(const JunitWriter&) = delete;
  JunitWriter& operator=(const JunitWriter&) = delete;

  // `finding`: what the case belongs to; null: none.
  void add(const CaseRow& facts, const Finding* finding);
  // What the run lacks, and what is stale, becomes a suite of errors.
  void finish(const RunState& state);

 private:
  struct Counts {
    std::uint64_t tests = 0;
    std::uint64_t failures = 0;
    std::uint64_t errors = 0;
    std::uint64_t skipped = 0;
    std::uint64_t microseconds = 0;
    void add(JunitMark mark, std::uint64_t time);
    std::string attributes() const;
  };
  struct Suite {
    std::filesystem::path path;
    std::ofstream out;
    Counts counts;
  };
  Suite& suite(const std::string& dialect);
  std::string properties(const RunState& state) const;
  std::string run_suite(const RunState& state, const std::string& properties);
  void copy_suite(const std::string& dialect, Suite& suite, OutputFile& out,
                  const std::string& properties) const;

  std::filesystem::path path_;
  std::string properties_;  // of each suite
  std::map<std::string, Suite> suites_;
  Counts all_;
};

}  // namespace gonogo::oracle::evidence
