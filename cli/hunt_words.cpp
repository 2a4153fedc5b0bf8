// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/hunt_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <limits>

#include "cli/named_files.hpp"
#include "cli/output.hpp"
#include "cli/subjects.hpp"
#include "fuzz/hunt/known_signatures.hpp"
#include "oracle/records/text.hpp"
#include "publish/report/command.hpp"

namespace gonogo::cli {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

// "90", "90s", "10m", "2h". Throws UsageError.
std::chrono::milliseconds time_of(const std::string& text) {
  long count = 0;
  char unit = 's';
  char rest = 0;
  const int fields = std::sscanf(text.c_str(), "%9ld%c%c", &count, &unit, &rest);
  const long seconds = unit == 's' ? 1 : unit == 'm' ? 60 : unit == 'h' ? 3600 : 0;
  if (fields < 1 || fields > 2 || count < 1 || seconds == 0) {
    throw UsageError(fmt::format("--time {} is no time. Write seconds, or 90s, 10m, 2h.", text));
  }
  return std::chrono::seconds(count * seconds);
}

}  // namespace

std::vector<std::pair<reference::ReadingKey, std::string>> readings_of(
    const std::vector<std::string>& choices) {
  std::vector<std::pair<reference::ReadingKey, std::string>> readings;
  for (const std::string& choice : choices) {
    const std::size_t equals = choice.find('=');
    const reference::Reading* reading = reference::find_reading(choice.substr(0, equals));
    readings.emplace_back(reading->key, choice.substr(equals + 1));
  }
  return readings;
}

std::string tolerances_of(const LimitOptions& limits) {
  std::string words;
  if (!limits.tolerance.empty()) words += " --tolerance " + limits.tolerance;
  if (!limits.chord.empty()) words += " --chord " + limits.chord;
  if (!limits.feed_resolution.empty()) words += " --feed-resolution " + limits.feed_resolution;
  return words;
}

std::string command_of(const HuntWords& words) {
  std::string command = fmt::format("{} hunt --subject {}", oracle::report::program_word(),
                                    oracle::shell_quoted(words.trial.subject));
  const auto add = [&command](std::string_view option, const std::string& value) {
    if (!value.empty()) command += fmt::format(" {} {}", option, oracle::shell_quoted(value));
  };
  for (const std::string& beside : words.beside) add("--beside", beside);
  if (!words.dialect.empty()) command += " --dialect " + words.dialect;
  command += fmt::format(" --seed {}", words.seed);
  if (words.method != "reference") command += " --method " + words.method;
  add("--profile", words.profile);
  for (const std::string& reading : words.readings) add("--reading", reading);
  add("--alarm-map", words.trial.alarm_map);
  command += tolerances_of(words.trial.limits);
  if (!words.settings.empty()) command += " --settings " + words.settings;
  if (words.everywhere) command += " --everywhere";
  add("--known-failures", words.known_failures);
  add("--corpus", words.corpus);
  return command;
}

std::string reduce_command(const std::string& folder, const TrialWords& words) {
  return fmt::format("{} reduce {} --subject {} --profile {}{}", oracle::report::program_word(),
                     oracle::shell_quoted(folder + "/program.nc"),
                     oracle::shell_quoted(words.subject),
                     oracle::shell_quoted(folder + "/profile.json"), tolerances_of(words.limits));
}

std::string listed(const std::string& program) {
  std::string text;
  std::size_t begin = 0;
  while (begin < program.size()) {
    const std::size_t end = std::min(program.find('\n', begin), program.size());
    text += "    " + oracle::readable(program.substr(begin, end - begin)) + "\n";
    begin = end + 1;
  }
  return text;
}

std::string finding_line(std::string_view name, const std::string& value) {
  return fmt::format("  {:<11}{}\n", name, value.empty() ? "nothing" : value);
}

bool HuntEnd::is_broken_off() const {
  return interrupted != 0;
}

HuntEnd::HuntEnd(const HuntWords& words)
    : programs(static_cast<std::size_t>(words.programs)),
      findings(static_cast<std::size_t>(words.stop_after)) {
  if (!words.time.empty()) time = time_of(words.time);
  if (words.time.empty() && programs == 0) time = std::chrono::seconds(60);
  // A shell that sends it to the background has it ignored.
  if (std::signal(SIGINT, interrupt) == SIG_IGN) std::signal(SIGINT, SIG_IGN);
}

bool HuntEnd::reached(std::size_t tried, std::size_t found) const {
  return is_broken_off() || (programs != 0 && tried >= programs) ||
         (findings != 0 && found >= findings) ||
         (time.count() != 0 && Clock::now() - begin >= time);
}

double HuntEnd::seconds_left(std::size_t tried) const {
  const std::chrono::duration<double> spent = Clock::now() - begin;
  double left = std::numeric_limits<double>::max();
  if (time.count() != 0) left = std::chrono::duration<double>(time).count() - spent.count();
  if (programs != 0 && tried != 0) {
    const double each = spent.count() / static_cast<double>(tried);
    left = std::min(left, each * static_cast<double>(programs - std::min(programs, tried)));
  }
  return std::max(0.0, left);
}

void add_program_options(Command& command, HuntWords& words) {
  command.option("--profile", words.profile, "the machine of every program; without: any");
  command.flag("--everywhere", words.everywhere,
               "departures outside of the domain (docs/domain.md) are findings, too");
  command.repeated_option("--reading", words.readings, "one reading as key=value");
  command.option("--settings", words.settings,
                 "what generated programs are like: valid=1,boundary=2,blocks=4");
  command.option("--time", words.time,
                 "how long: 90s, 10m, 2h; without it and --programs a minute");
}

void add_known_failures(Command& command, std::string& known_failures, std::string& corpus) {
  command.option("--known-failures", known_failures,
                 "TOML file of cases that the subject is known to fail: what they show is no news");
  command.option("--corpus", corpus, "corpus of the known failures (the checked-in one)");
}

void know_failures(const HuntWords& words, hunt::HuntOptions& options) {
  if (words.known_failures.empty()) return;
  const std::vector<oracle::KnownFailure> entries = load_known_failures(words.known_failures);
  hunt::Trial trial(trial_subject(words.trial), trial_options(words.trial));
  check_dialect(trial.info(), options.dialect);
  const oracle::Corpus corpus(corpus_folder(words.corpus));
  options.known = hunt::known_signatures(entries, corpus, options.dialect, trial);
  Output output;
  output.text() =
      options.known.empty()
          ? fmt::format(
                "{}: none of its failures shows in a case of {}: they are mended, or of "
                "another corpus (--corpus)\n",
                words.known_failures, corpus.folder())
          : fmt::format("{}: {} departures that are known are no news\n", words.known_failures,
                        options.known.size());
  output.tell();
}

bool judged_little(const hunt::HuntCount& count) {
  return count.moved * 10 < count.programs;
}

}  // namespace gonogo::cli
