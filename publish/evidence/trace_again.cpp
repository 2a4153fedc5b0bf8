// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <fstream>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "campaign/encoding.hpp"
#include "campaign/reading_tally.hpp"
#include "campaign/results_reader.hpp"
#include "oracle/judge/judge_session.hpp"
#include "oracle/records/input_file.hpp"
#include "oracle/records/trace_reader.hpp"
#include "oracle/steps/step_text.hpp"
#include "publish/evidence/rejudge.hpp"
#include "publish/evidence/verify_waivers.hpp"
#include "publish/report/json_value.hpp"

namespace gonogo::oracle::evidence {
namespace {

// How the trace ends as far as `take` says that it goes on.
RunEnd read_trace(const std::string& path,
                  const std::function<bool(const reference::Record&)>& take) {
  std::ifstream file = open_regular(path);
  file.exceptions(std::ios::badbit);  // what cannot be read is not the end of the trace
  TraceReader reader;
  RunEnd end;
  std::size_t number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    TraceLine read = reader.read(line);
    if (auto* record = std::get_if<reference::Record>(&read)) {
      if (!take(*record)) break;
    } else if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      end.kind = RunEnd::Kind::alarm;
      end.alarm = std::move(*alarm);
    } else {
      throw ResultsError(
          fmt::format("{}, line {}: {}", path, number, std::get<TraceFault>(read).message));
    }
  }
  return end;
}

// Whether another reading explains the departure, as the line says. A line that names none is not
// looked at: none is sought in a run that was stopped or is long.
std::string reading_fault(const CaseRow& row, const std::string& path, const Case& test,
                          const Tolerances& tolerances) {
  if (row.reading.empty()) return {};
  std::vector<reference::Record> records;
  const RunEnd end = read_trace(path, [&](const reference::Record& record) {
    records.push_back(record);
    return true;
  });
  const std::string reading =
      explaining_reading(test.profile, test.program, tolerances, records, end);
  if (reading == row.reading) return {};
  return fmt::format("{}: the reading was {}, but derived from the trace it is {}.", row.id,
                     row.reading, reading.empty() ? "none" : reading);
}

// What the line of a pass has that is none of a pass, or counts otherwise.
std::string pass_fault(const Json& line, const CaseRow& row, const Verdict& now,
                       const Wording& wording) {
  for (const char* key :
       {"rule", "gap", "departure", "clause", "basis", "reading", "told_under", "b", "record",
        "word", "want", "got", "deviation", "witness", "feature", "message", "known"}) {
    if (line.contains(key)) return fmt::format("{}: a pass has no {}.", row.id, key);
  }
  const auto told_census = line.find("coordinates");
  const auto was =
      told_census == line.end() ? std::nullopt : RoundingCensus::from_json(*told_census);
  if (was != now.coordinates) {
    return fmt::format("{}: the trace has other counts of coordinates than the line.", row.id);
  }
  const auto motions = report::count_of(line, "property_motions").value_or(0);
  if (!wording.has_rules || motions == now.property_motions) return {};
  return fmt::format("{}: the line says {} motions held to properties, but the trace has {}.",
                     row.id, motions, now.property_motions);
}

// Whether the line names the entry of the alarm map that the alarm at the end of the trace met.
std::string mapped_fault(const CaseRow& row, const std::string& told, const RunEnd& end,
                         const AlarmMap& alarms) {
  const bool is_alarm = end.kind == RunEnd::Kind::alarm;
  const AlarmMap::Entry* const entry = is_alarm ? alarms.entry_for(end.alarm.native) : nullptr;
  const std::string own = entry == nullptr ? std::string() : entry->native;
  if (told == own) return {};
  return fmt::format("{}: the entry of the alarm map was \"{}\", but by the trace it is \"{}\".",
                     row.id, told, own);
}

// In what the verdict of the trace differs from the line, apart from the reading that it names.
std::string verdict_fault(const Json& line, const CaseRow& row, const SessionVerdict& now,
                          const Wording& wording) {
  const VerdictKind told = told_kind(line, row);
  const VerdictKind kind = now.verdict.kind;
  const bool is_same = told == VerdictKind::xpass ? decision(kind) == Decision::go : told == kind;
  if (!is_same) {
    return fmt::format("{}: the verdict was {}, but derived from the trace it is {}. {}", row.id,
                       name(told), name(kind), now.verdict.message);
  }
  if (told != kind) return {};
  if (decision(kind) != Decision::go) return line_difference(line, row, now.verdict, wording);
  // Where the readings of the run make a pass none, its line says more.
  if (row.kind == kind) {
    std::string fault = pass_fault(line, row, now.verdict, wording);
    if (!fault.empty()) return fault;
  }
  const auto open = open_readings(now);
  const Json told_open = line.value("readings", Json::object()).value("open", Json::array());
  const bool is_open = line.contains("readings");
  if (wording.has_rules &&
      (is_open != open.has_value() || told_open != (open ? Json(open->open) : Json::array()))) {
    return fmt::format("{}: the trace leaves other readings open than the line says.", row.id);
  }
  const Json explaining = open ? Json(open->explaining) : Json::array();
  const Json was = line.value("readings", Json::object()).value("explaining", Json::array());
  if (was == explaining) return {};
  return fmt::format(
      "{}: the readings that explain it were {}, but derived from the trace they are {}.", row.id,
      dump(was), dump(explaining));
}

}  // namespace

VerdictKind told_kind(const Json& line, const CaseRow& row) {
  if (row.kind != VerdictKind::xfail || line.contains("readings")) return kind_before(line);
  return verdict_kind(row.departure).value_or(VerdictKind::oracle_error);
}

std::string trace_fault(const Json& line, const CaseRow& row, const std::string& path,
                        const Case& test, const Tolerances& tolerances, const AlarmMap& alarms,
                        const Wording& wording) {
  // The alarm map is about the end of the trace, the verdict often about less.
  const std::string mapped = report::text_of(line, "mapped");
  const bool needs_end = !mapped.empty() || !alarms.natives().empty();
  const bool has_trace = decision(row.kind) == Decision::go && line.contains("trace");
  Json sent = Json::array();
  JudgeSession session(test.profile, test.program, tolerances);
  bool is_open = true;
  const RunEnd end = read_trace(path, [&](const reference::Record& record) {
    if (has_trace && sent.size() < kKeptRecords) sent.push_back(Json::parse(record_text(record)));
    is_open = is_open && session.record(record);
    return is_open || needs_end;
  });
  const SessionVerdict now = session.finish(is_open ? end : RunEnd{});
  std::string fault = verdict_fault(line, row, now, wording);
  const bool departs =
      decision(now.verdict.kind) != Decision::go && told_kind(line, row) == now.verdict.kind;
  if (fault.empty() && departs) fault = reading_fault(row, path, test, tolerances);
  if (fault.empty() && has_trace && line["trace"] != sent) {
    fault = fmt::format("{}: the line has another trace than its file.", row.id);
  }
  if (!fault.empty() || !needs_end) return fault;
  return mapped_fault(row, mapped, end, alarms);
}

}  // namespace gonogo::oracle::evidence
