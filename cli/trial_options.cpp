// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trial_options.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

#include "cli/program_file.hpp"
#include "cli/subjects.hpp"
#include "cli/verdict_text.hpp"
#include "cli/version.hpp"
#include "fuzz/hunt/finding_files.hpp"
#include "fuzz/program/in_force.hpp"

namespace gonogo::cli {

void add_tried_subject(Command& command, TrialWords& words) {
  command.needed("--subject", words.subject,
                 "builtin:NAME[+FAULT], pipe:COMMAND, oneshot:COMMAND or lib:PATH.so");
  command.option("--alarm-map", words.alarm_map, "TOML file of what the subject's own alarms mean");
}

void add_trial_options(Command& command, TrialWords& words) {
  add_tried_subject(command, words);
  command.option("--out", words.out, "folder for findings as vectors and files");
  add_run_options(command, words.limits);
  add_sandbox_options(command, words.limits.sandbox, "off");
}

namespace {

// Noticed at the first finding it would be too late.
void check_out(const TrialWords& words) {
  namespace fs = std::filesystem;
  fs::path place = fs::absolute(words.out);
  while (!fs::exists(place) && place.has_relative_path()) place = place.parent_path();
  std::error_code fault;
  if (fs::is_directory(place) && ::access(place.c_str(), W_OK) == 0) {
    // A place such as /proc takes no folder, though it seems so.
    fs::create_directories(words.out, fault);
    if (!fault) return;
  }
  throw UsageError(fmt::format("--out {}: no folder can be made there.", words.out));
}

}  // namespace

hunt::SubjectMaker trial_subject(const TrialWords& words) {
  if (words.subject.starts_with("capture:")) {
    throw UsageError(
        "Recorded output cannot be tried with other programs. `gonogo certify` judges it.");
  }
  if (!words.out.empty()) check_out(words);
  return subject_maker(words.subject, sandboxed(words.limits.limits(), words.limits.sandbox,
                                                words.subject, {words.out}));
}

hunt::TrialOptions trial_options(const TrialWords& words) {
  hunt::TrialOptions options;
  options.grants = words.limits.grants();
  options.run_limit = words.limits.limits().run;
  options.alarm_map = load_alarm_map(words.alarm_map);
  return options;
}

void check_dialect(const oracle::SubjectInfo& info, const std::string& dialect) {
  if (info.everything || info.dialects.contains(dialect)) return;
  std::string known;
  for (const auto& [name, features] : info.dialects) {
    known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
  }
  throw UsageError(fmt::format("The subject does not name the dialect {}. It names: {}.", dialect,
                               known.empty() ? "none" : known));
}

std::string keep_finding(const TrialWords& words, std::uint64_t seed, hunt::Trial& trial,
                         const hunt::Finding& finding) {
  if (words.out.empty()) return {};
  const hunt::Provenance provenance{fmt::format("gonogo {}", kVersion), words.subject, seed};
  return hunt::write_finding(words.out, finding, trial.examine(finding.reproducer), trial.info(),
                             provenance);
}

std::string finding_text(const hunt::Finding& finding, std::string next) {
  std::string text = verdict_head(finding.verdict);
  for (const generate::GeneratedProgram& program : finding.reproducer.before) {
    text += oracle::marked_program(program.text, 0) + "  before:\n";
  }
  const generate::GeneratedProgram& program = finding.reproducer.program;
  oracle::FindingFacts facts = oracle::finding_facts(finding.verdict);
  facts.profile = reference::profile_json(program.profile);
  facts.blocks = oracle::marked_program(program.text, finding.verdict.block);
  facts.in_force = program::in_force_text(program.profile, program.text, facts.block.value_or(0));
  facts.departure.clear();  // the head says it
  facts.next = std::move(next);
  return text + oracle::finding_text(facts, "  ");
}

}  // namespace gonogo::cli
