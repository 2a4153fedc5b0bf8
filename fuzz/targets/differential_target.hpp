// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differential: programs through a built-in expander and the judge. The bytes are the generator's
// decisions, or the program itself. Cost cap: the generator's settings; 512 bytes of a program,
// since a tiny Q over a great depth is a long one.
#pragma once

#include "expanders/registry.hpp"
#include "fuzz/differential.hpp"
#include "fuzz/generator.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {

inline void check(oracle::Subject& subject, const reference::Profile& profile,
                  std::string_view program) {
  constexpr std::size_t kMostRecords = 20'000;  // about a second under the sanitizers
  const auto verdict = run_and_judge(subject, profile, program, kMostRecords);
  if (verdict && oracle::decision(verdict->kind) == oracle::Decision::no_go) {
    fail(failure_text(*verdict, profile, program), "");
  }
}

// One input: the program that the bytes decide, through the expander of that name; of its first
// dialect where none is given.
inline void try_expander(std::string_view name, const std::uint8_t* data, std::size_t size,
                         std::string_view dialect = {}) {
  static const auto subject = oracle::make_interface_subject(*expanders::find(name));
  static const Generator& generator = *find_generator(name, dialect);
  Choices choices(std::span<const std::uint8_t>(data, size));
  const GeneratedProgram program = generator.generate(choices, nullptr);
  check(*subject, program.profile, program.text);
}

// One input: a program for the dialect's machine of defaults.
inline void try_text(std::string_view name, std::string_view dialect, const std::uint8_t* data,
                     std::size_t size) {
  constexpr std::size_t kMostBytes = 512;
  static const auto subject = oracle::make_interface_subject(*expanders::find(name));
  static const auto profile = std::get<reference::Profile>(reference::default_profile(dialect));
  if (size <= kMostBytes) check(*subject, profile, text_of(data, size));
}

}  // namespace gonogo::fuzz
