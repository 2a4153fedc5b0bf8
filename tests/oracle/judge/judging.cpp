// SPDX-License-Identifier: GPL-3.0-or-later
#include "judging.hpp"

#include <sstream>
#include <stdexcept>

#include "oracle/trace_reader.hpp"

namespace gonogo::oracle {

Verdict judge_trace(std::string_view program, std::string_view trace, std::string_view reading) {
  reference::Profile profile;
  if (!reading.empty()) {
    const std::size_t equals = reading.find('=');
    if (set_reading(profile, reading.substr(0, equals), reading.substr(equals + 1))) {
      throw std::runtime_error("no such reading");
    }
  }
  SubjectInfo subject;
  subject.features = {"blocks"};
  const JudgeTerms terms = make_terms(subject, profile, std::nullopt, std::nullopt);
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
  return judge_outcome(profile, program, terms, records, end).verdict;
}

}  // namespace gonogo::oracle
