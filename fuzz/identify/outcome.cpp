// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/outcome.hpp"

#include <fmt/format.h>

#include "oracle/judge/program_input.hpp"

namespace gonogo::identify {

using reference::Item;

std::string KeptOutcome::text() const {
  std::string text;
  for (Record record : records) {
    record.clause = reference::kNoClause;
    append_json(record, text);
    text += '\n';
  }
  return text + alarms + (not_covered ? "not covered" : "");
}

KeptOutcome run_subject(oracle::Subject& subject, std::string_view id, std::string_view program) {
  KeptOutcome outcome;
  outcome.end = subject.run(id, program, [&](const Record& record) {
    outcome.records.push_back(record);
    return outcome.records.size() < kMostRecords;
  });
  // One that goes on and on has answered: the judge finds what it did wrong.
  if (outcome.end.kind == oracle::RunEnd::Kind::stopped) {
    outcome.end.kind = oracle::RunEnd::Kind::ok;
  }
  return outcome;
}

std::optional<KeptOutcome> run_reference(const Profile& profile, std::string_view program,
                                         std::size_t most) {
  KeptOutcome outcome;
  oracle::ProgramInput input(program);
  reference::Expander expander(profile, input.lines, reference::OpenPaths::shown);
  try {
    while (const Item* item = expander.next()) {
      if (auto* record = std::get_if<Record>(item)) {
        outcome.records.push_back(*record);
      } else if (auto* report = std::get_if<reference::AlarmReport>(item)) {
        outcome.end.kind = oracle::RunEnd::Kind::alarm;
        outcome.end.alarm.block = report->block;
        outcome.end.alarm.alarm_class = name(report->alarms.front().alarm);
        for (const reference::Alarm& alarm : report->alarms) {
          outcome.alarms += fmt::format("{} {} ", report->block, name(alarm.alarm));
        }
      } else if (std::holds_alternative<reference::NotCovered>(*item)) {
        outcome.not_covered = true;
      }
      if (outcome.records.size() > most) return std::nullopt;
    }
  } catch (const exact::Undecided&) {
    return std::nullopt;
  }
  return outcome;
}

oracle::Verdict judge_kept(const Profile& profile, std::string_view program,
                           const oracle::JudgeTerms& terms, const KeptOutcome& outcome) {
  oracle::ProgramJudge judge(profile, program, terms);
  for (const Record& record : outcome.records) {
    if (!judge.record(record)) break;
  }
  return judge.finish(outcome.end);
}

}  // namespace gonogo::identify
