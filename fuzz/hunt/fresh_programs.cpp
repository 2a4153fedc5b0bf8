// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/hunt/fresh_programs.hpp"

#include "oracle/steps/step_text.hpp"

namespace gonogo::hunt {
namespace {

// The finding as a campaign has it of a case.
oracle::CaseResult result_of(const Finding& finding, const JudgedRun& shown,
                             const oracle::Case& test) {
  oracle::CaseResult result;
  result.id = test.id;
  result.dialect = test.dialect;
  result.cycle = test.cycle;
  result.features = test.features;
  result.clauses = test.clauses;
  // What came of several runs is not what the last one shows.
  const bool is_leak = finding.signature.kind == oracle::VerdictKind::state_leak;
  result.verdict = is_leak ? finding.verdict : shown.verdict;
  result.profile = reference::profile_json(test.profile);
  result.program = test.program;
  result.notes = shown.end.notes;
  const bool is_cut = shown.end.kind == oracle::RunEnd::Kind::timeout ||
                      shown.end.kind == oracle::RunEnd::Kind::out_of_memory;
  if (is_cut) return result;
  for (const reference::Record& record : shown.records) {
    result.trace.push_back(oracle::record_text(record));
  }
  return result;
}

}  // namespace

FreshAnswers ask_fresh(const SubjectMaker& maker, const FreshOptions& options,
                       const std::string& folder, Provenance provenance) {
  using Clock = std::chrono::steady_clock;
  const Clock::time_point end = Clock::now() + options.time;
  Hunt hunt(maker, options.trial, options.hunt);
  std::optional<Finding> finding;
  while (!finding && hunt.count().programs < options.programs && Clock::now() < end) {
    finding = hunt.step();
    if (options.progress) options.progress(hunt.count().programs);
  }
  FreshAnswers answers;
  answers.count = {options.programs, hunt.count().programs, hunt.count().judged};
  if (!finding) return answers;
  hunt.reduce(*finding, {});
  const JudgedRun shown = hunt.trial().examine(finding->reproducer);
  provenance.room = oracle::kFreshRoom;
  oracle::Case test = case_of(*finding, hunt.trial().info(), provenance);
  test.id = write_finding(folder, *finding, shown, hunt.trial().info(), provenance);
  answers.departure = result_of(*finding, shown, test);
  return answers;
}

}  // namespace gonogo::hunt
