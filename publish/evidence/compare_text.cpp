// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "campaign/encoding.hpp"
#include "publish/evidence/compare_parts.hpp"
#include "publish/evidence/run_state.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

std::string titles(const Comparison& comparison) {
  return fmt::format("{} before, {} now", run_title(comparison.old_header),
                     run_title(comparison.new_header));
}

std::string text_table(const Comparison& comparison) {
  std::string text = titles(comparison) + "\n";
  for (const std::string& note : comparison.notes) text += note + "\n";
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) == 0) continue;
    text += fmt::format("\n{}\n", names.title);
    for (const ChangedCase& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      text += fmt::format("  {:<28} {:<36} -> {}\n", changed.id, departure_words(changed.before),
                          departure_words(changed.after));
      const std::string message = text_of(changed.after, "message");
      if (names.change == Change::regression && !message.empty()) {
        text += fmt::format("  {:<28} {}\n", "", message);
      }
    }
  }
  text += text_ids("New cases", comparison.added, comparison.first_added);
  text += text_ids("Cases that are gone", comparison.gone, comparison.first_gone);
  return text + text_counts(comparison, counts_of(comparison));
}

std::string json_text(const Comparison& comparison) {
  Json root = {{"format", 1},
               {"old", comparison.old_header},
               {"new", comparison.new_header},
               {"notes", comparison.notes},
               {"counts", json_counts(comparison, counts_of(comparison))}};
  for (const ChangeNames& names : kChanges) {
    Json list = Json::array();
    for (const ChangedCase& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      list.push_back({{"id", changed.id},
                      {"dialect", changed.dialect},
                      {"cycle", changed.cycle},
                      {"old", changed.before},
                      {"new", changed.after}});
    }
    root[names.key] = std::move(list);
  }
  return json_document(std::move(root), comparison);
}

std::string markdown(const Comparison& comparison) {
  std::string text =
      fmt::format("# {}\n\n{}.\n\n", regressions_title(comparison.count(Change::regression)),
                  markdown_text(titles(comparison)));
  for (const std::string& note : comparison.notes) text += "- " + markdown_text(note) + "\n";
  text += markdown_counts(comparison, counts_of(comparison));
  for (const ChangeNames& names : kChanges) {
    if (comparison.count(names.change) == 0) continue;
    text += fmt::format("\n## {}\n\n| case | before | now | what was found |\n|---|---|---|---|\n",
                        names.title);
    for (const ChangedCase& changed : comparison.changed) {
      if (changed.change != names.change) continue;
      text += fmt::format("| {} | {} | {} | {} |\n", markdown_text(changed.id),
                          markdown_text(departure_words(changed.before)),
                          markdown_text(departure_words(changed.after)),
                          markdown_text(text_of(changed.after, "message")));
    }
  }
  return text + markdown_ids("New cases", comparison.added, comparison.first_added) +
         markdown_ids("Cases that are gone", comparison.gone, comparison.first_gone);
}

}  // namespace

std::string text_counts(const ComparedCases& cases, const ChangeCounts& counts) {
  std::string text = "\n";
  const auto line = [&](std::string_view what, std::uint64_t count) {
    text += fmt::format("{:<12} {:>8}\n", what, grouped(count));
  };
  for (std::size_t i = 0; i < kChanges.size(); ++i) line(kChanges[i].key, counts[i]);
  line("new", cases.added);
  line("gone", cases.gone);
  line("same", cases.same);
  return text;
}

Json json_counts(const ComparedCases& cases, const ChangeCounts& counts) {
  Json object;
  for (std::size_t i = 0; i < kChanges.size(); ++i) object[kChanges[i].key] = counts[i];
  object["new"] = cases.added;
  object["gone"] = cases.gone;
  object["same"] = cases.same;
  return object;
}

std::string markdown_counts(const ComparedCases& cases, const ChangeCounts& counts) {
  std::string text = "\n| | cases |\n|---|--:|\n";
  for (std::size_t i = 0; i < kChanges.size(); ++i) {
    text += fmt::format("| {} | {} |\n", kChanges[i].title, grouped(counts[i]));
  }
  return text + fmt::format("| New | {} |\n| Gone | {} |\n| The same | {} |\n",
                            grouped(cases.added), grouped(cases.gone), grouped(cases.same));
}

std::string regressions_title(std::uint64_t regressions) {
  return regressions == 0 ? "No regressions" : "Regressions: " + grouped(regressions);
}

std::string json_document(Json root, const ComparedCases& cases) {
  root["first_new"] = cases.first_added;
  root["first_gone"] = cases.first_gone;
  return dump(root, 1) + "\n";
}

std::string departure_words(const Json& part) {
  if (part.is_null()) return "-";
  std::string text = text_of(part, "verdict");
  if (const std::string clause = text_of(part, "clause"); !clause.empty()) text += " " + clause;
  if (const auto block = report::count_of(part, "b")) text += fmt::format(" line {}", *block);
  const Json deviation = part.value("deviation", Json::object());
  if (const std::string mm = text_of(deviation, "mm"); !mm.empty()) text += ", " + mm + " mm";
  return text;
}

std::string text_ids(std::string_view title, std::uint64_t count,
                     const std::vector<std::string>& first) {
  if (count == 0) return {};
  std::string text = fmt::format("\n{}\n", title);
  for (const std::string& id : first) text += fmt::format("  {}\n", id);
  if (count > first.size()) text += fmt::format("  and {} more\n", count - first.size());
  return text;
}

std::string markdown_ids(std::string_view title, std::uint64_t count,
                         const std::vector<std::string>& first) {
  constexpr std::size_t kShown = 50;
  if (count == 0) return {};
  std::string text = fmt::format("\n## {}\n\n", title);
  for (std::size_t i = 0; i < std::min(kShown, first.size()); ++i) {
    text += fmt::format("- {}\n", markdown_code(first[i]));
  }
  if (count > kShown) text += fmt::format("- and {} more\n", grouped(count - kShown));
  return text;
}

std::string comparison_text(const Comparison& comparison, CompareFormat format) {
  switch (format) {
    case CompareFormat::json:
      return json_text(comparison);
    case CompareFormat::markdown:
      return markdown(comparison);
    default:
      return text_table(comparison);
  }
}

}  // namespace gonogo::oracle::evidence
