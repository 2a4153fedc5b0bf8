// SPDX-License-Identifier: GPL-3.0-or-later
//
// The HTML report: one file that opens offline.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include "oracle/records/case_head.hpp"
#include "oracle/records/finding.hpp"
#include "publish/report/case_detail.hpp"

namespace gonogo::oracle::report {

// The page while it is written: a block of rows for the list, a block a failure. It is in place
// only when it is complete.
class HtmlPage {
 public:
  // `directory`/index.html, of a run with this header.
  HtmlPage(const std::string& directory, const Json& header);
  ~HtmlPage();
  HtmlPage(const HtmlPage&) = delete;
  HtmlPage& operator=(const HtmlPage&) = delete;

  // `finding`: what the case belongs to; null: none.
  void add(const CaseHead& line, const Finding* finding);
  // The whole line of the case that was added last. REQUIRES: it is not GO. `always`: with its
  // drawing, however large the page has become.
  void add_detail(const Json& line, bool always);
  // What is known of the case that was added last, which is GO. A page keeps only a limited number;
  // false: it takes no more.
  bool add_pass(const CorpusCase& test);
  // What Summary::finish() says. A sentence when anything could not be written.
  std::optional<std::string> finish(const Json& summary);

 private:
  void flush_rows();
  void flush_passes();

  std::filesystem::path target_;
  std::filesystem::path part_;
  std::ofstream out_;
  std::string after_;  // of the skeleton, behind the data
  std::string subject_;
  std::string rows_;
  std::size_t index_ = 0;
  std::size_t path_bytes_ = 0;
  Json passes_ = Json::object();  // by the place of their rows
  std::size_t first_pass_ = 0;
  std::size_t pass_bytes_ = 0;
  bool done_ = false;
};

// Reads a results file line by line and writes `directory`/index.html. A results file without
// footer, or with lines that cannot be read, still makes a page; the page says so. A sentence for a
// file that cannot be opened or written, and for a first line that is not the header of format 1.
std::optional<std::string> write_html_report(const std::string& results,
                                             const std::string& directory);

}  // namespace gonogo::oracle::report
