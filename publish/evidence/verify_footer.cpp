// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "campaign/case_roll.hpp"
#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
#include "campaign/results_shape.hpp"
#include "campaign/selection.hpp"
#include "oracle/records/fresh_counts.hpp"
#include "publish/evidence/text.hpp"
#include "publish/report/command.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

using report::text_of;

// "5" of "05", as the command line reads it.
std::vector<std::string> whole_numbers(std::vector<std::string> words) {
  for (std::string& word : words) {
    const std::size_t last = word.empty() ? 0 : word.size() - 1;
    word.erase(0, std::min(word.find_first_not_of('0'), last));
  }
  return words;
}

// Whether a run that names no number asks some: a whole one that knows of no failure.
bool asks_by_default(const ResultsFacts& facts, const Json& argv) {
  const Json& header = facts.header;
  const std::string spec = text_of(header.value("subject", Json::object()), "spec");
  return std::ranges::count(argv, Json("certify")) > 0 && facts.footer.contains("fresh") &&
         !facts.is_known && !asked_in(header).is_part() && !facts.knows_failures &&
         !spec.starts_with("capture:") && !report::is_flag_set(argv, "--fail-fast") &&
         report::option_values(argv, "--write-known-failures").empty();
}

// The number of each dialect that a command line asks for, "0": none; empty: as many as cases were
// judged.
std::string asked_number(const ResultsFacts& facts, const Json& argv) {
  const auto named = whole_numbers(report::option_values(argv, "--fresh"));
  if (!named.empty()) return named.back();
  return asks_by_default(facts, argv) ? "" : "0";
}

// `judged`: cases by dialect; null: unknown, of a shard.
void check_counts(const FreshCounts& counts, const std::string& asked,
                  const std::map<std::string, std::size_t>* judged,
                  std::vector<std::string>& faults) {
  for (const auto& [dialect, count] : counts) {
    std::string due = asked.empty() ? std::to_string(count.wanted) : asked;
    if (asked.empty() && judged != nullptr) {
      const auto cases = judged->find(dialect);
      due = std::to_string(cases == judged->end() ? 0 : cases->second);
    }
    const bool fits = count.judged <= count.programs && count.programs <= count.wanted;
    if (fits && due != "0" && std::to_string(count.wanted) == due) continue;
    faults.push_back(fmt::format(
        "The footer has {} of {} fresh programs of {}, {} of them judged, but {} are due.",
        count.programs, count.wanted, dialect, count.judged, due));
  }
}

// How many fresh programs are wanted follows from the command line, else from the cases judged; of
// a merged run from those of its shards.
void check_fresh(const ResultsFacts& facts, std::vector<std::string>& faults) {
  const Json told = facts.footer.value("fresh", Json::object());
  const FreshCounts counts = fresh_from_json(told);
  if (fresh_json(counts) != told)
    faults.emplace_back("The fresh programs of the footer are not as a run writes them.");
  if (facts.header.contains("shards")) {
    FreshCounts sum;
    for (const Json& shard : facts.header.at("shards")) {
      const FreshCounts own = fresh_from_json(shard.value("fresh", Json::object()));
      add_fresh(sum, own);
      check_counts(own, asked_number(facts, shard.value("argv", Json::array())), nullptr, faults);
    }
    if (sum != counts) {
      faults.emplace_back("The footer has other fresh programs than the shards of the header.");
    }
    return;
  }
  const std::string asked = asked_number(facts, facts.header.value("argv", Json::array()));
  if (counts.empty() && asked != "0" && !facts.is_no_go && !facts.judged.empty()) {
    faults.push_back(
        fmt::format("The command line asks {} fresh programs, and the footer has none.",
                    asked.empty() ? "for" : asked));
  }
  if (facts.is_no_go && !counts.empty()) {
    faults.emplace_back("The footer has fresh programs, but none are asked where a case is NO-GO.");
  }
  check_counts(counts, asked, &facts.judged, faults);
}

}  // namespace

ResultsFacts read_results(const std::string& path) {
  ResultsReader reader(path);
  ResultsFacts facts;
  facts.header = reader.header();
  facts.knows_failures = !text_of(facts.header, "known_failures").empty();
  Tally tally(declared_in(facts.header));
  for (CaseHead head; reader.next(head);) {
    const CaseFacts line = facts_of(reader.text());
    if (!line.mapped.empty()) facts.mapped.insert(line.mapped);
    const VerdictKind kind = tally.add(line);
    if (!is_fresh(head.id)) {
      if (is_judged(line.verdict)) ++facts.judged[line.head.dialect];
      facts.is_no_go = facts.is_no_go || decision(line.verdict) == Decision::no_go;
      facts.is_known = facts.is_known || line.verdict == VerdictKind::xfail;
    }
    const std::string against = tally.conflict() ? tally.conflict()->against : std::string();
    if (!head.against.empty() && head.against != against) {
      facts.inconsistent.push_back(fmt::format(
          "{}: the line is held against {}, but by the readings of the whole run against {}.",
          head.id, head.against, against.empty() ? "none" : against));
    }
    if (name(kind) == head.verdict) continue;
    facts.inconsistent.push_back(
        fmt::format("{}: the line says {}, but with the readings of the whole run it is {}.",
                    head.id, head.verdict, name(kind)));
  }
  if (!reader.footer()) {
    throw ResultsError(fmt::format("{} has no footer: it is incomplete.", path));
  }
  facts.footer = *reader.footer();
  facts.answer = tally.finish(report::texts_of(facts.footer, "stale"),
                              conditions_of(facts.header, facts.footer));
  return facts;
}

void check_footer(const ResultsFacts& facts, Findings& findings) {
  std::vector<std::string> faults = facts.inconsistent;
  auto compare = [&](std::string_view what, const Json& told, const Json& own) {
    if (told == own) return;
    faults.push_back(fmt::format("The footer says {} {}, but the cases come to {}.", what,
                                 dump(told), dump(own)));
  };
  const Json& footer = facts.footer;
  compare("totals", footer.value("totals", Json(nullptr)), Json(facts.answer.totals));
  compare("judged", footer.value("judged", Json(nullptr)), Json(facts.answer.judged));
  compare("readings", footer.value("assignments", Json(nullptr)), Json(facts.answer.assignments));
  if (footer.contains("coordinates") || !facts.answer.coordinates.empty()) {
    compare("coordinates", footer.value("coordinates", Json(nullptr)),
            coordinates_json(facts.answer.coordinates));
  }
  compare("decision", footer.value("decision", Json(nullptr)), Json(facts.answer.decision));
  check_fresh(facts, faults);
  if (const std::string place = footer_surplus(footer); !place.empty()) {
    faults.push_back(fmt::format("A footer has no {}.", place));
  }
  if (footer.contains("head"))
    compare("head", footer.value("head", Json(nullptr)), Json(facts.answer.head));
  findings.add_list(faults,
                    fmt::format("Totals, readings and decision ({}) follow from the {} cases.",
                                facts.answer.decision, facts.answer.cases));
}

// Only a departure has a line.
void tell_fresh_programs(const ResultsFacts& facts, Findings& findings) {
  std::size_t programs = 0;
  for (const auto& [dialect, count] :
       fresh_from_json(facts.footer.value("fresh", Json::object()))) {
    programs += count.programs;
  }
  if (programs == 0) return;
  findings.add_open(fmt::format(
      "No line shows what the subject did with {} fresh programs. --subject runs them again.",
      grouped(programs)));
}

}  // namespace gonogo::oracle::evidence
