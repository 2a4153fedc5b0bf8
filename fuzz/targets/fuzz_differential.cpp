// SPDX-License-Identifier: GPL-3.0-or-later
//
// The input is the decisions of a generator. The target's expander and dialect are definitions of
// its own.
#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/differential_target.hpp"

void gonogo::fuzz::decide(gonogo::generate::Choices& choices) {
  decide_program(GONOGO_FUZZ_EXPANDER, GONOGO_FUZZ_DIALECT, choices);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::try_expander(GONOGO_FUZZ_EXPANDER, GONOGO_FUZZ_DIALECT,
                             gonogo::fuzz::choices_of(data, size));
  return 0;
}
