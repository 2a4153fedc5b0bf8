// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of cycles under the head line of a run: one for terminal, page and Markdown.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "oracle/records/run_scope.hpp"

namespace gonogo::oracle {

struct CycleTable {
  static constexpr std::array<std::string_view, 8> kColumns = {
      "judged", "GO", "NO-GO", "advice", "known", "undecided", "skipped", "not covered"};
  struct Row {
    std::string cycle;
    std::string dialect;
    std::array<std::size_t, kColumns.size()> cases{};
    std::size_t no_go() const { return cases[2]; }
  };
  // Why the numbers are not those of the head line.
  static constexpr std::string_view kCounting =
      "The table counts a case once; the head line counts it for each feature it needs.";
  // Cycles of which a case was judged or failed; those that fail most first.
  std::vector<Row> rows;
  // Cycles of which nothing was judged, with their cases: "g112 306, g114 98"; empty: none.
  std::string others;
  // Whether a column says anything.
  std::array<bool, kColumns.size()> used{};
  // Whether a case may count for several features in the head line.
  bool counts_otherwise = false;

  // What a row is of; with its dialect, where there are several.
  std::string name(const Row& row) const;
  // For a terminal, indented; at most `most` rows, and then how many more there are.
  std::string text(std::size_t most) const;
};

CycleTable cycle_table(const RunScope& scope);

}  // namespace gonogo::oracle
