// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo fuzz: libFuzzer makes the programs, led by what they reach in a library that was built for
// it. It ends with the first finding, which is printed and kept as those of gonogo hunt.
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>

#include "cli/commands.hpp"
#include "cli/hunt_words.hpp"
#include "cli/output.hpp"
#include "fuzz/engine/fuzz_run.hpp"

namespace gonogo::cli {
namespace {

namespace fs = std::filesystem;

fuzz::FuzzOptions fuzz_options(const HuntWords& words, hunt::HuntOptions programs) {
  const HuntEnd end(words);
  fuzz::FuzzOptions options;
  options.subject = words.trial.subject;
  options.programs = std::move(programs);
  options.trial = trial_options(words.trial);
  options.stated = words.trial.limits.stated;
  options.most_programs = end.programs;
  options.most_seconds = static_cast<std::uint64_t>(end.time.count() / 1'000);
  const fs::path out = fs::absolute(words.trial.out);
  fs::create_directories(out / "inputs");
  options.inputs = (out / "inputs").string();
  options.last_input = (out / "last-input").string();
  options.log = (out / "engine.log").string();
  return options;
}

void show_fuzzing(const fuzz::FuzzCount& count) {
  static const bool kOnTerminal = ::isatty(STDERR_FILENO) == 1;
  if (kOnTerminal) draw("\r\033[K{} programs, {} judged", count.programs, count.judged);
}

// The program in a process of its own, as `gonogo hunt` tries it. What shows in the engine's
// process alone is a finding, too: there it ran after others.
std::optional<hunt::Finding> finding_in(hunt::Trial& trial, const fuzz::FuzzEnd& end) {
  if (!end.program) return std::nullopt;
  oracle::Verdict alone;
  std::optional<hunt::Finding> finding = hunt::finding_of(trial, *end.program, alone);
  if (finding) {
    hunt::reduce_finding(trial, *finding, {});
    return finding;
  }
  if (end.kind == fuzz::FuzzEnd::Kind::too_much) return std::nullopt;
  const bool departed = end.kind == fuzz::FuzzEnd::Kind::departed;
  alone.message =
      fmt::format("In the engine's process, after other programs, it {}; alone it is {}. {}",
                  departed ? "departs" : "broke down", oracle::name(alone.kind), end.how);
  alone.kind = departed ? oracle::VerdictKind::state_leak : oracle::VerdictKind::crash;
  const hunt::Signature signature{end.program->profile.dialect, alone.kind, {}, "fuzz", {}};
  return hunt::Finding{signature, alone, {{}, *end.program}};
}

std::string fuzz_summary(const HuntWords& words, const fuzz::FuzzCount& count) {
  return fmt::format(
      "{}, {}: {} programs from seed {} in {:.1f} s, the first after {:.1f} s; {} judged ({} with "
      "motion), {} skipped\n",
      words.trial.subject, words.dialect, count.programs, words.seed, count.seconds,
      count.first_after, count.judged, count.moved, count.skipped);
}

int tell_finding(const HuntWords& words, hunt::Trial& trial, hunt::Finding& finding,
                 std::uint64_t program) {
  finding.program = program;
  const std::string id =
      keep_finding(words.trial, static_cast<std::uint64_t>(words.seed), trial, finding);
  const std::string folder = fmt::format("{}/findings/{}", words.trial.out, id);
  Output output;
  output.text() = fmt::format("{}  {}\n{}", finding.signature.text(), folder,
                              finding_text(finding, reduce_command(folder, words.trial)));
  output.tell();
  const bool is_ours = finding.verdict.kind == oracle::VerdictKind::oracle_error;
  return is_ours ? kUndecided : kNoGo;
}

int tell_nothing(const fuzz::FuzzEnd& end, const fuzz::FuzzOptions& options) {
  const fuzz::FuzzCount& count = end.count;
  if (end.kind != fuzz::FuzzEnd::Kind::nothing) {
    complain("gonogo: {} No program that is NO-GO alone is known; see {}.\n", end.how, options.log);
    return kUndecided;
  }
  if (count.moved * 10 >= count.programs) return kGo;
  complain(
      "gonogo: only {} of {} programs moved the subject and were judged. That nothing was found in "
      "the others says nothing: declare what the subject does, or draw programs that it runs "
      "(--settings, --profile).\n",
      count.moved, count.programs);
  return kUndecided;
}

// The only dialect that the subject names, where none is given.
void name_dialect(HuntWords& words, const oracle::SubjectInfo& info) {
  if (words.dialect.empty() && words.profile.empty() && info.dialects.size() == 1) {
    words.dialect = info.dialects.begin()->first;
  }
}

int fuzz_subject(HuntWords words) {
  if (!fuzz::has_fuzz_engine()) {
    throw UsageError("This gonogo was built without libFuzzer. `gonogo hunt` tries programs, too.");
  }
  hunt::Trial trial(trial_subject(words.trial), trial_options(words.trial));
  name_dialect(words, trial.info());
  hunt::HuntOptions programs = hunt_options(words);
  words.dialect = programs.dialect;
  check_dialect(trial.info(), words.dialect);
  know_failures(words, programs);
  const fuzz::FuzzOptions options = fuzz_options(words, std::move(programs));
  const fuzz::FuzzEnd end = fuzz::run_fuzz_engine(options, show_fuzzing);
  if (::isatty(STDERR_FILENO) == 1) draw("\r\033[K");
  Output output;
  output.text() = fuzz_summary(words, end.count);
  output.tell();
  std::optional<hunt::Finding> finding;
  if (end.kind != fuzz::FuzzEnd::Kind::nothing) finding = finding_in(trial, end);
  if (!finding) return tell_nothing(end, options);
  return tell_finding(words, trial, *finding, end.count.programs);
}

}  // namespace

void add_fuzz(Command& program) {
  auto words = std::make_shared<HuntWords>();
  words->trial.out = "gonogo-fuzz";
  Command command = program.add_command(
      "fuzz", "Let libFuzzer look for a program on which a library departs or breaks down");
  add_trial_options(command, words->trial);
  command.option("--dialect", words->dialect, "dialect of the programs (the subject's only one)");
  add_program_options(command, *words);
  constexpr long kMost = std::numeric_limits<long>::max();
  command.number("--seed", words->seed, 1, 0xffff'ffff, "of the engine (1)");
  command.number("--programs", words->programs, 1, kMost, "how many programs");
  add_known_failures(command, words->known_failures, words->corpus);
  command.run([words] {
    words->trial.limits.stated = stated_machine({words->dialect, words->profile, words->readings});
    return fuzz_subject(*words);
  });
}

}  // namespace gonogo::cli
