// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a corpus holds, counted.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "corpus/io/corpus.hpp"
#include "fuzz/generate/cover/cases.hpp"

namespace gonogo::cli {

std::string_view basis_name(const oracle::Expectation& expectation);

// The rows of each covering array that cases of a corpus come from, by what their ids begin with.
class CoveringArrays {
 public:
  void take(const oracle::Case& test);
  // Calls with what the ids begin with and the count of its tuples.
  template <typename Visit>
  void for_each(Visit visit) const {
    for (const auto& [stem, array] : arrays_) {
      visit(stem, cover::count_tuples(array.parameters, array.making.strength, array.rows));
    }
  }

 private:
  struct Array {
    cover::Making making;
    cover::Parameters parameters;
    std::vector<cover::Row> rows;
  };
  std::map<std::string, Array> arrays_;
};

// Cases, alarms, clauses, tuples.
class CorpusStats {
 public:
  void take(const oracle::Case& test);
  std::size_t cases() const { return cases_; }
  std::string text() const;

 private:
  // How often something occurs, by name.
  using Count = std::map<std::string, std::size_t>;
  struct Cycle {
    std::size_t cases = 0;
    std::size_t alarms = 0;
  };
  std::size_t count_clauses() const;
  static std::string list(const char* what, const Count& count);

  std::map<std::string, Cycle> cycles_;
  std::size_t cases_ = 0, alarming_ = 0, signs_ = 0;
  Count bases_, alarms_, planes_, readings_;
  std::set<std::string> clauses_, listed_, dialects_;
  CoveringArrays arrays_;
};

}  // namespace gonogo::cli
