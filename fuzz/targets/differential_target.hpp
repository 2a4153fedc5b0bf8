// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differential: programs through a built-in expander and the judge. The bytes are the generator's
// decisions, or the program itself. Cost cap: the generator's settings; 512 bytes of a program,
// since a tiny Q over a great depth is a long one.
#pragma once

#include <fstream>
#include <memory>

#include "expanders/registry.hpp"
#include "fuzz/differential.hpp"
#include "fuzz/generator.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {

// The expander with the planted fault, if there is one.
inline std::unique_ptr<oracle::Subject> make_subject(std::string_view name) {
  const gonogo_subject_v1* const expander = expanders::find(name, planted_fault());
  if (expander == nullptr) {
    std::fprintf(stderr, "the expander has no fault %s\n", std::string(planted_fault()).c_str());
    std::exit(2);
  }
  return oracle::make_interface_subject(*expander);
}

// A broken bench, which fuzz/check-bench has to notice: a judge that says GO to everything.
inline bool judge_is_blind() {
  static const char* const kJudge = std::getenv("GONOGO_FUZZ_JUDGE");
  return kJudge != nullptr && std::string_view(kJudge) == "always-go";
}

// The program and its machine as files, for `gonogo reduce`, where somebody asks for them.
inline void keep(const reference::Profile& profile, std::string_view program) {
  const char* const folder = std::getenv("GONOGO_FUZZ_FINDING");
  if (folder == nullptr) return;
  std::ofstream(folder + std::string("/program.nc"), std::ios::binary) << program;
  std::ofstream(folder + std::string("/profile.json")) << profile_text(profile);
}

inline void check(oracle::Subject& subject, const reference::Profile& profile,
                  std::string_view program) {
  constexpr std::size_t kMostRecords = 20'000;  // about a second under the sanitizers
  const auto verdict = run_and_judge(subject, profile, program, kMostRecords);
  if (judge_is_blind()) return;
  if (verdict && oracle::decision(verdict->kind) == oracle::Decision::no_go) {
    keep(profile, program);
    fail(failure_text(*verdict, profile, program), "");
  }
}

// One input: the program that the bytes decide, through the expander of that name; of its first
// dialect where none is given.
inline void try_expander(std::string_view name, const std::uint8_t* data, std::size_t size,
                         std::string_view dialect = {}) {
  static const auto subject = make_subject(name);
  static const Generator& generator = *find_generator(name, dialect);
  Choices choices(std::span<const std::uint8_t>(data, size));
  const GeneratedProgram program = generator.generate(choices, nullptr);
  check(*subject, program.profile, program.text);
}

// One input: a program for the dialect's machine of defaults.
inline void try_text(std::string_view name, std::string_view dialect, const std::uint8_t* data,
                     std::size_t size) {
  constexpr std::size_t kMostBytes = 512;
  static const auto subject = make_subject(name);
  static const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  if (size <= kMostBytes) check(*subject, profile, text_of(data, size));
}

}  // namespace gonogo::fuzz
