// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/markdown.hpp"

#include <fmt/format.h>

#include <array>

#include "oracle/records/finding_text.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/clauses.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

// In the order of Decision.
constexpr std::array<std::string_view, kDecisions> kDecisionWords = {"GO", "NO-GO", "undecided",
                                                                     "neither"};

std::string cases(std::size_t count) {
  return grouped(count) + (count == 1 ? " case" : " cases");
}

std::size_t unhit_clauses(const Json& summary) {
  std::size_t count = 0;
  for (const Json& clause : summary["catalog"]) {
    if (!summary["matrix"].contains(text_of(clause, "id"))) ++count;
  }
  return count;
}

std::string stale_list(const RunState& state) {
  if (state.stale.empty()) return {};
  std::string text = "\nStale entries of the subject's own files:\n\n";
  for (const std::string& entry : state.stale) text += "- " + markdown_code(entry) + "\n";
  return text;
}

// The cycles with what became of their cases, as of the summary; empty without any.
std::string cycles_table(const Json& cycles) {
  if (cycles["rows"].empty()) return {};
  std::string text = "| cycle |";
  std::string rule = "|---|";
  for (std::size_t i = 0; i < cycles["columns"].size(); ++i) {
    if (cycles["used"][i] == false) continue;
    text += fmt::format(" {} |", cycles["columns"][i].get<std::string>());
    rule += "--:|";
  }
  text += "\n" + rule + "\n";
  for (const Json& row : cycles["rows"]) {
    text += fmt::format("| {} |", markdown_text(text_of(row, "name")));
    for (std::size_t i = 0; i < row["cases"].size(); ++i) {
      if (cycles["used"][i] == true) {
        text += fmt::format(" {} |", grouped(row["cases"][i].get<std::size_t>()));
      }
    }
    text += "\n";
  }
  const std::string others = text_of(cycles, "others");
  return text + (others.empty() ? "" : "\nNothing judged: " + markdown_text(others) + ".\n") + "\n";
}

}  // namespace

std::string coordinates_list(const RunState& state) {
  std::string text;
  for (const auto& [dialect, of_it] : state.summary["coordinates"].items()) {
    text +=
        fmt::format("- {}: {}\n", markdown_text(dialect), markdown_text(of_it.get<std::string>()));
  }
  return text;
}

std::string totals_table(const Json& totals) {
  std::string text = "| verdict | decision | cases |\n|---|---|--:|\n";
  for (std::string_view verdict : verdict_names()) {
    const auto found = totals.find(std::string(verdict));
    if (found == totals.end()) continue;
    const auto its = static_cast<std::size_t>(decision(*verdict_kind(verdict)));
    text += fmt::format("| {} | {} | {} |\n", verdict, kDecisionWords[its],
                        grouped(found->get<std::size_t>()));
  }
  return text;
}

std::string not_checked_list(const RunState& state) {
  const Json& gaps = state.summary["notChecked"];
  std::string text =
      "- The way of a rapid between its ends: only its end is judged, and that every axis runs "
      "monotonically.\n";
  if (gaps["m"] == true) text += "- M functions: the subject does not declare `m`.\n";
  if (gaps["blocks"] == true) {
    text += "- The block that a motion comes from: the subject does not declare `blocks`.\n";
  }
  if (const std::size_t unhit = unhit_clauses(state.summary); unhit > 0) {
    text += fmt::format("- {} of {} clauses that no judged case hit.\n", grouped(unhit),
                        grouped(state.summary["catalog"].size()));
  }
  if (!gaps["open"].empty()) {
    text += fmt::format("- Other readings of {} clauses that the manuals leave open.\n",
                        grouped(gaps["open"].size()));
  }
  if (const auto undecided = state.summary["headline"]["undecided"].get<std::size_t>()) {
    text += fmt::format("- {} that the gauge could not decide.\n", cases(undecided));
  }
  for (const auto& [dialect, codes] : gaps["outside"].items()) {
    text += fmt::format("- {}: {} codes that the maker has and the gauge does not read.\n",
                        markdown_text(dialect), codes.size());
  }
  return text;
}

std::string not_claimed_list(const Json& scope) {
  std::string text;
  for (const Json& group : scope["not_claimed"]) {
    const std::string feature = text_of(group, "feature");
    const std::string reason = text_of(group, "reason");
    text += fmt::format("- {}: {} of {}\n",
                        markdown_text(!feature.empty() ? feature
                                      : reason.empty() ? "no reason given"
                                                       : reason),
                        cases(group["cases"].get<std::size_t>()),
                        markdown_text(text_of(group, "dialect")));
  }
  return text;
}

std::string declared_but_skipped_list(const Json& scope) {
  std::string text;
  for (const Json& group : scope["declared_but_skipped"]) {
    text += fmt::format("- {} of {}, {}: {} {}\n", markdown_text(text_of(group, "cycle")),
                        markdown_text(text_of(group, "dialect")),
                        cases(group["cases"].get<std::size_t>()),
                        markdown_text(text_of(group, "reason")), named_cases(group));
  }
  return text;
}

std::string advice_list(const Json& scope) {
  std::string text;
  for (const Json& group : scope["advices"]) {
    const std::string id = text_of(group, "clause");
    const reference::Clause* clause = report::find_clause(id);
    text += fmt::format(
        "- {}, would be {}, {}: {}{}\n", id.empty() ? "no clause" : markdown_code(id),
        markdown_text(text_of(group, "departure")), cases(group["cases"].get<std::size_t>()),
        clause == nullptr ? "" : markdown_text(clause->text) + " ", named_cases(group));
  }
  return text;
}

std::string named_cases(const Json& group) {
  std::string text;
  for (const Json& id : group["first_cases"]) {
    text += (text.empty() ? "" : ", ") + markdown_code(id.get<std::string>());
  }
  if (group["cases"].get<std::size_t>() > group["first_cases"].size()) text += ", ...";
  return text;
}

MarkdownSummary::MarkdownSummary(const Json& header) : header_(header) {}

void MarkdownSummary::add(const CaseRow& facts, const Finding* finding, bool is_smallest) {
  if (finding != nullptr && is_smallest) smallest_[finding->number] = facts;
}

std::string MarkdownSummary::failure(const CaseRow& facts) {
  using Form = FindingPart::Form;
  std::string text;
  for (const auto& [form, what, part] : finding_parts(facts)) {
    const bool is_fenced = form == Form::lines || form == Form::command;
    if (is_fenced) {
      text += (text.empty() ? "" : "\n") + markdown_fence(part) + "\n";
    } else {
      text += fmt::format("- {}{}{}\n", what, what.empty() ? "" : " ", markdown_text(part));
    }
  }
  return text;
}

// Each finding once, the first with the evidence of their smallest case.
std::string MarkdownSummary::findings(const RunState& state) const {
  std::string text;
  std::string cause;
  std::size_t shown = 0;
  for (const Json& finding : state.summary["findings"]) {
    if (shown == 0) text += "\n## Findings\n\n";
    if (const std::string own = text_of(finding, "cause"); !own.empty() && own != cause) {
      text += markdown_text(text_of(finding, "causeText")) + "\n\n";
    }
    cause = text_of(finding, "cause");
    const std::string line = markdown_text(text_of(finding, "line"));
    const auto smallest = smallest_.find(finding["number"].get<std::size_t>());
    if (++shown > kShown || smallest == smallest_.end()) {
      text += "- " + line + "\n";
    } else {
      text += "### " + line + "\n\n" + failure(smallest->second);
    }
  }
  return text;
}

std::string MarkdownSummary::head(const RunState& state) const {
  const Json subject = header_.value("subject", Json::object());
  const Json corpus = header_.value("corpus", Json::object());
  std::string text = fmt::format("# {}: {}\n\n**{}**\n\n", state.decision,
                                 markdown_text(state.subject), markdown_text(state.head));
  text += fmt::format(
      "Subject {}, gonogo {}, corpus {} ({})", markdown_code(text_of(subject, "spec")),
      markdown_text(text_of(header_, "gonogo")), markdown_text(text_of(corpus, "version")),
      markdown_code(text_of(corpus, "sha256").substr(0, 12)));
  const std::string shard = text_of(header_, "shard");
  if (!shard.empty() && shard != "1/1") text += ", shard " + markdown_text(shard);
  text += fmt::format(": {}.\n", cases(state.summary["headline"]["cases"].get<std::size_t>()));
  if (!state.unfinished.empty()) text += fmt::format("\n> **{}**\n", state.unfinished);
  return text;
}

std::string MarkdownSummary::text(const RunState& state) const {
  const Json& scope = state.summary["scope"];
  auto part = [](std::string_view title, const std::string& list) {
    return list.empty() ? list : fmt::format("\n## {}\n\n{}", title, list);
  };
  const std::string followed = markdown_text(text_of(state.summary, "follows"));
  return head(state) + "\n" + cycles_table(scope["cycles"]) +
         totals_table(state.summary["totals"]) +
         (followed.empty() ? "" : "\nEverything that passed follows " + followed + ".\n") +
         stale_list(state) + part(kCoordinatesTitle, coordinates_list(state)) +
         part("Declared, but skipped", declared_but_skipped_list(scope)) + findings(state) +
         part(kAdvicesTitle, advice_list(scope)) + part(kNotClaimedTitle, not_claimed_list(scope)) +
         "\n## What this run did not check\n\n" + not_checked_list(state);
}

}  // namespace gonogo::oracle::evidence
