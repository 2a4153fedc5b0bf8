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
    bool fails() const { return cases[2] > 0; }
  };
  // Cycles of which a case was judged or failed; those that fail first.
  std::vector<Row> rows;
  // Cycles of which nothing was judged, with their cases: "g112 306, g114 98"; empty: none.
  std::string others;
  // Whether a column says anything.
  std::array<bool, kColumns.size()> used{};

  // For a terminal, indented; at most `most` rows, and then how many more there are.
  std::string text(std::size_t most) const;
};

CycleTable cycle_table(const RunScope& scope);

}  // namespace gonogo::oracle
