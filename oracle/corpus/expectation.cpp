// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the reference says of a program, as an expectation of the corpus.
#include <algorithm>

#include "grammar/line_source.hpp"
#include "oracle/corpus/corpus.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

using reference::AlarmReport;
using reference::NotCovered;
using reference::Record;

Expectation expectation_of(const reference::Profile& profile, std::string_view program) {
  grammar::MemorySource bytes(program);
  grammar::LineSource lines(bytes);
  reference::Expander expander(profile, lines, reference::OpenPaths::shown);
  Expectation expectation;
  while (const reference::Item* item = expander.next()) {
    if (auto* record = std::get_if<Record>(item)) {
      expectation.records.push_back(*record);
    } else if (auto* report = std::get_if<AlarmReport>(item)) {
      for (const reference::Alarm& alarm : report->alarms) {
        const ExpectedAlarm expected{alarm.alarm, report->block, alarm.word};
        if (std::ranges::find(expectation.alarms, expected) == expectation.alarms.end()) {
          expectation.alarms.push_back(expected);
        }
      }
    } else if (std::holds_alternative<NotCovered>(*item)) {
      expectation.not_covered = true;
    }
  }
  return expectation;
}

}  // namespace gonogo::oracle
