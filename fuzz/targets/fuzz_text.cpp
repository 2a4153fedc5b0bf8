// SPDX-License-Identifier: GPL-3.0-or-later
//
// The input is NC text. The target's expander and dialect are definitions of its own.
#include "fuzz/targets/differential_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::try_text(GONOGO_FUZZ_EXPANDER, GONOGO_FUZZ_DIALECT, data, size);
  return 0;
}
