// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/tally.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "oracle/records/json_document.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {
namespace {

using simdjson::dom::object;

constexpr std::size_t kShownFeatures = 8;  // of a dialect, in the head line of a terminal

[[noreturn]] void fail(std::string_view line, std::string_view what) {
  throw std::runtime_error(fmt::format("{} is no case line: {}", excerpt(line), what));
}

std::string text_of(const object& source, const char* key) {
  std::string_view text;
  if (source[key].get(text) != simdjson::SUCCESS) return {};
  return std::string(text);
}

std::vector<std::string> texts_of(const object& source, const char* key) {
  std::vector<std::string> texts;
  simdjson::dom::array list;
  if (source[key].get(list) != simdjson::SUCCESS) return texts;
  for (auto item : list) {
    std::string_view text;
    if (item.get(text) == simdjson::SUCCESS) texts.emplace_back(text);
  }
  return texts;
}

VerdictKind verdict_of(const object& source, std::string_view line) {
  const std::string name = text_of(source, "verdict");
  const std::optional<VerdictKind> kind = verdict_kind(name);
  if (!kind) fail(line, fmt::format("\"{}\" is no verdict.", name));
  return *kind;
}

// Nearly always all are exact.
RoundingCensus coordinates_of(const object& source, std::string_view line) {
  RoundingCensus census;
  std::uint64_t exact = 0;
  if (source.size() == 1 && source["exact"].get(exact) == simdjson::SUCCESS) {
    census.take_exact(exact);
    return census;
  }
  const auto read =
      RoundingCensus::from_json(nlohmann::ordered_json::parse(simdjson::minify(source)));
  if (!read) fail(line, "Its coordinates are no count of them.");
  return *read;
}

}  // namespace

CaseFacts facts_of(std::string_view case_line) {
  static thread_local JsonDocument document;
  auto parsed = document.parse(case_line);
  if (auto* fault = std::get_if<JsonFault>(&parsed)) fail(case_line, fault->message);
  const object& source = std::get<object>(parsed);
  CaseFacts facts;
  read_case_head(case_line, facts.head);
  if (facts.head.id.empty() || facts.head.dialect.empty())
    fail(case_line, "It needs id and dialect.");
  facts.verdict = verdict_of(source, case_line);
  facts.mapped = text_of(source, "mapped");
  object coordinates;
  if (source["coordinates"].get(coordinates) == simdjson::SUCCESS) {
    facts.coordinates = coordinates_of(coordinates, case_line);
  }
  object readings;
  if (source["readings"].get(readings) == simdjson::SUCCESS) {
    facts.readings.emplace();
    facts.readings->open = texts_of(readings, "open");
    facts.readings->explaining = texts_of(readings, "explaining");
    facts.readings->verdict = verdict_of(readings, case_line);
    facts.readings->known = text_of(readings, "known");
    facts.verdict = facts.readings->verdict;
  }
  return facts;
}

VerdictKind Tally::add(const CaseFacts& facts) {
  VerdictKind kind = facts.verdict;
  conflict_.reset();
  if (facts.readings && decision(kind) == Decision::go) {
    conflict_ = readings_.add(facts.head.id, *facts.readings);
    const bool is_known = !facts.readings->known.empty();
    if (conflict_) {
      kind = is_known ? VerdictKind::xfail : VerdictKind::fail_reading;
      if (answer_.reading_conflict.empty()) answer_.reading_conflict = facts.head.id;
    } else if (is_known) {
      kind = VerdictKind::xpass;
    }
  }
  answer_.scope.add(facts.head, kind);
  ++answer_.cases;
  ++answer_.totals[std::string(name(kind))];
  std::size_t& judged = judged_by_dialect_[facts.head.dialect];
  const Decision answer = decision(kind);
  if (answer == Decision::no_go) ++answer_.no_go;
  if (answer == Decision::go && facts.coordinates) {
    answer_.coordinates[facts.head.dialect].add(*facts.coordinates);
  }
  if (kind == VerdictKind::oracle_error) ++answer_.oracle_errors;
  if (kind == VerdictKind::oracle_gap && !facts.head.expected) ++answer_.unexpected_gaps;
  if (is_judged(kind)) {
    ++answer_.judged;
    ++judged;
  }
  return kind;
}

RunAnswer Tally::finish(const std::vector<std::string>& stale,
                        const RunConditions& conditions) const {
  RunAnswer answer = answer_;
  answer.assignments = readings_.texts();
  if (conditions.fresh) answer.hardly_answered = hardly_answered(*conditions.fresh);
  answer.judged_nothing =
      judged_by_dialect_.empty() ||
      std::ranges::any_of(judged_by_dialect_, [](const auto& entry) { return entry.second == 0; });
  if (answer.no_go > 0 || !stale.empty()) {
    answer.exit_code = 1;
    answer.decision = "NO-GO";
  } else if (answer.judged_nothing || answer.oracle_errors > 0 || answer.unexpected_gaps > 0 ||
             !answer.hardly_answered.empty()) {
    // J-RUN-14.
    answer.exit_code = 3;
    answer.decision = "UNDECIDED";
  } else {
    answer.exit_code = 0;
    answer.decision = "GO";
  }
  const std::string granted = conditions.text();
  answer.head = answer.scope.head(answer.decision, RunScope::kAll, stale) + granted;
  answer.folded_head = answer.scope.head(answer.decision, kShownFeatures, stale) + granted;
  return answer;
}

}  // namespace gonogo::oracle
