// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/verify_footer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "campaign/encoding.hpp"
#include "campaign/results.hpp"
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
bool asks_by_default(const ResultsFacts& facts) {
  const Json& header = facts.header;
  const Json argv = header.value("argv", Json::array());
  const std::string spec = text_of(header.value("subject", Json::object()), "spec");
  return facts.footer.contains("fresh") && !facts.is_known && !asked_in(header).is_part() &&
         text_of(header, "known_failures").empty() && !spec.starts_with("capture:") &&
         !report::is_flag_set(argv, "--fail-fast") &&
         report::option_values(argv, "--write-known-failures").empty();
}

// How many fresh programs are wanted follows from the command line, else from the cases judged. A
// merge has no such command line.
void check_fresh(const ResultsFacts& facts, std::vector<std::string>& faults) {
  const Json argv = facts.header.value("argv", Json::array());
  const bool is_run = std::ranges::count(argv, Json("certify")) > 0;
  const auto asked = whole_numbers(report::option_values(argv, "--fresh"));
  const FreshCounts counts = fresh_from_json(facts.footer.value("fresh", Json::object()));
  if (facts.header.contains("shards")) {
    FreshCounts sum;
    for (const Json& shard : facts.header.at("shards")) {
      add_fresh(sum, fresh_from_json(shard.value("fresh", Json::object())));
    }
    if (sum != counts) {
      faults.emplace_back("The footer has other fresh programs than the shards of the header.");
    }
  }
  const bool is_none = !asked.empty() && asked.back() == "0";
  const bool are_asked = asked.empty() ? is_run && asks_by_default(facts) : !is_none;
  if (counts.empty() && are_asked && !facts.is_no_go && !facts.judged.empty()) {
    faults.push_back(
        fmt::format("The command line asks {} fresh programs, and the footer has none.",
                    asked.empty() ? "for" : asked.back()));
  }
  if (is_run && facts.is_no_go && !counts.empty()) {
    faults.emplace_back("The footer has fresh programs, but none are asked where a case is NO-GO.");
  }
  for (const auto& [dialect, count] : counts) {
    const auto judged = facts.judged.find(dialect);
    const std::string own = !asked.empty()                 ? asked.back()
                            : judged == facts.judged.end() ? "0"
                                                           : std::to_string(judged->second);
    const bool fits = count.judged <= count.programs && count.programs <= count.wanted;
    if (!fits || is_none || (is_run && std::to_string(count.wanted) != own)) {
      faults.push_back(fmt::format(
          "The footer has {} of {} fresh programs of {}, {} of them judged, but {} are due.",
          count.programs, count.wanted, dialect, count.judged, own));
    }
  }
}

}  // namespace

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
