// SPDX-License-Identifier: GPL-3.0-or-later
#include "deciding.hpp"

#include <sstream>
#include <stdexcept>

#include "oracle/records/trace_reader.hpp"

namespace gonogo::relation {

Trace trace_of(std::string_view text) {
  oracle::TraceReader reader;
  Trace trace;
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(' ') == std::string::npos) continue;
    oracle::TraceLine read = reader.read(line);
    if (auto* alarm = std::get_if<oracle::SubjectAlarm>(&read)) {
      trace.end.kind = oracle::RunEnd::Kind::alarm;
      trace.end.alarm = *alarm;
    } else if (auto* fault = std::get_if<oracle::TraceFault>(&read)) {
      throw std::runtime_error(fault->message + " " + line);
    } else {
      trace.records.push_back(std::get<reference::Record>(read));
    }
  }
  return trace;
}

std::string text_of(const Trace& trace) {
  std::string text;
  for (const reference::Record& record : trace.records) {
    append_json(record, text);
    text += "\n";
  }
  if (trace.end.kind == oracle::RunEnd::Kind::alarm) {
    text += "alarm " + trace.end.alarm.alarm_class + " in line " +
            std::to_string(trace.end.alarm.block) + "\n";
  }
  return text;
}

Tolerances tolerances_of(const oracle::Tolerances& tolerances, const reference::Profile& profile) {
  Tolerances same;
  same.tolerance = tolerances.tolerance;
  same.increment = profile.resolution();
  same.chord = tolerances.chord;
  same.resolution = tolerances.resolution;
  same.feed_resolution = tolerances.feed_resolution;
  same.binary64 = tolerances.binary64;
  same.compare_blocks = tolerances.compare_blocks;
  same.compare_m = tolerances.compare_m;
  same.strict = tolerances.strict;
  return same;
}

namespace {

std::optional<Number> number_of(const std::string& text) {
  if (text.empty()) return std::nullopt;
  return Number::parse(text);
}

reference::Profile profile_of(const Declared& declared) {
  reference::Profile profile =
      std::get<reference::Profile>(reference::default_profile(declared.dialect));
  if (!declared.open) profile.readings = profile.readings.shown();
  if (!declared.reading.empty()) {
    const std::size_t equals = declared.reading.find('=');
    if (set_reading(profile, declared.reading.substr(0, equals),
                    declared.reading.substr(equals + 1))) {
      throw std::runtime_error("no such reading");
    }
  }
  if (!declared.tool.empty()) profile.tools["1"].radius = *number_of(declared.tool);
  if (declared.at_load) profile.alarm_timing = reference::AlarmTiming::program;
  return profile;
}

oracle::Tolerances tolerances_of(const Declared& declared, const reference::Profile& profile) {
  oracle::SubjectInfo subject;
  if (declared.blocks) subject.features.insert("blocks");
  if (declared.m) subject.features.insert("m");
  subject.resolution = number_of(declared.resolution);
  subject.feed_resolution = number_of(declared.feed_resolution);
  oracle::Grants grants;
  grants.tolerance = number_of(declared.tolerance);
  grants.chord = number_of(declared.chord);
  grants.strict = declared.strict;
  oracle::Tolerances tolerances = make_tolerances(subject, profile, grants);
  tolerances.exact = declared.exact;
  return tolerances;
}

}  // namespace

Answer decide(std::string_view program, std::string_view trace, const Declared& declared) {
  const reference::Profile profile = profile_of(declared);
  Tolerances tolerances = tolerances_of(tolerances_of(declared, profile), profile);
  tolerances.exact = declared.exact;
  const Trace read = trace_of(trace);
  return decide(profile, program, tolerances, read.outcome());
}

oracle::Verdict judge(std::string_view program, std::string_view trace, const Declared& declared) {
  const reference::Profile profile = profile_of(declared);
  const Trace read = trace_of(trace);
  return judge_outcome(profile, program, tolerances_of(declared, profile), read.records, read.end)
      .verdict;
}

}  // namespace gonogo::relation
