// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/verdict_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <span>

#include "cli/terminal.hpp"
#include "oracle/records/cycle_table.hpp"
#include "oracle/records/finding_text.hpp"
#include "oracle/records/followed_readings.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/clauses.hpp"

namespace gonogo::cli {

using oracle::Decision;
using oracle::Verdict;

namespace {

std::string_view word(oracle::VerdictKind kind) {
  // In the order of Decision.
  constexpr std::array<std::string_view, oracle::kDecisions> kWords = {"GO", "NO-GO", "UNDECIDED",
                                                                       "not judged"};
  if (kind == oracle::VerdictKind::advice) return "ADVICE";
  return kWords[static_cast<std::size_t>(decision(kind))];
}

}  // namespace

std::string verdict_head(const Verdict& verdict) {
  const std::string departure =
      verdict.departure ? fmt::format(", {} if a text stated it", name(*verdict.departure)) : "";
  return fmt::format("{}: {}{}\n", word(verdict.kind), name(verdict.kind), departure);
}

std::string verdict_text(const Verdict& verdict, oracle::FindingFacts facts) {
  std::string properties;
  if (verdict.property_motions > 0 && decision(verdict.kind) == Decision::go) {
    properties = fmt::format("  properties {} motions are held to properties alone\n",
                             verdict.property_motions);
  }
  if (decision(verdict.kind) == Decision::go) facts.next.clear();
  facts.departure.clear();  // the head says it
  return verdict_head(verdict) + properties + finding_text(facts, "  ");
}

std::string answer_text(const relation::Answer& answer) {
  std::string text = fmt::format("{}: {}\n", word(answer.kind), name(answer.kind));
  auto put = [&](std::string_view what, std::string_view value) {
    if (!value.empty()) text += fmt::format("  {:<11}{}\n", what, value);
  };
  put("", answer.message);
  put("rule", name(answer.rule));
  put("reason", name(answer.gap));
  if (answer.clause != reference::kNoClause) {
    put("clause", reference::clause(answer.clause).id);
  }
  if (decision(answer.kind) == Decision::go) return text;
  put("record", oracle::record_number(answer.record));
  put("want", answer.want);
  put("got", answer.got);
  if (!answer.distance.empty()) put("distance", answer.distance + " mm");
  return text;
}

ExitCode exit_code_of(const oracle::Verdict& verdict) {
  if (verdict.kind == oracle::VerdictKind::advice) return kGo;  // J-RUN-04
  if (decision(verdict.kind) == Decision::go) return kGo;
  return decision(verdict.kind) == Decision::no_go ? kNoGo : kUndecided;
}

namespace {

// Findings that are shown with their evidence; of the others a line each.
constexpr std::size_t kShownFindings = 10;
constexpr std::size_t kShownIds = 3;
constexpr std::size_t kShownCycles = 20;
constexpr std::size_t kShownReasons = 5;    // for which a subject skips cases
constexpr std::size_t kMostOfReason = 100;  // bytes

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

using Numbers = std::map<std::string, std::size_t, oracle::NaturalOrder>;

// "g94 252, g90 12": those with most cases first; of more than `most` the number of the others.
// `colon`: behind each name, which is a sentence.
std::string numbers_text(const Numbers& numbers, std::size_t most, std::string_view colon = "") {
  std::vector<std::pair<std::string, std::size_t>> ordered(numbers.begin(), numbers.end());
  // By name where the numbers are the same; std::stable_sort warns under clang-19.
  std::ranges::sort(ordered, [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second > b.second : oracle::NaturalOrder()(a.first, b.first);
  });
  std::string text;
  std::size_t others = 0;
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    const auto& [name, cases] = ordered[i];
    if (i < most) {
      text += fmt::format("{}{}{} {}", i == 0 ? "" : ", ", name, colon, oracle::grouped(cases));
    } else {
      others += cases;
    }
  }
  return others == 0 ? text : text + ", other reasons " + oracle::grouped(others);
}

std::string finding_head(const oracle::Finding& finding) {
  if (finding.cases == 1) {
    return fmt::format("{} {}", finding.smallest.id, name(finding.shown.kind));
  }
  return finding.line();
}

std::string told_finding(const oracle::Finding& finding, const oracle::FindingFacts* smallest,
                         bool colour) {
  std::string text = in_tone(finding_head(finding), Tone::strong, colour) + "\n";
  if (smallest != nullptr) text += oracle::finding_text(*smallest, "  ");
  if (finding.cases == 1) return text + "\n";
  text += fmt::format(
      "  {:<10} {}\n", "cases of",
      numbers_text({finding.by_cycle.begin(), finding.by_cycle.end()}, oracle::RunScope::kAll));
  std::vector<std::string> others;
  for (const std::string& id : finding.first) {
    if (id != finding.smallest.id && others.size() < kShownIds) others.push_back(id);
  }
  return text + fmt::format("  {:<11}{}{}\n\n", "as well", fmt::join(others, ", "),
                            finding.cases > others.size() + 1 ? ", ..." : "");
}

// Each finding once, those of one cause below it.
std::string findings_text(const CampaignSummary& summary, bool colour) {
  std::string text;
  std::string cause;
  std::size_t shown = 0;
  std::size_t explained = 0;
  for (const oracle::Finding* finding : summary.findings.list(summary.order)) {
    if (!finding->cause.empty() && finding->cause.name != cause) {
      text += in_tone(finding->cause.text(), Tone::unsure, colour) + "\n";
    }
    cause = finding->cause.name;
    if (!finding->cause.empty()) ++explained;
    if (++shown > kShownFindings) {
      text += finding_head(*finding) + "\n";
      continue;
    }
    const auto smallest = summary.smallest.find(finding->number);
    text += told_finding(*finding, smallest == summary.smallest.end() ? nullptr : &smallest->second,
                         colour);
  }
  if (shown > kShownFindings) text += "\n";
  if (!summary.no_cause_because.empty()) {
    text += fmt::format("No cause was looked for: {}.\n\n", summary.no_cause_because);
  }
  if (summary.causes_asked > 0) {
    text += fmt::format(
        "A cause was looked for in {} of {} (--causes), and {}.{}\n\n", summary.causes_asked,
        oracle::counted(shown, "finding", "findings"),
        explained == 0 ? "none was found" : fmt::format("explains {} of them", explained),
        explained == shown ? ""
                           : " The rest may be two mistakes that meet, or one that is not tried: "
                             "mend the first finding and run again.");
  }
  return text;
}

// What a subject says of a skip, without the full stop.
std::string reason_text(std::string_view said) {
  while (said.ends_with('.')) said.remove_suffix(1);
  return oracle::excerpt(said, kMostOfReason);
}

// What the subject does not claim, dialect by dialect, feature by feature.
std::string not_claimed_text(const oracle::RunScope& scope) {
  struct Skips {
    std::size_t cases = 0;
    Numbers features;
    Numbers reasons;  // of the subject's own
  };
  std::map<std::string, Skips> by_dialect;
  for (const auto& [key, group] : scope.not_claimed()) {
    Skips& skips = by_dialect[key.dialect];
    skips.cases += group.cases;
    if (key.feature.empty()) {
      skips.reasons[reason_text(key.message)] += group.cases;
    } else {
      skips.features[key.feature] += group.cases;
    }
  }
  std::string text;
  for (const auto& [dialect, skips] : by_dialect) {
    const std::string reasons = numbers_text(skips.reasons, kShownReasons, ":");
    text += fmt::format("  not claimed of {}: {} ({}{}{})\n", dialect,
                        oracle::counted(skips.cases, "case", "cases"),
                        numbers_text(skips.features, oracle::RunScope::kAll),
                        skips.features.empty() || reasons.empty() ? "" : "; ", reasons);
  }
  return text;
}

}  // namespace

std::string summary_text(const CampaignSummary& summary, const std::string& subject, bool colour) {
  const oracle::RunAnswer& answer = summary.footer.answer;
  std::string text = findings_text(summary, colour);
  text += advices_text(answer.scope);
  text += fmt::format("{}: {} cases\n", subject, answer.cases);
  for (std::string_view verdict : oracle::verdict_names()) {
    auto total = answer.totals.find(std::string(verdict));
    if (total != answer.totals.end()) {
      text += fmt::format("  {:<20} {:>6}\n", verdict, total->second);
    }
  }
  text += not_claimed_text(answer.scope);
  const std::string followed = oracle::followed_readings(answer.assignments);
  if (!followed.empty()) text += fmt::format("  follows {}\n", followed);
  for (const auto& [dialect, census] : answer.coordinates) {
    text += fmt::format("  coordinates of {}: {}\n", dialect, census.text());
  }
  if (summary.run_again > 0) {
    text += fmt::format("  {} run more than twice, {}\n",
                        oracle::counted(summary.run_again, "case", "cases"),
                        oracle::counted(summary.further_runs, "further run", "further runs"));
  }
  if (summary.footer.left_out > 0) {
    text += fmt::format("  {} cases contradict the profile and were left out\n",
                        summary.footer.left_out);
  }
  for (const std::string& entry : summary.footer.stale) {
    text += fmt::format("  An entry of the subject's files is stale: {}\n", oracle::visible(entry));
  }
  if (!summary.complete) text += "  The run is incomplete.\n";
  if (!answer.hardly_answered.empty()) {
    text += fmt::format(
        "  Hardly any fresh program of {} was judged: that the cases of the corpus are GO does not "
        "show an interpreter. Declare the features that the subject has, or give --fresh 0.\n",
        answer.hardly_answered);
  }
  if (answer.judged_nothing) {
    text += "  There is a dialect in which no case was judged.\n";
  } else if (answer.no_go == 0 && !answer.scope.claims_every_dialect()) {
    text += "  There is a dialect of which no feature was judged for the most part.\n";
  }
  text += in_tone(answer.folded_head, tone_of(answer.decision), colour) + "\n";
  return text + oracle::cycle_table(answer.scope).text(kShownCycles);
}

}  // namespace gonogo::cli
