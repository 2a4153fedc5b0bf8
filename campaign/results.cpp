// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign/results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "campaign/encoding.hpp"
#include "oracle/records/case_head.hpp"
#include "oracle/records/text.hpp"

namespace gonogo::oracle {

using Json = nlohmann::ordered_json;

namespace {

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

std::string text_in(const Json& object, const char* key) {
  auto found = object.find(key);
  return found != object.end() && found->is_string() ? visible(found->get<std::string>())
                                                     : std::string();
}

// Several cases, cycles and clauses stand there only where they were asked for.
Json selection_json(const ResultsHeader& header) {
  Json selection = {{"dialects", header.dialects}, {"only", header.only}};
  const bool is_one = header.cases.size() == 1;
  selection["case"] = is_one ? Json(header.cases.front()) : Json(nullptr);
  if (header.cases.size() > 1) selection["cases"] = header.cases;
  if (!header.cycles.empty()) selection["cycles"] = header.cycles;
  if (!header.clauses.empty()) selection["clauses"] = header.clauses;
  return selection;
}

}  // namespace

Json numeric_json(const SubjectInfo& subject) {
  Json numeric = Json::object();
  if (subject.says_numeric) numeric["kind"] = subject.numeric_kind;
  if (subject.resolution) numeric["resolution"] = subject.resolution->text();
  if (subject.feed_resolution) numeric["feed_resolution"] = subject.feed_resolution->text();
  if (subject.chord) numeric["chord"] = subject.chord->text();
  return numeric;
}

Json capped_json(const std::vector<std::pair<std::string, Capped>>& capped) {
  Json list = Json::array();
  for (const auto& [dialect, one] : capped) {
    list.push_back({{"dialect", dialect},
                    {"what", one.what},
                    {"declared", one.declared.text()},
                    {"counts", one.counts.text()}});
  }
  return list;
}

std::string header_line(const ResultsHeader& header) {
  // What it declares of each; null: nothing of any.
  const Json dialects = header.subject.everything ? Json(nullptr) : Json(header.subject.dialects);
  Json line;
  line["format"] = kResultsFormat;
  line["gonogo"] = header.version;
  line["gauge"] = {{"commit", text_or_null(header.commit)},
                   {"sha256", text_or_null(header.program_sha256)}};
  line["corpus"] = {{"version", header.corpus_version}, {"sha256", header.corpus_sha256}};
  line["subject"] = {{"spec", header.subject_spec},
                     {"name", header.subject.name},
                     {"version", header.subject.version},
                     {"dialects", dialects},
                     {"numeric", numeric_json(header.subject)},
                     {"features", header.subject.features}};
  line["profile"] = Json::parse(header.profile.empty() ? "{}" : header.profile);
  if (!header.machine.empty()) {
    line["machine"] = {{"dialect", header.machine}, {"sets", header.machine_keys}};
  }
  line["readings"] = header.readings;
  line["tolerance"] = text_or_null(header.tolerance);
  line["chord"] = text_or_null(header.chord);
  line["feed_resolution"] = text_or_null(header.feed_resolution);
  line["strict"] = header.strict;
  if (!header.sandbox.empty()) line["sandbox"] = header.sandbox;
  if (!header.blend.empty()) line["blend"] = header.blend;
  if (!header.feed_tolerance.empty()) line["feed_tolerance"] = header.feed_tolerance;
  if (header.show_ids) line["show_ids"] = true;
  line["capped"] = capped_json(header.capped);
  line["selection"] = selection_json(header);
  line["known_failures"] = text_or_null(header.known_failures_sha256);
  line["alarm_map"] = text_or_null(header.alarm_map_sha256);
  line["seed"] = header.seed;
  line["shard"] = header.shard;
  line["argv"] = header.argv;
  return dump(line);
}

Json coordinates_json(const std::map<std::string, RoundingCensus>& coordinates) {
  Json object = Json::object();
  for (const auto& [dialect, census] : coordinates) object[dialect] = census.json();
  return object;
}

std::string footer_line(const ResultsFooter& footer) {
  const RunAnswer& answer = footer.answer;
  Json line;
  line["decision"] = answer.decision;
  line["head"] = answer.head;
  line["totals"] = answer.totals;
  line["cases"] = answer.cases;
  line["judged"] = answer.judged;
  line["left_out"] = footer.left_out;
  line["assignments"] = answer.assignments;
  if (!answer.coordinates.empty()) line["coordinates"] = coordinates_json(answer.coordinates);
  line["stale"] = footer.stale;
  if (footer.unused_alarms) line["unused_alarms"] = *footer.unused_alarms;
  line["fresh"] = fresh_json(footer.fresh);
  line["sha256"] = footer.sha256;
  return dump(line);
}

namespace {

// What the readings of the run change a pass to, as text.
struct ReadingWords {
  std::string message;
  std::string departure;
};

ReadingWords reading_words(const Json& line, VerdictKind kind,
                           const std::optional<ReadingConflict>& conflict) {
  const std::string known = text_in(line.at("readings"), "known");
  const std::string failure(name(VerdictKind::fail_reading));
  const std::string message = conflict ? conflict->message : std::string();
  switch (kind) {
    case VerdictKind::fail_reading:
      return {message, {}};
    case VerdictKind::xfail:
      return {fmt::format("Known: {} ({}: {})", known, failure, message), failure};
    case VerdictKind::xpass:
      return {fmt::format("Known to fail with {} ({}), but it passes.", failure, known), {}};
    default:
      return {};
  }
}

}  // namespace

// A key that the reconciliation writes is none of a pass.
std::string reconciled_line(const std::string& line, VerdictKind kind,
                            const std::optional<ReadingConflict>& conflict, PassEvidence evidence) {
  const Json before = Json::parse(line);
  const ReadingWords words = reading_words(before, kind, conflict);
  const bool drops = decision(kind) == Decision::go && evidence == PassEvidence::drop;
  Json after;
  for (const auto& [key, value] : before.items()) {
    if (key == "message" || key == "departure") continue;
    if (drops && (key == "program" || key == "trace")) continue;
    const bool is_behind = key == "us" || key == "readings";  // a line of the hash has no time
    if (is_behind && !after.contains("message") && !words.message.empty()) {
      if (!words.departure.empty()) after["departure"] = words.departure;
      after["message"] = words.message;
    }
    after[key] = key == "verdict" ? Json(name(kind)) : value;
  }
  after["readings"].erase("against");
  if (conflict && !conflict->against.empty()) after["readings"]["against"] = conflict->against;
  return dump(after);
}

}  // namespace gonogo::oracle
