// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo certify: a subject against the corpus. Without a subject, the main job: the built-in
// expanders, the checked-in corpus, a report.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <system_error>

#include "cli/certify_options.hpp"
#include "cli/certify_run.hpp"
#include "cli/certify_selection.hpp"
#include "cli/commands.hpp"
#include "cli/named_files.hpp"
#include "cli/options.hpp"
#include "cli/subjects.hpp"
#include "expanders/registry.hpp"
#include "publish/report/command.hpp"

namespace gonogo::cli {
namespace {

// A few cases do not go where a campaign is, unless they are sent there.
std::string report_folder(const CertifyOptions& options) {
  if (!options.report.empty()) return options.report;
  return options.cases.empty() ? oracle::report::kReportFolder : oracle::report::kFewCasesFolder;
}

// The options, narrowed to the dialects that a built-in expander has; nothing when none is left.
std::optional<CertifyOptions> with_own_dialects(const CertifyOptions& options,
                                                const std::string& subject) {
  CertifyOptions own = options;
  own.dialects.clear();
  for (const std::string& dialect : declared_dialects(subject_maker(subject, {}))) {
    const bool asked = options.dialects.empty() ||
                       std::ranges::find(options.dialects, dialect) != options.dialects.end();
    if (asked) own.dialects.push_back(dialect);
  }
  if (own.dialects.empty()) return std::nullopt;
  return own;
}

// Each below a folder of its own.
CertifyOptions below(const CertifyOptions& options, const std::string& name) {
  CertifyOptions own = options;
  if (!own.certificate.empty()) own.certificate += "/" + name;
  if (!own.traces.empty()) own.traces += "/" + name;
  return own;
}

// A typo in the last of several subjects is told before the first is run. A library is looked at
// in its own sandbox alone.
void check_subjects(const std::vector<std::string>& subjects) {
  for (const std::string& subject : subjects) {
    if (!subject.starts_with("lib:")) subject_maker(subject, {});
  }
}

// Several subjects one after the other: the answer is the gravest.
int certify_each(const CertifyOptions& options, const std::string& report) {
  check_subjects(options.subjects);
  int exit_code = kGo;
  std::set<std::string> names;
  for (const std::string& subject : options.subjects) {
    std::string name = oracle::report::subject_folder(subject);
    while (!names.insert(name).second) name += "-again";
    const int one = certify_one(below(options, name), subject, fmt::format("{}/{}", report, name));
    if (one == kNoGo || exit_code == kGo) exit_code = one;
  }
  return exit_code;
}

// The main job: every built-in expander that has a case, each with its own report.
int certify_built_in(const CertifyOptions& options, const std::string& report) {
  const oracle::Corpus corpus(corpus_folder(options.corpus));
  check_cycles(options, corpus);
  std::optional<int> exit_code;
  for (std::string_view name : expanders::names()) {
    const std::string subject = fmt::format("builtin:{}", name);
    std::optional<CertifyOptions> own = with_own_dialects(options, subject);
    if (!own || !take_own_cases(*own, corpus)) continue;
    own = below(*own, std::string(name));
    const int one = certify_one(*own, subject, fmt::format("{}/{}", report, name));
    if (one == kNoGo || exit_code.value_or(kGo) == kGo) exit_code = one;
  }
  if (exit_code) return *exit_code;
  check_cases(options.cases, corpus);
  throw UsageError(none_selected(corpus));
}

// Short enough to be typed again. GONOGO_SEED in the environment stands for a drawn one where a run
// has to be the same again, as in tests; results then say `--seed`, as if it had been typed.
void draw_seed(CertifyOptions& options) {
  constexpr unsigned kMost = 1'000'000'000;
  const char* const named = std::getenv("GONOGO_SEED");
  if (named == nullptr || *named == '\0') {
    options.seed = static_cast<long>(std::random_device()() % (kMost - 1)) + 1;
    return;
  }
  const std::string_view text = named;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), options.seed);
  if (error != std::errc{} || end != text.end() || options.seed < 0) {
    throw UsageError(fmt::format("GONOGO_SEED is \"{}\" and not a whole number.", text));
  }
  options.argv.insert(options.argv.end(), {"--seed", std::to_string(options.seed)});
}

}  // namespace

int certify(const CertifyOptions& asked) {
  CertifyOptions options = with_failed_cases(asked);
  if (options.seed < 0) draw_seed(options);
  check_clauses(options);
  check_readings(options);
  check_capture_options(options.limits, options.subjects);
  if (options.fail_fast && !options.certificate.empty()) {
    throw UsageError("A certificate is of a whole run: leave --fail-fast or --certificate out.");
  }
  if (!options.write_known_failures.empty() && options.subjects.size() != 1) {
    throw UsageError("--write-known-failures is of one subject: name it with --subject.");
  }
  if (!options.write_known_failures.empty() && (options.shard != "1/1" || options.fail_fast)) {
    throw UsageError(
        "--write-known-failures takes a run that ends: leave --shard and --fail-fast out.");
  }
  check_vectors(options);
  const std::string report = report_folder(options);
  if (options.subjects.size() == 1) return certify_one(options, options.subjects.front(), report);
  if (!options.subjects.empty()) return certify_each(options, report);
  return certify_built_in(options, report);
}

void add_certify(Command& program) {
  auto options = std::make_shared<CertifyOptions>();
  Command command = program.add_command("certify", "Judge a subject with the corpus");
  command.repeated_option(
      "--subject", options->subjects,
      "builtin:NAME[+FAULT], pipe:COMMAND, oneshot:COMMAND, lib:PATH.so or capture:DIR");
  command.repeated_option("--dialect", options->dialects, "only this dialect");
  command.option("--corpus", options->corpus, "folder of the corpus (the checked-in one)");
  command.option("--report", options->report,
                 "folder for results and report (report; of a few cases: again)");
  command.option("--certificate", options->certificate, "folder for a certificate as well");
  command.option("--traces", options->traces,
                 "folder for what the subject sends for each case, as capture:DIR reads it");
  command.option("--profile", options->profile, "the machine's profile");
  command.repeated_option("--reading", options->readings, "one reading as key=value");
  command.repeated_option("--only", options->only, "only ids that match the glob");
  command.repeated_option("--case", options->cases, "only this case");
  command.option("--failed-of", options->failed_of,
                 "only the cases that are findings of these results, a file or its folder; without "
                 "--subject of its built-in subject");
  command.repeated_option("--cycle", options->cycles, "only cases of this cycle, as g94");
  command.repeated_option("--clause", options->clauses, "only cases that test this clause");
  command.option("--shard", options->shard, "part i of n: i/n");
  command.number(
      "--seed", options->seed, 0, std::numeric_limits<long>::max(),
      "of the order of the cases (drawn anew) and of the fresh programs; 0: cases in the "
      "order of the corpus");
  command.number("--fresh", options->fresh, 0, 100'000'000,
                 "programs of each dialect that are in no corpus (as many as cases were judged)");
  command.number("--jobs", options->jobs, 1, 256, "subjects that run at the same time");
  command.number("--causes", options->causes, 0, 1000,
                 "findings of which the likely cause is looked for (3)");
  command.choice("--order", options->order, {"gravity", "cycle"},
                 "the order in which findings are told (gravity)");
  command.option("--known-failures", options->known_failures,
                 "TOML file of cases that the subject is known to fail");
  command.option("--write-known-failures", options->write_known_failures,
                 "write what failed to this TOML file, and prune what is no longer true");
  command.option("--alarm-map", options->alarm_map,
                 "TOML file of what the subject's own alarms mean");
  command.flag("--resume", options->resume,
               "go on from the journal of an interrupted run in the same folder");
  command.flag("--fail-fast", options->fail_fast, "stop at the first NO-GO");
  add_subject_options(command, options->limits);
  add_sandbox_options(command, options->limits.sandbox, "auto");
  command.flag("--show-ids", options->limits.show_ids,
               "tell a subject behind a pipe the names of the cases, to find a fault");
  add_strict_option(command, options->limits);
  options->argv = arguments();
  command.run([options] { return certify(*options); });
}

}  // namespace gonogo::cli
