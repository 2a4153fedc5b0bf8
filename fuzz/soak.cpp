// SPDX-License-Identifier: GPL-3.0-or-later
//
// gonogo_soak: generated programs through a subject and the judge, until one is not GO.
//   gonogo_soak [--programs N] [--seed S] [--subject SUBJECT] [--dialect D] [--settings LIST]
//               [--distribution]
//   gonogo_soak --input FILE [--subject SUBJECT] [--dialect D] [--settings LIST]
// SUBJECT is a built-in expander (NAME, NAME+FAULT), or lib:, pipe: and oneshot: as on the command
// line, which gets of each program what it declares and runs; a library runs in this process.
// LIST is as fuzz/generate/generator_settings.hpp says: raw=1,near-invalid=0,blocks=4. --distribution
// prints what the programs hold and reach: kinds, machines, records, planes, clauses, alarms,
// verdicts, and what lies outside of the domain (docs/domain.md); a departure there is counted, and
// no failure. An expander of several dialects gets programs of the first one where none is named.
// --input tries the one program that a fuzzer's input decides, and prints it first: also one that
// never ends. Exit: 0 all GO, 1 a program is not (it is printed with the seed that makes it), 2
// wrong use, 3 fewer than one program in ten was judged, or an input is not.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/tried_subject.hpp"
#include "fuzz/generate/program_report.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/differential/domain.hpp"

namespace {

using namespace gonogo;

constexpr std::size_t kMostRecords = 1'000'000;

// With all readings open a program may take more ways than the judge follows.
generate::GeneratorSettings some_open() {
  generate::GeneratorSettings settings;
  settings.open_one_in = 8;
  return settings;
}

struct SoakOptions {
  std::uint64_t programs = 10'000;
  std::uint64_t seed = 1;
  std::string subject = "gsk";
  std::string dialect;  // "": the expander's first, or the only one that the subject names
  std::string input;    // a fuzzer's input: its bytes decide one program
  bool distribution = false;
  generate::GeneratorSettings settings = some_open();
};

bool parse(int argc, char** argv, SoakOptions& options) {
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--distribution") {
      options.distribution = true;
    } else if (word == "--settings" && has_value) {
      const auto settings = generate::read_settings(argv[++i], options.settings);
      if (!settings) return false;
      options.settings = *settings;
    } else if (word == "--programs" && has_value) {
      options.programs = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--input" && has_value) {
      options.input = argv[++i];
    } else if (word == "--seed" && has_value) {
      options.seed = std::strtoull(argv[++i], nullptr, 10);
    } else if (word == "--subject" && has_value) {
      options.subject = argv[++i];
    } else if (word == "--dialect" && has_value) {
      options.dialect = argv[++i];
    } else {
      return false;
    }
  }
  return true;
}

// An error of the oracle's own names its program.
std::optional<oracle::Verdict> judged(oracle::Subject& subject,
                                      const generate::GeneratedProgram& program,
                                      std::uint64_t seed) {
  try {
    return oracle::run_and_judge(subject, program.profile, program.text, kMostRecords);
  } catch (const std::exception& error) {
    fmt::print("--seed {} --programs 1 throws: {}\nprofile: {}\nprogram:\n{}", seed, error.what(),
               reference::profile_json(program.profile), program.text);
    throw;
  }
}

// What the gauge says of itself that it does not judge: a code or a number, a level of too many
// motions, a reading under which no path is right, what the profile lacks.
bool is_out_of_reach(const oracle::Verdict& verdict) {
  using enum oracle::GapReason;
  return verdict.gap == not_covered || verdict.gap == profile_lacks || verdict.gap == cap_level ||
         verdict.gap == reading_unfit;
}

// One program, from the decisions in a fuzzer's input.
int try_input(const SoakOptions& options, const fuzz::TriedSubject& tried) {
  std::ifstream file(options.input, std::ios::binary);
  if (!file) {
    fmt::print(stderr, "{} cannot be read.\n", options.input);
    return 2;
  }
  const std::vector<char> text{std::istreambuf_iterator<char>(file), {}};
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  generate::Choices choices{std::span<const std::uint8_t>(bytes)};
  const auto program = tried.fitted(tried.generator().generate(choices, options.settings, nullptr));
  if (!program) {
    fmt::print("The subject runs too little of the program.\n");
    return 3;
  }
  fmt::print("profile: {}\nprogram:\n{}", reference::profile_json(program->profile), program->text);
  std::fflush(stdout);
  const auto verdict = oracle::run_and_judge(tried.subject(), program->profile, program->text,
                                             std::numeric_limits<std::size_t>::max());
  fmt::print("verdict: {}\n{}\n", name(verdict->kind), verdict->message);
  return decision(verdict->kind) == oracle::Decision::no_go ? 1 : 0;
}

// What became of the programs.
struct SoakTally {
  std::uint64_t judged = 0;
  std::uint64_t skipped = 0;  // by the subject, or for what it does not run
  generate::Distribution distribution;
};

// Whether the verdict is a failure of the subject, and not of what the gauge says that it does not
// judge, or outside of its domain.
bool is_failure(const oracle::Verdict& verdict, const generate::GeneratedProgram& program,
                SoakTally& tally) {
  if (decision(verdict.kind) == oracle::Decision::go) {
    ++tally.judged;
    return false;
  }
  if (is_out_of_reach(verdict)) return false;
  const auto rule = oracle::outside_domain(program.profile, program.text, verdict);
  if (rule.empty()) return true;
  ++tally.distribution[fmt::format("out of domain, and no failure: {}", rule)];
  return false;
}

// The first program of the decisions that the subject runs a part of. Nothing: there is hardly any.
std::optional<generate::GeneratedProgram> drawn(const SoakOptions& options,
                                                const fuzz::TriedSubject& tried, std::uint64_t seed,
                                                generate::Distribution& distribution) {
  constexpr int kMostDrawn = 50;
  generate::Choices choices(seed);
  for (int i = 0; i < kMostDrawn; ++i) {
    auto program = tried.fitted(tried.generator().generate(
        choices, options.settings, options.distribution ? &distribution : nullptr));
    if (program) return program;
  }
  return std::nullopt;
}

// Program i of seed s is program 0 of seed s + i, so that one number brings a failure back. Whether
// it is no failure.
bool try_program(const SoakOptions& options, const fuzz::TriedSubject& tried, std::uint64_t seed,
                 SoakTally& tally) {
  const auto program = drawn(options, tried, seed, tally.distribution);
  if (!program) {
    ++tally.skipped;
    return true;
  }
  if (options.distribution) {
    generate::count_program(*program, tally.distribution);
    const std::string_view rule = oracle::outside_domain(program->profile, program->text);
    if (!rule.empty()) ++tally.distribution[fmt::format("out of domain: {}", rule)];
  }
  const auto verdict = judged(tried.subject(), *program, seed);
  ++tally.distribution[verdict ? fmt::format("verdict {}", name(verdict->kind)) : "too long"];
  if (!verdict) return true;
  // What the subject does not implement it says: neither right nor wrong.
  if (verdict->kind == oracle::VerdictKind::skip) {
    ++tally.skipped;
    return true;
  }
  if (!is_failure(*verdict, *program, tally)) return true;
  fmt::print("--seed {} --programs 1 gives:\n{}\ntrace:\n{}", seed,
             oracle::failure_text(*verdict, program->profile, program->text),
             oracle::trace_text(tried.subject(), program->profile, program->text));
  return false;
}

int soak(const SoakOptions& options) {
  const fuzz::TriedSubject tried(options.subject, options.dialect);
  if (!options.input.empty()) return try_input(options, tried);
  SoakTally tally;
  const auto start = std::chrono::steady_clock::now();
  for (std::uint64_t i = 0; i < options.programs; ++i) {
    if (!try_program(options, tried, options.seed + i, tally)) return 1;
  }
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  fmt::print("{} programs from seed {} on: no failure ({:.0f} a second), {} judged, {} skipped\n",
             options.programs, options.seed, static_cast<double>(options.programs) / spent.count(),
             tally.judged, tally.skipped);
  fmt::print("{}", generate::distribution_text(tally.distribution));
  if (tally.judged * 10 >= options.programs) return 0;
  fmt::print("Fewer than one program in ten was judged: this says little of the subject.\n");
  return 3;
}

}  // namespace

int main(int argc, char** argv) {
  SoakOptions options;
  if (!parse(argc, argv, options)) {
    fmt::print(stderr,
               "usage: {} [--programs N] [--seed S] [--subject SUBJECT] [--dialect D] "
               "[--settings LIST] [--distribution]\n"
               "       {} --input FILE [--subject SUBJECT] [--dialect D] [--settings LIST]\n",
               argv[0], argv[0]);
    return 2;
  }
  try {
    return soak(options);
  } catch (const oracle::SubjectUnusable& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
