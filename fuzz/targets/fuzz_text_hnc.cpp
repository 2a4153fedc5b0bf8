// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/differential_target.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  gonogo::fuzz::try_text("hnc", "hnc21t", data, size);
  return 0;
}
