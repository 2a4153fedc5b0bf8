// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/differential_target.hpp"

void gonogo::fuzz::decide(gonogo::generate::Choices& choices) {
  decide_program("sinumerik", choices, "sinumerik802s");
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::try_expander("sinumerik", gonogo::fuzz::choices_of(data, size), "sinumerik802s");
  return 0;
}
