// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/differential/reference_run.hpp"

#include "oracle/steps/program_input.hpp"
#include "reference/expander.hpp"

namespace gonogo::oracle {

ReferenceRun run_reference(const reference::Profile& profile, std::string_view program,
                           std::size_t most_records) {
  using Ending = ReferenceRun::Ending;
  ReferenceRun run;
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  try {
    while (const reference::Item* item = expander.next()) {
      if (const auto* record = std::get_if<reference::Record>(item)) {
        run.records.push_back(*record);
      } else if (const auto* report = std::get_if<reference::AlarmReport>(item)) {
        run.alarms = report->alarms;
        run.end.kind = oracle::RunEnd::Kind::alarm;
        run.end.alarm.block = report->block;
        run.end.alarm.alarm_class = name(report->alarms.front().alarm);
      } else if (std::holds_alternative<reference::NotCovered>(*item)) {
        run.ending = Ending::not_covered;
      }
      if (run.records.size() > most_records) {
        run.ending = Ending::too_long;
        break;
      }
    }
  } catch (const exact::Undecided&) {
    run.ending = Ending::undecided;
  }
  return run;
}

oracle::Verdict judge_reference(const reference::Profile& profile, std::string_view program,
                                const ReferenceRun& run) {
  oracle::SubjectInfo subject;
  subject.features = {"blocks", "m"};
  oracle::Tolerances tolerances = make_tolerances(subject, profile);
  tolerances.strict = true;  // the reference departs from nothing of its own
  return judge_outcome(profile, program, tolerances, run.records, run.end).verdict;
}

}  // namespace gonogo::oracle
