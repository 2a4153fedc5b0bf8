// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under which other reading a NO-GO would be GO.
#include <fmt/format.h>

#include <set>

#include "oracle/judge/judge_session.hpp"
#include "oracle/region/constants.hpp"

namespace gonogo::oracle {
namespace {

using reference::Reading;
using reference::ReadingKey;

// An alternative may lead to blocks that another one alarms before.
std::set<ReadingKey> touched_under_any(const reference::Profile& profile,
                                       const ProgramText& program, std::size_t most_items) {
  std::set<ReadingKey> touched;
  for (const reference::ReadingChoice& choice :
       assignments_of(profile, program, most_items).choices) {
    const std::vector<ReadingKey> keys =
        touched_by(with_readings(profile, choice), program, most_items);
    touched.insert(keys.begin(), keys.end());
  }
  return touched;
}

// The other values of a reading; none of an open one, under which all of them are admitted.
std::vector<std::string_view> other_values(const reference::Profile& profile,
                                           const Reading& reading) {
  std::vector<std::string_view> values;
  if (profile.readings.is(reading.key, "any")) return values;
  for (const std::string_view value : reading.alternatives) {
    if (!profile.readings.is(reading.key, value)) values.push_back(value);
  }
  if (reading.by_properties) values.emplace_back("any");  // more than the named ones
  return values;
}

}  // namespace

std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, const RecordSeries& records,
                               const RunEnd& end, std::size_t most_records) {
  // A program that goes on far beyond what the subject sent is looked at as far as that.
  const std::size_t most_items = kMostTimes * records.size() + kMostIdle;
  std::size_t cost = 0;
  for (const ReadingKey key : touched_under_any(profile, program, most_items)) {
    const Reading& reading = reference::reading(key);
    for (const std::string_view value : other_values(profile, reading)) {
      const reference::Profile other = with_reading(profile, key, value);
      cost +=
          assignments_of(other, program, most_items).choices.size() * (records.size() + kExpansion);
      if (cost > most_records) return {};
      const SessionVerdict session = judge_outcome(other, program, tolerances, records, end);
      if (decision(session.verdict.kind) == Decision::go) {
        return fmt::format("{}={}", reading.name, value);
      }
    }
  }
  return {};
}

std::string explaining_reading(const reference::Profile& profile, const ProgramText& program,
                               const Tolerances& tolerances, std::span<const Record> records,
                               const RunEnd& end, std::size_t most_records) {
  return explaining_reading(profile, program, tolerances, RecordsInMemory(records), end,
                            most_records);
}

}  // namespace gonogo::oracle
