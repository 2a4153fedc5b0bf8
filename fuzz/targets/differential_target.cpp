// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/differential_target.hpp"

#include <fmt/format.h>

#include <fstream>
#include <unordered_set>

#include "fuzz/generate/generator.hpp"
#include "fuzz/generate/program_report.hpp"
#include "fuzz/targets/sign_counters.hpp"
#include "fuzz/targets/target.hpp"
#include "fuzz/tried_subject.hpp"
#include "oracle/differential/differential.hpp"
#include "oracle/differential/domain.hpp"

namespace gonogo::fuzz {
namespace {

// Environment GONOGO_FUZZ_SUBJECT=SUBJECT, as in fuzz/tried_subject.hpp: it is tried in place of
// the expander. That has the planted fault, if there is one.
TriedSubject make_subject(std::string_view name, std::string_view dialect) {
  const char* const other = std::getenv("GONOGO_FUZZ_SUBJECT");
  std::string expander(name);
  if (!planted_fault().empty()) expander += "+" + std::string(planted_fault());
  try {
    return {other == nullptr ? expander : other, std::string(dialect)};
  } catch (const oracle::SubjectUnusable& error) {
    std::fprintf(stderr, "%s\n", error.what());
    std::exit(2);
  }
}

// A broken bench, which fuzz/check-bench has to notice: a judge that says GO to everything.
bool judge_is_blind() {
  static const char* const kJudge = std::getenv("GONOGO_FUZZ_JUDGE");
  return kJudge != nullptr && std::string_view(kJudge) == "always-go";
}

// The program and its machine as files, for `gonogo reduce`, where somebody asks for them.
void keep(const reference::Profile& profile, std::string_view program) {
  const char* const folder = std::getenv("GONOGO_FUZZ_FINDING");
  if (folder == nullptr) return;
  std::ofstream(folder + std::string("/program.nc"), std::ios::binary) << program;
  std::ofstream(folder + std::string("/profile.json")) << oracle::profile_text(profile);
}

// Environment GONOGO_FUZZ_ALONE=1: the expander runs, and nobody judges it; for
// tests/bench/fuzz_rate, which compares the two.
bool runs_alone() {
  static const bool kAlone = std::getenv("GONOGO_FUZZ_ALONE") != nullptr;
  return kAlone;
}

// What became of the program: the name of a verdict, or "too long".
std::string_view check(oracle::Subject& subject, const reference::Profile& profile,
                       std::string_view program, std::size_t most_records) {
  const SignCounters counters;
  const auto verdict = oracle::run_and_judge(subject, profile, program, most_records);
  if (!verdict) return "too long";
  if (!judge_is_blind() && oracle::decision(verdict->kind) == oracle::Decision::no_go &&
      oracle::outside_domain(profile, program).empty()) {
    keep(profile, program);
    fail(oracle::failure_text(*verdict, profile, program), "");
  }
  return oracle::name(verdict->kind);
}

// Environment GONOGO_FUZZ_STATISTICS=FILE: what the programs were is written there at the end.
class ProgramStatistics {
 public:
  ProgramStatistics() : file_(std::getenv("GONOGO_FUZZ_STATISTICS")) {}
  ~ProgramStatistics() {
    if (file_ != nullptr) std::ofstream(file_) << generate::distribution_text(distribution_);
  }
  generate::Distribution* distribution() { return file_ == nullptr ? nullptr : &distribution_; }
  void count(const generate::GeneratedProgram& program) {
    if (file_ == nullptr) return;
    generate::count_program(program, distribution_);
    const std::string all = oracle::profile_text(program.profile) + program.text;
    if (!seen_.insert(std::hash<std::string>()(all)).second)
      ++distribution_["programs seen before"];
  }
  void count_verdict(std::string_view verdict) {
    if (file_ != nullptr) ++distribution_[fmt::format("verdict {}", verdict)];
  }

 private:
  const char* file_;
  generate::Distribution distribution_;
  std::unordered_set<std::size_t> seen_;  // hashes
};

// Environment GONOGO_FUZZ_SETTINGS=LIST changes the settings of generated programs.
generate::GeneratorSettings read_environment() {
  const char* const list = std::getenv("GONOGO_FUZZ_SETTINGS");
  const auto settings =
      generate::read_settings(list == nullptr ? "" : list, generate::in_process_settings());
  if (settings) return *settings;
  std::fprintf(stderr, "GONOGO_FUZZ_SETTINGS: write as in fuzz/generate/generator_settings.hpp\n");
  std::exit(2);
}

generate::GeneratedProgram generate(std::string_view name, std::string_view dialect,
                                    generate::Choices& choices,
                                    generate::Distribution* distribution) {
  static const generate::Generator& generator = *generate::find_generator(name, dialect);
  static const generate::GeneratorSettings settings = read_environment();
  return generator.generate(choices, settings, distribution);
}

}  // namespace

void try_expander(std::string_view name, std::string_view dialect, generate::Choices choices) {
  constexpr std::size_t kMostRecords = 1'000;  // a tenth of a second under the sanitizers
  static const TriedSubject tried = make_subject(name, dialect);
  static ProgramStatistics statistics;
  const auto program = tried.fitted(generate(name, dialect, choices, statistics.distribution()));
  if (!program) return statistics.count_verdict("skip");
  statistics.count(*program);
  if (runs_alone()) {
    oracle::run_alone(tried.subject(), program->profile, program->text, kMostRecords);
    return;
  }
  statistics.count_verdict(check(tried.subject(), program->profile, program->text, kMostRecords));
}

void decide_program(std::string_view name, std::string_view dialect, generate::Choices& choices) {
  generate(name, dialect, choices, nullptr);
}

void try_text(std::string_view name, std::string_view dialect, const std::uint8_t* data,
              std::size_t size) {
  constexpr std::size_t kMostBytes = 512;
  constexpr std::size_t kMostRecords = 20'000;  // about a second under the sanitizers
  static const TriedSubject tried = make_subject(name, dialect);
  static const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  if (size > kMostBytes) return;
  const std::string_view text = text_of(data, size);
  const auto program = tried.fitted({profile, std::string(text)});
  if (!program) return;
  if (runs_alone() || !oracle::has_short_numbers(program->text)) {
    oracle::run_alone(tried.subject(), program->profile, program->text, kMostRecords);
    return;
  }
  check(tried.subject(), program->profile, program->text, kMostRecords);
}

}  // namespace gonogo::fuzz
