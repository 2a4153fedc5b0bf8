// SPDX-License-Identifier: GPL-3.0-or-later
#include "judging.hpp"

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

#include "oracle/records/trace_reader.hpp"

namespace gonogo::oracle {

Verdict judge_trace(std::string_view program, std::string_view trace, std::string_view reading) {
  Judging judging;
  judging.reading = reading;
  return judge_trace(program, trace, judging);
}

Verdict judge_trace(std::string_view program, std::string_view trace, const Judging& judging) {
  reference::Profile profile =
      std::get<reference::Profile>(reference::default_profile(judging.dialect));
  profile.readings = profile.readings.shown();
  // Texts of tests need not end as programs do.
  if (judging.dialect == "rs274" && set_reading(profile, "ngc.program-end", "free")) {
    throw std::runtime_error("no such reading");
  }
  const std::string_view reading = judging.reading;
  if (!reading.empty()) {
    const std::size_t equals = reading.find('=');
    if (set_reading(profile, reading.substr(0, equals), reading.substr(equals + 1))) {
      throw std::runtime_error("no such reading");
    }
  }
  if (!judging.tool.empty()) profile.tools["1"].radius = Number::parse(judging.tool).value();
  SubjectInfo subject;
  if (judging.blocks) subject.features.insert("blocks");
  if (judging.m) subject.features.insert("m");
  if (judging.binary64) subject.numeric_kind = "binary64";
  subject.says_numeric = judging.exact;
  if (!judging.resolution.empty()) subject.resolution = Number::parse(judging.resolution);
  Grants grants;
  if (!judging.chord.empty()) grants.chord = Number::parse(judging.chord);
  if (!judging.tolerance.empty()) grants.tolerance = Number::parse(judging.tolerance);
  Tolerances tolerances = make_tolerances(subject, profile, grants);
  tolerances.strict = judging.strict;
  TraceReader reader;
  std::vector<reference::Record> records;
  RunEnd end;
  std::istringstream lines{std::string(trace)};
  for (std::string line; std::getline(lines, line);) {
    TraceLine read = reader.read(line);
    if (auto* alarm = std::get_if<SubjectAlarm>(&read)) {
      end.kind = RunEnd::Kind::alarm;
      end.alarm = *alarm;
    } else if (auto* fault = std::get_if<TraceFault>(&read)) {
      throw std::runtime_error(fault->message);
    } else {
      records.push_back(std::get<reference::Record>(read));
    }
  }
  return judge_outcome(profile, program, tolerances, records, end).verdict;
}

std::string TraceText::axes(std::initializer_list<AxisTo> to) const {
  std::string text;
  for (const AxisTo& each : to) {
    text += fmt::format("{}\"{}\":\"{:.{}f}\"", text.empty() ? "" : ",", each.axis, each.value,
                        decimals_);
  }
  return "{" + text + "}";
}

TraceText& TraceText::rapid(std::initializer_list<AxisTo> to) {
  return line(fmt::format(R"({{"k":"rapid","b":{},"to":{}}})", block_, axes(to)));
}

TraceText& TraceText::feed(std::initializer_list<AxisTo> to) {
  return line(fmt::format(R"({{"k":"feed","b":{},"to":{},"f":"{}"}})", block_, axes(to), feed_));
}

TraceText& TraceText::arc(std::string_view plane, std::initializer_list<AxisTo> centre, int rot,
                          std::initializer_list<AxisTo> to) {
  return line(fmt::format(R"({{"k":"arc","b":{},"plane":"{}","c":{},"rot":{},"to":{},"f":"{}"}})",
                          block_, plane, axes(centre), rot, axes(to), feed_));
}

TraceText& TraceText::line(std::string_view json) {
  text_ += json;
  text_ += '\n';
  return *this;
}

TraceText& TraceText::decimals(int count) {
  decimals_ = count;
  return *this;
}

TraceText& TraceText::block(int block, double feed) {
  block_ = block;
  feed_ = feed;
  return *this;
}

}  // namespace gonogo::oracle
