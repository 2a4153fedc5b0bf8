// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle/differential/differential.hpp"

#include <fmt/format.h>

#include "oracle/differential/reference_run.hpp"

namespace gonogo::oracle {

std::optional<oracle::Verdict> run_and_judge(oracle::Subject& subject,
                                             const reference::Profile& profile,
                                             std::string_view program, std::size_t most_records) {
  oracle::Tolerances tolerances = make_tolerances(subject.info(), profile);
  tolerances.strict = true;  // two readings of our own agree where no text says anything, too
  oracle::JudgeSession session(profile, program, tolerances);
  subject.configure(profile);
  std::size_t records = 0;
  bool too_long = false;
  const oracle::RunEnd end = subject.run("generated", program, [&](const oracle::Record& record) {
    if (!session.record(record)) return false;
    too_long = ++records > most_records;
    return !too_long;
  });
  if (too_long) return std::nullopt;
  return session.finish(end).verdict;
}

RunEnd run_alone(oracle::Subject& subject, const reference::Profile& profile,
                 std::string_view program, std::size_t most_records) {
  subject.configure(profile);
  std::size_t records = 0;
  return subject.run("generated", program,
                     [&](const oracle::Record&) { return ++records <= most_records; });
}

bool contradicts_itself(const reference::Profile& profile, std::string_view program,
                        std::size_t most_records) {
  const ReferenceRun run = run_reference(profile, program, most_records);
  return run.is_told() &&
         oracle::decision(judge_reference(profile, program, run).kind) == oracle::Decision::no_go;
}

std::string trace_text(oracle::Subject& subject, const reference::Profile& profile,
                       std::string_view program) {
  constexpr std::size_t kMost = 10'000;  // a faulty subject may never end
  std::string text;
  std::size_t records = 0;
  subject.configure(profile);
  subject.run("generated", program, [&](const oracle::Record& record) {
    append_json(record, text);
    text += '\n';
    return ++records < kMost;
  });
  return text;
}

std::string failure_text(const oracle::Verdict& verdict, const reference::Profile& profile,
                         std::string_view program) {
  return fmt::format(
      "verdict: {}\n{}\nclause: {}\nline: {}\nwant: {}\ngot: {}\nwitness: {}\nprofile: {}\n"
      "program:\n{}",
      name(verdict.kind), verdict.message, reference::clause_name(verdict.clause), verdict.block,
      verdict.want, verdict.got, verdict.witness, reference::profile_json(profile), program);
}

std::string profile_text(const reference::Profile& profile) {
  const std::string keys = reference::profile_json(profile);
  return fmt::format("{{\"dialect\":\"{}\"{}{}\n", profile.dialect, keys == "{}" ? "" : ",",
                     keys.substr(1));
}

}  // namespace gonogo::oracle
