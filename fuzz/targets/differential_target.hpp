// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differential: generated programs through a built-in expander and the judge. The bytes are the
// generator's decisions. Cost cap: the generator's settings.
#pragma once

#include "expanders/registry.hpp"
#include "fuzz/differential.hpp"
#include "fuzz/generator.hpp"
#include "fuzz/targets/target.hpp"

namespace gonogo::fuzz {

// One input: the program that the bytes decide, through the expander of that name; of its first
// dialect where none is given.
inline void try_expander(std::string_view name, const std::uint8_t* data, std::size_t size,
                         std::string_view dialect = {}) {
  static const auto subject = oracle::make_interface_subject(*expanders::find(name));
  static const Generator& generator = *find_generator(name, dialect);
  Choices choices(std::span<const std::uint8_t>(data, size));
  const GeneratedProgram program = generator.generate(choices, nullptr);
  constexpr std::size_t kMostRecords = 20'000;  // about a second under the sanitizers
  const auto verdict = run_and_judge(*subject, program.profile, program.text, kMostRecords);
  if (verdict && oracle::decision(verdict->kind) == oracle::Decision::no_go) {
    fail(failure_text(*verdict, program.profile, program.text), "");
  }
}

}  // namespace gonogo::fuzz
