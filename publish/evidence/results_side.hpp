// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several results files, read side by side in the order of their ids.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "campaign/results_reader.hpp"

namespace gonogo::oracle::evidence {

// A results file with the case that is up. Throws ResultsError for a file that is faulty.
class ResultsSide {
 public:
  explicit ResultsSide(const std::string& path) : reader_(path) { step(); }
  const ResultsReader& reader() const { return reader_; }
  // Null: the file is at its end.
  const CaseHead* line() const { return at_end_ ? nullptr : &line_; }
  bool is_at(const std::string& id) const { return !at_end_ && line_.id == id; }
  void step() { at_end_ = !reader_.next(line_); }

 private:
  ResultsReader reader_;
  CaseHead line_;
  bool at_end_ = false;
};
using ResultsSides = std::vector<std::unique_ptr<ResultsSide>>;

// The first of the cases that are up; null: all files are at their end.
inline const CaseHead* first_line(const ResultsSides& sides) {
  const CaseHead* first = nullptr;
  for (const auto& side : sides) {
    const CaseHead* const line = side->line();
    if (line != nullptr && (first == nullptr || line->id < first->id)) first = line;
  }
  return first;
}

inline void step_past(const ResultsSides& sides, const std::string& id) {
  for (const auto& side : sides) {
    if (side->is_at(id)) side->step();
  }
}

}  // namespace gonogo::oracle::evidence
