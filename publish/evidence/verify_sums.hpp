// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part of verify that looks at the files of a certificate and not into them.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "publish/evidence/statement.hpp"
#include "publish/evidence/verify.hpp"

namespace gonogo::oracle::evidence {

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

// Whether the files are those that SHA256SUMS names.
void check_sums(const std::filesystem::path& folder, Findings& findings);

}  // namespace gonogo::oracle::evidence
