// SPDX-License-Identifier: GPL-3.0-or-later
#include "publish/evidence/rejudge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "campaign/encoding.hpp"
#include "campaign/results_reader.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/finding_text.hpp"
#include "oracle/records/trace_reader.hpp"
#include "publish/report/case_paths.hpp"
#include "publish/report/json_value.hpp"
#include "reference/clause.hpp"

namespace gonogo::oracle::evidence {

using report::text_of;

namespace {

std::optional<Number> number_of(const Json& object, const char* key) {
  const std::string text = text_of(object, key);
  if (text.empty()) return std::nullopt;
  auto value = Number::parse(text);
  if (!value) throw ResultsError(fmt::format("The header's {} is no number: {}.", key, text));
  return value;
}

// Whether the end of the run is known: these departures are found in the motions, or at an end
// without alarm.
bool departs_in_motion(VerdictKind kind) {
  switch (kind) {
    case VerdictKind::fail_geometry:
    case VerdictKind::fail_order:
    case VerdictKind::fail_feed:
    case VerdictKind::fail_region:
    case VerdictKind::fail_overrun:
    case VerdictKind::fail_alarm_missing:
      return true;
    default:
      return false;
  }
}

bool departs_in_alarm(VerdictKind kind) {
  return kind == VerdictKind::fail_alarm_spurious || kind == VerdictKind::fail_alarm_class ||
         kind == VerdictKind::fail_alarm_late || kind == VerdictKind::unmapped_alarm;
}

struct Outcome {
  std::vector<reference::Record> records;
  RunEnd end;
};

// The outcome as far as the line holds it; nothing when that is not enough.
std::optional<Outcome> outcome_of(const Json& line, const CaseRow& row, VerdictKind departure) {
  if (line.value("notes", std::string()).starts_with(kSampledNote)) return std::nullopt;
  const Json trace = line.value("trace", Json::array());
  if (trace.size() >= kKeptRecords) return std::nullopt;
  Outcome outcome;
  TraceReader reader;
  bool has_alarm = false;
  auto take = [&](const std::string& text) {
    TraceLine read = reader.read(text);
    if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      outcome.end.kind = RunEnd::Kind::alarm;
      outcome.end.alarm = *alarm;
      has_alarm = true;
    } else if (auto* record = std::get_if<reference::Record>(&read)) {
      outcome.records.push_back(std::move(*record));
    } else {
      return false;
    }
    return true;
  };
  for (const Json& entry : trace) {
    if (!take(dump(entry))) return std::nullopt;
  }
  if (!departs_in_alarm(departure) || has_alarm) return outcome;
  // The alarm stands in what was got.
  const std::size_t records = outcome.records.size();
  if (!take(row.got) || outcome.records.size() != records) return std::nullopt;
  return outcome;
}

std::string differs(const CaseRow& row, std::string_view what, const std::string& was,
                    const std::string& is) {
  return fmt::format("{}: the {} was {}, but judged again it is {}.", row.id, what,
                     was.empty() ? "none" : was, is.empty() ? "none" : is);
}

// An advice departs from no text, and an xfail says nothing of one.
std::string basis_of(const CaseRow& row, const Verdict& now) {
  if (row.kind == VerdictKind::xfail) return {};
  if (now.kind == VerdictKind::advice) return "silent";
  if (decision(now.kind) != Decision::no_go || now.clause == reference::kNoClause) return {};
  return std::string(reference::name(reference::clause(now.clause).basis()));
}

// The campaign writes U+FFFD for bytes that are no UTF-8.
std::string as_written(const std::string& text) {
  return is_utf8(text) ? text : Json::parse(dump(Json(text))).get<std::string>();
}

bool is_message(const std::string& told, const std::string& now, const Wording& wording) {
  if (!told.starts_with(now)) return false;
  const std::string more = told.substr(now.size());
  return more.empty() || std::ranges::find(wording.additions, more) != wording.additions.end();
}

// In what the line says of the departure besides where it is.
std::string difference_in_words(const Json& line, const CaseRow& row, const Verdict& now,
                                const Wording& wording) {
  struct Text {
    const char* key;
    std::string is;
  };
  std::vector<Text> texts = {{"basis", basis_of(row, now)},
                             {"word", std::string(now.word.text())},
                             {"told_under", now.told_under},
                             {"feature", now.feature}};
  if (wording.has_rules) {
    texts.push_back({"rule", std::string(name(rule_of(now)))});
    texts.push_back({"gap", std::string(name(now.gap))});
  }
  for (const Text& text : texts) {
    const std::string was = text_of(line, text.key);
    if (was != text.is) return differs(row, text.key, was, text.is);
  }
  if (now.deviation_mm != row.deviation_mm) {
    return differs(row, "deviation in mm", row.deviation_mm, now.deviation_mm);
  }
  const Json witness = line.value("witness", Json());
  if (witness != (now.witness.empty() ? Json() : Json::parse(now.witness))) {
    return differs(row, "witness", witness.is_null() ? "" : dump(witness), now.witness);
  }
  const std::string message = as_written(now.message);
  if (!wording.is_own || is_message(row.message, message, wording)) return {};
  return differs(row, "message", row.message, message);
}

}  // namespace

std::string line_difference(const Json& line, const CaseRow& row, const Verdict& now,
                            const Wording& wording) {
  const bool is_known = row.kind == VerdictKind::xfail;
  const std::string verdict = is_known ? row.departure : std::string(row.verdict());
  if (name(now.kind) != verdict) {
    return differs(row, "verdict", verdict, std::string(name(now.kind)));
  }
  const std::string departure(now.departure ? name(*now.departure) : std::string_view());
  if (!is_known && departure != row.departure) {
    return differs(row, "departure", row.departure, departure);
  }
  const std::string clause(now.clause == reference::kNoClause ? ""
                                                              : reference::clause_name(now.clause));
  if (clause != row.clause) return differs(row, "clause", row.clause, clause);
  if (now.block != row.block.value_or(0)) {
    return differs(row, "line", std::to_string(row.block.value_or(0)), std::to_string(now.block));
  }
  const auto record = report::count_of(line, "record");
  if (now.record != record) {
    return differs(row, "record", record_number(record), record_number(now.record));
  }
  if (now.want != row.want) return differs(row, "motion wanted", row.want, now.want);
  if (now.got != row.got) return differs(row, "motion got", row.got, now.got);
  if (now.deviation_exact != row.deviation_exact) {
    return differs(row, "deviation", row.deviation_exact, now.deviation_exact);
  }
  return wording.holds_words ? difference_in_words(line, row, now, wording) : std::string();
}

RunTolerances run_tolerances(const Json& header) {
  RunTolerances tolerances;
  const Json subject = header.value("subject", Json::object());
  const Json numeric = subject.value("numeric", Json::object());
  tolerances.subject.name = text_of(subject, "name");
  tolerances.subject.version = text_of(subject, "version");
  if (const std::string kind = text_of(numeric, "kind"); !kind.empty()) {
    tolerances.subject.numeric_kind = kind;
    tolerances.subject.says_numeric = true;
  }
  tolerances.subject.resolution = number_of(numeric, "resolution");
  tolerances.subject.feed_resolution = number_of(numeric, "feed_resolution");
  tolerances.subject.chord = number_of(numeric, "chord");
  tolerances.subject.recorded = text_of(subject, "spec").starts_with("capture:");
  const Json dialects = subject.value("dialects", Json());
  tolerances.subject.everything = !dialects.is_object();
  if (dialects.is_object())
    tolerances.subject.dialects = dialects.get<decltype(SubjectInfo::dialects)>();
  for (const Json& feature : subject.value("features", Json::array())) {
    if (feature.is_string()) tolerances.subject.features.insert(feature.get<std::string>());
  }
  tolerances.grants = {number_of(header, "tolerance"), number_of(header, "chord"),
                       number_of(header, "feed_resolution"),
                       header.value("strict", Json(false)) == true};
  return tolerances;
}

Rejudged rejudge(const Json& line, const RunTolerances& tolerances, const Wording& wording) {
  const CaseRow row = case_row(line);
  const bool is_gap = row.kind == VerdictKind::oracle_gap;
  const bool passes = row.kind == VerdictKind::xpass;
  const VerdictKind departure =
      row.kind == VerdictKind::advice || row.kind == VerdictKind::xfail
          ? verdict_kind(row.departure).value_or(VerdictKind::oracle_error)
          : row.kind;
  const bool can_tell =
      is_gap || passes || departs_in_motion(departure) || departs_in_alarm(departure);
  if (!row.program || !can_tell) return {};
  const auto profile = report::case_profile(row.dialect, line.value("profile", Json::object()));
  if (const auto* fault = std::get_if<std::string>(&profile)) {
    return {true, fmt::format("{}: its profile cannot be read: {}", row.id, *fault)};
  }
  const auto outcome = outcome_of(line, row, departure);
  if (!outcome) return {};
  const auto& machine = std::get<reference::Profile>(profile);
  const Tolerances of_judge = make_tolerances(tolerances.subject, machine, tolerances.grants);
  const SessionVerdict now =
      judge_outcome(machine, *row.program, of_judge, outcome->records, outcome->end);
  // A pass that ended in an alarm has not kept it.
  if (passes) return {decision(now.verdict.kind) == Decision::go, {}};
  // How the run of a gap ended is unknown; a record that departs does so however it ended.
  const bool departs = now.verdict.record && decision(now.verdict.kind) == Decision::no_go;
  if (is_gap && now.verdict.kind != row.kind && !departs) return {};
  // What a gap says may hang on how the run ended.
  Wording held = wording;
  if (is_gap) held.has_rules = held.is_own = false;
  std::string fault = line_difference(line, row, now.verdict, held);
  // How a run went on after a departure is not in its line, and the reading may hang on it.
  if (fault.empty() && wording.holds_words && !row.reading.empty() &&
      explaining_reading(machine, *row.program, of_judge, outcome->records, outcome->end) !=
          row.reading) {
    return {};
  }
  return {true, std::move(fault)};
}

}  // namespace gonogo::oracle::evidence
