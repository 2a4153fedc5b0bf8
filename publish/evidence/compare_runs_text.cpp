// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "publish/evidence/compare_parts.hpp"
#include "publish/evidence/compare_runs.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

// The runs by number, for tables: "1  acme 3.1 (old/results.jsonl)".
std::vector<std::string> run_lines(const RunsComparison& comparison) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < comparison.paths.size(); ++i) {
    lines.push_back(fmt::format("{} {}{} ({})", i + 1, run_title(comparison.headers[i]),
                                i + 1 == comparison.paths.size() ? ", now" : "",
                                comparison.paths[i]));
  }
  return lines;
}

std::string lines_of_case(const CaseOfRuns& changed) {
  std::string text = fmt::format("  {}\n", changed.id);
  for (std::size_t i = 0; i < changed.runs.size(); ++i) {
    text += fmt::format("    {} {}\n", i + 1, departure_words(changed.runs[i]));
  }
  return text;
}

std::string runs_text(const RunsComparison& comparison) {
  std::string text;
  for (const std::string& line : run_lines(comparison)) text += line + "\n";
  for (const std::string& note : comparison.notes) text += note + "\n";
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) == 0) continue;
    text += fmt::format("\n{}\n", names.title);
    for (const CaseOfRuns& changed : comparison.changed) {
      if (changed.change == names.change) text += lines_of_case(changed);
    }
  }
  text += text_ids("New cases", comparison.added, comparison.first_added);
  text += text_ids("Cases that are gone", comparison.gone, comparison.first_gone);
  return text + text_counts(comparison, counts_of(comparison));
}

std::string runs_json(const RunsComparison& comparison) {
  Json root = {{"format", 1},
               {"runs", comparison.headers},
               {"notes", comparison.notes},
               {"counts", json_counts(comparison, counts_of(comparison))}};
  for (const ChangeNames& names : kChanges) {
    Json list = Json::array();
    for (const CaseOfRuns& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      list.push_back({{"id", changed.id},
                      {"dialect", changed.dialect},
                      {"cycle", changed.cycle},
                      {"runs", changed.runs}});
    }
    root[names.key] = std::move(list);
  }
  return json_document(std::move(root), comparison);
}

std::string runs_markdown(const RunsComparison& comparison) {
  std::string text =
      fmt::format("# {}\n\n", regressions_title(comparison.count(Change::regression)));
  for (const std::string& line : run_lines(comparison)) text += "- " + markdown_text(line) + "\n";
  for (const std::string& note : comparison.notes) text += "- " + markdown_text(note) + "\n";
  text += markdown_counts(comparison, counts_of(comparison));
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) == 0) continue;
    text += fmt::format("\n## {}\n\n| case |", names.title);
    std::string line = "|---|";
    for (std::size_t i = 0; i < comparison.paths.size(); ++i) {
      text += fmt::format(" {} |", i + 1);
      line += "---|";
    }
    text += "\n" + line + "\n";
    for (const CaseOfRuns& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      text += "| " + markdown_text(changed.id) + " |";
      for (const Json& run : changed.runs) text += " " + markdown_text(departure_words(run)) + " |";
      text += "\n";
    }
  }
  return text + markdown_ids("New cases", comparison.added, comparison.first_added) +
         markdown_ids("Cases that are gone", comparison.gone, comparison.first_gone);
}

}  // namespace

std::string runs_comparison_text(const RunsComparison& comparison, CompareFormat format) {
  switch (format) {
    case CompareFormat::json:
      return runs_json(comparison);
    case CompareFormat::markdown:
      return runs_markdown(comparison);
    default:
      return runs_text(comparison);
  }
}

}  // namespace gonogo::oracle::evidence
