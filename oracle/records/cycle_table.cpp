// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/records/cycle_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace gonogo::oracle {
namespace {

CycleTable::Row row_of(const std::string& dialect, const std::string& name,
                       const RunScope::Counts& cycle) {
  return {name,
          dialect,
          {cycle.judged(), cycle.go, cycle.no_go, cycle.advised, cycle.known, cycle.undecided,
           cycle.skipped, cycle.not_covered}};
}

std::size_t width_of(std::size_t column) {
  return std::max<std::size_t>(6, CycleTable::kColumns[column].size());
}

}  // namespace

CycleTable cycle_table(const RunScope& scope) {
  CycleTable table;
  for (const auto& [dialect, cycles] : scope.cycles()) {
    for (const auto& [name, cycle] : cycles) {
      CycleTable::Row row = row_of(dialect, name, cycle);
      if (cycle.judged() + cycle.advised + cycle.known == 0) {
        const std::size_t cases =
            std::accumulate(row.cases.begin(), row.cases.end(), std::size_t{});
        table.others +=
            fmt::format("{}{} {}", table.others.empty() ? "" : ", ", name, grouped(cases));
        continue;
      }
      for (std::size_t i = 0; i < row.cases.size(); ++i) {
        table.used[i] = table.used[i] || row.cases[i] > 0 || i < 3;
      }
      table.rows.push_back(std::move(row));
    }
  }
  std::size_t features = 0;
  for (const auto& dialect : scope.features()) features += dialect.second.size();
  table.counts_otherwise = table.rows.size() > 1 || features > 1;
  std::ranges::sort(table.rows, [](const CycleTable::Row& a, const CycleTable::Row& b) {
    if (a.no_go() != b.no_go()) return a.no_go() > b.no_go();
    if (a.dialect != b.dialect) return a.dialect < b.dialect;
    return NaturalOrder()(a.cycle, b.cycle);
  });
  return table;
}

std::string CycleTable::name(const Row& row) const {
  const bool is_alone =
      std::ranges::all_of(rows, [&](const Row& other) { return other.dialect == row.dialect; });
  return is_alone ? row.cycle : fmt::format("{} of {}", row.cycle, row.dialect);
}

std::string CycleTable::text(std::size_t most) const {
  if (rows.empty()) return {};
  std::size_t width = std::string_view("cycle").size();
  for (const Row& row : rows) width = std::max(width, name(row).size());
  std::string text = fmt::format("  {:<{}}", "cycle", width);
  for (std::size_t i = 0; i < kColumns.size(); ++i) {
    if (used[i]) text += fmt::format("  {:>{}}", kColumns[i], width_of(i));
  }
  text += "\n";
  for (std::size_t shown = 0; shown < std::min(most, rows.size()); ++shown) {
    text += fmt::format("  {:<{}}", name(rows[shown]), width);
    for (std::size_t i = 0; i < kColumns.size(); ++i) {
      if (!used[i]) continue;
      text += fmt::format("  {:>{}}", grouped(rows[shown].cases[i]), width_of(i));
    }
    text += "\n";
  }
  if (rows.size() > most) text += fmt::format("  and {} more\n", rows.size() - most);
  if (!others.empty()) text += fmt::format("  nothing judged: {}\n", others);
  return counts_otherwise ? text + fmt::format("  {}\n", kCounting) : text;
}

}  // namespace gonogo::oracle
