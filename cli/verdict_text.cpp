// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "oracle/judge/step_text.hpp"
#include "oracle/report/clauses.hpp"

namespace gonogo::cli {

using oracle::Decision;
using oracle::Verdict;

namespace {

std::string_view word(oracle::VerdictKind kind) {
  if (kind == oracle::VerdictKind::advice) return "ADVICE";
  switch (decision(kind)) {
    case Decision::go:
      return "GO";
    case Decision::no_go:
      return "NO-GO";
    case oracle::Decision::neither:
      return "not judged";
    case Decision::undecided:
      return "UNDECIDED";
  }
  return "";
}

// The evidence of a verdict, each line after the indent.
std::string evidence(const Verdict& verdict, std::string_view indent) {
  std::string text;
  auto put = [&](std::string_view what, const std::string& value) {
    if (!value.empty()) text += fmt::format("{}{:<11}{}\n", indent, what, value);
  };
  put("", verdict.message);
  if (verdict.property_motions > 0 && decision(verdict.kind) == Decision::go) {
    put("properties",
        fmt::format("{} motions are held to properties alone", verdict.property_motions));
  }
  if (verdict.clause != reference::kNoClause) {
    const reference::Clause& clause = reference::clause(verdict.clause);
    put("clause", fmt::format("{}: {}", clause.id, clause.text));
  }
  if (verdict.block != 0) put("line", std::to_string(verdict.block));
  if (verdict.record) put("record", std::to_string(*verdict.record));
  put("want", verdict.want);
  put("got", verdict.got);
  if (!verdict.deviation_exact.empty()) {
    const bool same = verdict.deviation_exact == verdict.deviation_mm;
    put("deviation",
        same ? verdict.deviation_mm + " mm"
             : fmt::format("{} = {} mm", verdict.deviation_exact, verdict.deviation_mm));
  }
  put("witness", oracle::point_for_people(verdict.witness));
  if (!verdict.reading.empty()) put("GO under", fmt::format("--reading {}", verdict.reading));
  return text;
}

}  // namespace

std::string verdict_text(const Verdict& verdict) {
  const std::string departure =
      verdict.departure ? fmt::format(", {} if a text stated it", name(*verdict.departure)) : "";
  return fmt::format("{}: {}{}\n{}", word(verdict.kind), name(verdict.kind), departure,
                     evidence(verdict, "  "));
}

ExitCode exit_code_of(const oracle::Verdict& verdict) {
  if (verdict.kind == oracle::VerdictKind::advice) return kGo;  // J-RUN-04
  switch (decision(verdict.kind)) {
    case oracle::Decision::go:
      return kGo;
    case oracle::Decision::no_go:
      return kNoGo;
    default:
      return kUndecided;
  }
}

namespace {

constexpr std::size_t kShownIds = 3;

// The advices by what they are about.
std::string advices_text(const oracle::RunScope& scope) {
  std::string text;
  for (const auto& [about, group] : scope.advices()) {
    const reference::Clause* clause = oracle::report::find_clause(about.clause);
    text += fmt::format(
        "advice: {} {}, {} {}: {}{}\n", about.clause, about.departure, oracle::grouped(group.cases),
        group.cases == 1 ? "case" : "cases",
        fmt::join(
            std::span(group.first).first(std::min<std::size_t>(kShownIds, group.first.size())),
            ", "),
        group.cases > kShownIds ? ", ..." : "");
    if (clause != nullptr)
      text += fmt::format("  {} No text of the manual says it.\n", clause->text);
  }
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string summary_text(const CampaignSummary& summary, const std::string& subject) {
  std::string text;
  std::size_t shown = 0;
  for (const oracle::CaseResult& failure : summary.failures) {
    if (shown++ == kShownFailures) {
      text += fmt::format("... and more; all are in the results and the report.\n\n");
      break;
    }
    text += fmt::format("{} {}\n{}\n", failure.id, name(failure.verdict.kind),
                        evidence(failure.verdict, "  "));
  }
  text += advices_text(summary.answer.scope);
  text += fmt::format("{}: {} cases\n", subject, summary.answer.cases);
  for (std::string_view verdict : oracle::verdict_names()) {
    auto total = summary.footer.totals.find(std::string(verdict));
    if (total != summary.footer.totals.end()) {
      text += fmt::format("  {:<20} {:>6}\n", verdict, total->second);
    }
  }
  for (const std::string& assignment : summary.footer.assignments) {
    text += fmt::format("  follows {}\n", assignment);
  }
  if (summary.footer.left_out > 0) {
    text += fmt::format("  {} cases contradict the profile and were left out\n",
                        summary.footer.left_out);
  }
  for (const std::string& entry : summary.footer.stale) {
    text += fmt::format("  An entry of the subject's files is stale: {}\n", entry);
  }
  if (!summary.complete) text += "  The run is incomplete.\n";
  if (summary.answer.judged_nothing) text += "  There is a dialect in which no case was judged.\n";
  text += summary.answer.head + "\n";
  return text;
}

}  // namespace gonogo::cli
