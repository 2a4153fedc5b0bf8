// SPDX-License-Identifier: GPL-3.0-or-later
//
// SARIF 2.1.0: a result a case that is not GO, or that is known to fail, or an advice (a note); the
// rule is the clause departed from, or the verdict where no clause is at fault. A stale entry of
// the subject's files is a result, too.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/records/finding.hpp"
#include "oracle/records/output_file.hpp"
#include "publish/evidence/case_row.hpp"

namespace gonogo::oracle::evidence {

// Where the files of the repository can be read, as the build sets it (GONOGO_ADDRESS); empty:
// nowhere.
std::string_view address_of_pages();

class SarifWriter {
 public:
  // `address`: tool and rules link there; empty: informationUri and helpUri, which have to be
  // absolute addresses, are left out. Throws std::system_error, as all others.
  SarifWriter(const std::filesystem::path& path, const Json& header,
              std::string_view address = address_of_pages());
  // `finding`: what the case belongs to; null: none.
  void add(const CaseRow& facts, const Finding* finding);
  // An entry of the subject's files that is no longer true.
  void add_stale(const std::string& entry);
  // `unfinished`: what the run lacks, a sentence; or empty.
  void finish(const std::string& unfinished);

 private:
  std::size_t rule_index(const std::string& id);
  Json result(const CaseRow& facts, const Finding* finding);
  void write_result(const Json& result);

  OutputFile out_;
  Json header_;
  std::string address_;
  bool any_ = false;
  std::map<std::string, std::size_t> indices_;  // rule -> place
  std::vector<std::string> rules_;
};

}  // namespace gonogo::oracle::evidence
