// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/identify/outcome.hpp"

#include <fmt/format.h>

#include "oracle/differential/reference_run.hpp"

namespace gonogo::identify {

std::string KeptOutcome::text() const {
  std::string text;
  for (Record record : records) {
    record.clause = reference::kNoClause;
    append_json(record, text);
    text += '\n';
  }
  for (const reference::Alarm& alarm : admitted) {
    text += fmt::format("{} {} ", end.alarm.block, name(alarm.alarm));
  }
  return text + (not_covered ? "not covered" : "");
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
  using Ending = oracle::ReferenceRun::Ending;
  oracle::ReferenceRun run = oracle::run_reference(profile, program, most);
  if (run.ending == Ending::too_long || run.ending == Ending::undecided) return std::nullopt;
  return KeptOutcome{std::move(run.records), std::move(run.end), std::move(run.alarms),
                     run.ending == Ending::not_covered};
}

oracle::Verdict judge_kept(const Profile& profile, std::string_view program,
                           const oracle::Tolerances& tolerances, const KeptOutcome& outcome) {
  oracle::ProgramJudge judge(profile, program, tolerances);
  for (const Record& record : outcome.records) {
    if (!judge.record(record)) break;
  }
  return judge.finish(outcome.end);
}

}  // namespace gonogo::identify
