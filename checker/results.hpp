// SPDX-License-Identifier: GPL-3.0-or-later
//
// results.jsonl: a header line, a line a case, a footer line.
#pragma once

#include <cstdint>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "checker/json.hpp"
#include "checker/sha256.hpp"

namespace gonogo::checker {

enum class Decision { go, no_go, undecided, neither };
// Nothing for a verdict that is unknown.
std::optional<Decision> decision_of(std::string_view verdict);
// Whether a case that ended so was judged: in GO or NO-GO.
bool is_judged(std::string_view verdict);

class ResultsFile {
 public:
  // Reads the header; throws Fault.
  explicit ResultsFile(std::string path);

  const Json& header() const { return header_; }
  // The next case; false after the last. Throws Fault for a line that is no case.
  bool next(Json& line);
  // The line that was read last, to which the places of its values belong.
  const std::string& text() const { return text_; }
  // After the last case: whether there was a footer.
  bool is_whole() const { return footer_.has_value(); }
  const std::optional<Json>& footer() const { return footer_; }
  // What does not hold of the file so far: sentences. The footer's hash and counts are held against
  // the lines when it has been read.
  const std::vector<std::string>& faults() const { return faults_; }
  std::size_t cases() const { return cases_; }

 private:
  bool read_line();
  void note_case(const Json& line);
  void check_footer();
  void check_decision();
  void check_head();
  void fault(const std::string& sentence);

  std::string path_;
  std::ifstream in_;
  std::string text_;
  std::size_t number_ = 0;  // of the line
  Json header_;
  std::optional<Json> footer_;
  std::vector<std::string> faults_;
  Sha256 hash_;
  std::string last_id_;
  std::size_t cases_ = 0;
  std::map<std::string, std::size_t> totals_;
  std::map<std::string, bool> judged_;  // by dialect: a case of it was
  bool unexpected_gap_ = false;
};

}  // namespace gonogo::checker
