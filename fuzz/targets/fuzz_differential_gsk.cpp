// SPDX-License-Identifier: GPL-3.0-or-later
//
// Differential: generated GSK programs through the built-in expander and the judge. The bytes are
// the generator's decisions. Cost cap: the generator's settings.
#include "expanders/registry.hpp"
#include "fuzz/differential.hpp"
#include "fuzz/gsk_generator.hpp"
#include "fuzz/targets/target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gonogo;
  static const auto subject = oracle::make_interface_subject(*expanders::find("gsk"));
  fuzz::Choices choices(std::span<const std::uint8_t>(data, size));
  const fuzz::GeneratedProgram program = fuzz::generate_gsk(choices, {});
  const oracle::Verdict verdict = fuzz::run_and_judge(*subject, program.profile, program.text);
  if (oracle::decision(verdict.kind) == oracle::Decision::no_go) {
    fuzz::fail(fuzz::failure_text(verdict, program.profile, program.text), "");
  }
  return 0;
}
