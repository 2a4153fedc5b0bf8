// SPDX-License-Identifier: GPL-3.0-or-later
//
// Of two runs the texts say what was before and what is now; more of them they number.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "campaign/encoding.hpp"
#include "publish/evidence/compare.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

using report::text_of;

// The changes in the order in which people need them.
struct ChangeNames {
  Change change;
  const char* key;
  std::string_view title;
};
constexpr std::array<ChangeNames, 4> kChanges = {{
    {Change::regression, "regressions",
     "Regressions (GO before and not GO now, or known to fail and otherwise now)"},
    {Change::departure, "departures", "Other departures (NO-GO before and now)"},
    {Change::verdict, "verdicts", "Other changes of the verdict"},
    {Change::mended, "mended", "Mended (NO-GO before, GO now)"},
}};
constexpr const char* kNewCases = "New cases";
constexpr const char* kGoneCases = "Cases that are gone";

// "1 acme 3.1 (old/results.jsonl)"; two runs have one line.
std::vector<std::string> run_lines(const Comparison& comparison) {
  const std::vector<Json>& headers = comparison.headers;
  if (headers.size() == 2) {
    return {fmt::format("{} before, {} now", run_title(headers[0]), run_title(headers[1]))};
  }
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < headers.size(); ++i) {
    lines.push_back(fmt::format("{} {}{} ({})", i + 1, run_title(headers[i]),
                                i + 1 == headers.size() ? ", now" : "", comparison.paths[i]));
  }
  return lines;
}

// "fail.geometry GSK-G94-02 line 5, 0.5 mm"; of null "-".
std::string departure_words(const Json& part) {
  if (part.is_null()) return "-";
  std::string text = text_of(part, "verdict");
  if (const std::string clause = text_of(part, "clause"); !clause.empty()) text += " " + clause;
  if (const auto block = report::count_of(part, "b")) text += fmt::format(" line {}", *block);
  const Json deviation = part.value("deviation", Json::object());
  if (const std::string mm = text_of(deviation, "mm"); !mm.empty()) text += ", " + mm + " mm";
  return text;
}

std::string lines_of_case(const ChangedCase& changed) {
  if (changed.runs.size() == 2) {
    const Json& now = changed.runs[1];
    const std::string text = fmt::format("  {:<28} {:<36} -> {}\n", changed.id,
                                         departure_words(changed.runs[0]), departure_words(now));
    const std::string message = text_of(now, "message");
    if (changed.change != Change::regression || message.empty()) return text;
    return text + fmt::format("  {:<28} {}\n", "", message);
  }
  std::string text = fmt::format("  {}\n", changed.id);
  for (std::size_t i = 0; i < changed.runs.size(); ++i) {
    text += fmt::format("    {} {}\n", i + 1, departure_words(changed.runs[i]));
  }
  return text;
}

std::string text_ids(std::string_view title, const CountedIds& ids) {
  if (ids.count == 0) return {};
  std::string text = fmt::format("\n{}\n", title);
  for (const std::string& id : ids.first) text += fmt::format("  {}\n", id);
  if (ids.count > ids.first.size()) {
    text += fmt::format("  and {} more\n", ids.count - ids.first.size());
  }
  return text;
}

std::string plain_text(const Comparison& comparison) {
  std::string text;
  for (const std::string& line : run_lines(comparison)) text += line + "\n";
  for (const std::string& note : comparison.notes) text += note + "\n";
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) == 0) continue;
    text += fmt::format("\n{}\n", names.title);
    for (const ChangedCase& changed : comparison.changed) {
      if (changed.change == names.change) text += lines_of_case(changed);
    }
  }
  text += text_ids(kNewCases, comparison.added) + text_ids(kGoneCases, comparison.gone) + "\n";
  const auto line = [&](std::string_view what, std::uint64_t count) {
    text += fmt::format("{:<12} {:>8}\n", what, grouped(count));
  };
  for (const ChangeNames& names : kChanges) line(names.key, comparison.count(names.change));
  line("new", comparison.added.count);
  line("gone", comparison.gone.count);
  line("same", comparison.same);
  return text;
}

Json counts_json(const Comparison& comparison) {
  Json counts;
  for (const ChangeNames& names : kChanges) counts[names.key] = comparison.count(names.change);
  counts["new"] = comparison.added.count;
  counts["gone"] = comparison.gone.count;
  counts["same"] = comparison.same;
  return counts;
}

// "old" and "new", or "runs".
void put_runs(Json& object, const std::vector<Json>& runs) {
  if (runs.size() == 2) {
    object["old"] = runs[0];
    object["new"] = runs[1];
  } else {
    object["runs"] = runs;
  }
}

std::string json_text(const Comparison& comparison) {
  Json root = {{"format", 1}};
  put_runs(root, comparison.headers);
  root["notes"] = comparison.notes;
  root["counts"] = counts_json(comparison);
  for (const ChangeNames& names : kChanges) {
    Json list = Json::array();
    for (const ChangedCase& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      Json one = {{"id", changed.id}, {"dialect", changed.dialect}, {"cycle", changed.cycle}};
      put_runs(one, changed.runs);
      list.push_back(std::move(one));
    }
    root[names.key] = std::move(list);
  }
  root["first_new"] = comparison.added.first;
  root["first_gone"] = comparison.gone.first;
  return dump(root, 1) + "\n";
}

std::string markdown_ids(std::string_view title, const CountedIds& ids) {
  constexpr std::size_t kShown = 50;
  if (ids.count == 0) return {};
  std::string text = fmt::format("\n## {}\n\n", title);
  for (std::size_t i = 0; i < std::min(kShown, ids.first.size()); ++i) {
    text += fmt::format("- {}\n", markdown_code(ids.first[i]));
  }
  if (ids.count > kShown) text += fmt::format("- and {} more\n", grouped(ids.count - kShown));
  return text;
}

std::string markdown_counts(const Comparison& comparison) {
  std::string text = "\n| | cases |\n|---|--:|\n";
  for (const ChangeNames& names : kChanges) {
    text += fmt::format("| {} | {} |\n", names.title, grouped(comparison.count(names.change)));
  }
  return text + fmt::format("| New | {} |\n| Gone | {} |\n| The same | {} |\n",
                            grouped(comparison.added.count), grouped(comparison.gone.count),
                            grouped(comparison.same));
}

// A table of the cases with one change.
std::string markdown_cases(const Comparison& comparison, const ChangeNames& names) {
  const bool are_two = comparison.headers.size() == 2;
  std::vector<std::string> columns = {"before", "now", "what was found"};
  if (!are_two) columns.clear();
  for (std::size_t i = 0; i < comparison.headers.size() && !are_two; ++i) {
    columns.push_back(std::to_string(i + 1));
  }
  std::string text = fmt::format("\n## {}\n\n| case |", names.title);
  std::string line = "|---|";
  for (const std::string& column : columns) {
    text += fmt::format(" {} |", column);
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const ChangedCase& changed : comparison.changed) {
    if (changed.change != names.change) continue;
    text += fmt::format("| {} |", markdown_text(changed.id));
    for (const Json& run : changed.runs) {
      text += fmt::format(" {} |", markdown_text(departure_words(run)));
    }
    if (are_two) text += fmt::format(" {} |", markdown_text(text_of(changed.runs[1], "message")));
    text += "\n";
  }
  return text;
}

std::string markdown(const Comparison& comparison) {
  const std::uint64_t regressions = comparison.count(Change::regression);
  std::string text = fmt::format(
      "# {}\n\n", regressions == 0 ? "No regressions" : "Regressions: " + grouped(regressions));
  const std::vector<std::string> runs = run_lines(comparison);
  if (runs.size() == 1) {
    text += markdown_text(runs.front()) + ".\n\n";
  } else {
    for (const std::string& run : runs) text += "- " + markdown_text(run) + "\n";
  }
  for (const std::string& note : comparison.notes) text += "- " + markdown_text(note) + "\n";
  text += markdown_counts(comparison);
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) > 0) text += markdown_cases(comparison, names);
  }
  return text + markdown_ids(kNewCases, comparison.added) +
         markdown_ids(kGoneCases, comparison.gone);
}

}  // namespace

std::string comparison_text(const Comparison& comparison, CompareFormat format) {
  switch (format) {
    case CompareFormat::json:
      return json_text(comparison);
    case CompareFormat::markdown:
      return markdown(comparison);
    default:
      return plain_text(comparison);
  }
}

}  // namespace gonogo::oracle::evidence
