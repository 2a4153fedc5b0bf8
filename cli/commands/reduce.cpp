// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo reduce: the smallest program that still departs in the same way.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "cli/trial_options.hpp"
#include "cli/verdict_text.hpp"
#include "fuzz/hunt/profile_parts.hpp"
#include "fuzz/program/in_force.hpp"
#include "fuzz/program/text.hpp"
#include "oracle/records/run_scope.hpp"

namespace gonogo::cli {
namespace {

struct ReduceWords {
  TrialWords trial;
  std::string program;
  ProfileOptions profile;
};

// What the options say of the machine stays as it is.
hunt::GivenMachine given_machine(const ProfileOptions& options) {
  hunt::GivenMachine given;
  if (!options.file.empty()) given.profile = load_profile(options);
  given.readings = readings_of(options.readings);
  return given;
}

int reduce(const ReduceWords& words) {
  constexpr std::size_t kMostRecords = 200'000;
  const generate::GeneratedProgram program{load_profile(words.profile), read_file(words.program)};
  TrialWords told = words.trial;
  told.limits.stated.profile = program.profile;
  hunt::TrialOptions options = trial_options(told);
  options.most_records = kMostRecords;
  hunt::Trial trial(trial_subject(told), std::move(options));
  check_dialect(trial.info(), program.profile.dialect);
  oracle::Verdict verdict;
  std::optional<hunt::Finding> finding = hunt::finding_of(trial, program, verdict);
  if (!finding) {
    complain("{}There is nothing to reduce.\n",
             verdict_text(verdict, oracle::finding_facts(verdict)));
    return exit_code_of(verdict);
  }
  const hunt::GivenMachine given = given_machine(words.profile);
  hunt::reduce_finding(trial, *finding, {},
                       [&](const hunt::Reproducer& reproducer) { return given.is_in(reproducer); });
  const std::string id = keep_finding(words.trial, 0, trial, *finding);
  const generate::GeneratedProgram& reduced = finding->reproducer.program;
  oracle::FindingFacts facts = oracle::finding_facts(finding->verdict);
  facts.blocks = oracle::marked_blocks(reduced.text, finding->verdict.block);
  facts.in_force = program::in_force_text(reduced.profile, reduced.text, facts.block.value_or(0));
  complain(
      "{}profile    {}\n{} of {}, after {}{}{}\n", verdict_text(finding->verdict, std::move(facts)),
      reference::profile_json(reduced.profile),
      oracle::counted(program::count_blocks(reduced.text), "block", "blocks"),
      program::count_blocks(program.text), oracle::counted(finding->reduce_runs, "run", "runs"),
      finding->is_reduced ? "" : "; it may become smaller still",
      id.empty() ? "" : fmt::format("; {}/findings/{}", words.trial.out, id));
  Output output;
  output.text() = reduced.text;
  output.flush();
  return exit_code_of(finding->verdict);
}

}  // namespace

void add_reduce(Command& program) {
  auto words = std::make_shared<ReduceWords>();
  Command command = program.add_command(
      "reduce", "The smallest program on which a subject departs in the same way");
  command.needed("program", words->program, "NC program, or - for standard input");
  add_trial_options(command, words->trial);
  add_profile_options(command, words->profile);
  command.run([words] { return reduce(*words); });
}

}  // namespace gonogo::cli
