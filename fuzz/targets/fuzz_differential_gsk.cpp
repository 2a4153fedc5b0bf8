// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/decision_hooks.hpp"
#include "fuzz/targets/differential_target.hpp"

void gonogo::fuzz::decide(gonogo::generate::Choices& choices) {
  decide_program("gsk", choices);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::try_expander("gsk", gonogo::fuzz::choices_of(data, size));
  return 0;
}
