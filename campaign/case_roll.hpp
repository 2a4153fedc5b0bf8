// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which cases a run must have, and what their lines must say for any subject: from the
// corpus and the header alone.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "campaign/campaign.hpp"
#include "campaign/results_reader.hpp"

namespace gonogo::oracle {

// In what a case line differs from the case that follows from the corpus and the header: dialect,
// cycle, features, clauses, profile, program, expected gap; or that it is neither GO nor skipped
// and has no trace. A sentence; empty: in nothing. `test`: the case as it was run.
std::string line_fault(const Case& test, const ResultsReader::Json& line);

// Checks that a run has all its cases (J-RUN-13). Lines come in the order of their ids; the corpus
// is read once for every so many of them, and memory does not grow with their number.
class CaseRoll {
 public:
  using Json = ResultsReader::Json;
  // Sees each case with its line, when the line is that of the case; null: of a fresh program.
  using Visit = std::function<void(const Case* test, const Json& line)>;
  // Sees the id of every case of the corpus once.
  using Note = std::function<void(const std::string& id)>;

  // The corpus must outlive it. Throws ResultsError for a header that cannot be read.
  CaseRoll(const Corpus& corpus, const Json& header, Visit visit = nullptr, Note note = nullptr);
  void take(const CaseHead& head, std::string line);
  // After the last line.
  void finish();

  // Sentences: lines that are missing, too many, or of another case than they name.
  const std::vector<std::string>& faults() const { return faults_; }
  // Cases that contradict the certifier's profile.
  std::size_t left_out() const { return left_out_; }

 private:
  void call(bool is_last);
  void call_one(Case test);

  const Corpus& corpus_;
  CampaignOptions asked_;
  Visit visit_;
  Note note_;
  std::map<std::string, std::string> lines_;  // not called yet
  std::size_t bytes_ = 0;                     // of them
  std::string called_;                        // up to this id, all have been
  bool is_first_call_ = true;
  std::vector<std::string> faults_;
  std::size_t left_out_ = 0;
};

}  // namespace gonogo::oracle
