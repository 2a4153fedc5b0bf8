// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo hunt --method operations: lists of machining operations, written for every dialect that
// the subjects have, with cycles and without. One path has to come of each, and none that is
// unsafe. The reference is not asked.
#include <fmt/format.h>

#include <filesystem>

#include "cli/exit_code.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "fuzz/hunt/operation_hunt.hpp"
#include "oracle/records/output_file.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;

hunt::OperationHunt operation_hunt(const HuntWords& words) {
  if (!words.profile.empty() || !words.readings.empty() || !words.settings.empty()) {
    throw UsageError(
        "Operations are written for each dialect's machine as it is: leave --profile, --reading "
        "and --settings out.");
  }
  const hunt::TrialOptions trial = trial_options(words.trial);
  hunt::OperationOptions options;
  options.seed = static_cast<std::uint64_t>(words.seed);
  options.tolerance = trial.grants.tolerance;
  options.run_limit = trial.run_limit;
  if (!words.dialect.empty()) {
    options.dialects.push_back(load_profile({words.dialect, "", {}}).dialect);
  }
  std::vector<hunt::OperationHunt::Named> subjects;
  subjects.push_back({words.trial.subject, trial_subject(words.trial)});
  for (const std::string& beside : words.beside) {
    TrialWords other = words.trial;
    other.subject = beside;
    subjects.push_back({beside, trial_subject(other)});
  }
  return {std::move(subjects), std::move(options)};
}

std::string written_text(const hunt::WrittenProgram& program) {
  return fmt::format("  {}, {}:\n{}", program.subject, program.way(), listed(program.text));
}

std::string text_of(const hunt::OperationFinding& finding) {
  std::string text;
  if (finding.breach) {
    const relations::Breach& breach = *finding.breach;
    text += fmt::format("  {}\n", sentence(breach.rule));
    if (breach.block != 0) text += fmt::format("  line       {}\n", breach.block);
    text += finding_line("motion", breach.record.empty() ? "the end" : breach.record);
    text += finding_line("at", breach.witness);
  } else if (finding.difference) {
    const relations::PathDifference& difference = *finding.difference;
    text += "  The same operations, written in another way, give the same path.\n";
    text += finding_line("motion", fmt::format("{}", difference.leg));
    text += finding_line("want", difference.want);
    text += finding_line("got", difference.got);
    text += written_text(*finding.first);
  } else {
    text += "  A program that is right in its dialect has an answer.\n";
    text += finding_line("got", finding.breakdown);
  }
  return text + written_text(finding.second);
}

// The programs and what is wrong, below --out.
void keep(const HuntWords& words, std::size_t number, const hunt::OperationFinding& finding) {
  if (words.trial.out.empty()) return;
  const fs::path folder =
      fs::path(words.trial.out) / "findings" / fmt::format("operations.{:06}", number);
  fs::create_directories(folder);
  oracle::write_file(folder / "program.nc", finding.second.text);
  if (finding.first) oracle::write_file(folder / "other.nc", finding.first->text);
  oracle::write_file(folder / "finding.txt", finding.signature() + "\n" + text_of(finding));
}

void report(const HuntWords& words, std::size_t number, const hunt::OperationFinding& finding) {
  Output output;
  output.text() = fmt::format("{}. {}\n{}", number, finding.signature(), text_of(finding));
  output.text() += fmt::format("  again: {} --programs {}\n\n", command_of(words), finding.number);
  output.tell();
}

}  // namespace

int hunt_operations(const HuntWords& words) {
  hunt::OperationHunt hunt = operation_hunt(words);
  if (hunt.ways().empty()) {
    throw UsageError(
        "The subject names no dialect that operations are written for. --dialect says which.");
  }
  const HuntEnd end(words);
  std::size_t findings = 0;
  bool complete = true;
  try {
    while (!end.reached(hunt.count().lists, findings)) {
      for (const hunt::OperationFinding& finding : hunt.step()) {
        keep(words, ++findings, finding);
        report(words, findings, finding);
      }
    }
  } catch (const oracle::SubjectUnusable& error) {
    complete = false;
    complain("gonogo: {}\n", error.what());
  }
  const hunt::OperationCount& count = hunt.count();
  Output output;
  output.text() = fmt::format(
      "{}: {} lists of operations from seed {}, {} programs answered, {} without an answer, {} "
      "pairs compared; {} findings{}\n",
      fmt::join(hunt.ways(), "; "), count.lists, words.seed, count.programs, count.skipped,
      count.pairs, findings, complete ? "" : "; the hunt is incomplete");
  output.tell();
  if (findings > 0) return kNoGo;
  return complete && count.programs > 0 ? kGo : kUndecided;
}

}  // namespace gonogo::cli
