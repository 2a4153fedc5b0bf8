// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace gonogo::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// A finding: said on standard error, then an abort for the engine to catch.
[[noreturn]] inline void fail(const std::string& what, std::string_view input) {
  std::fprintf(stderr, "%s\n%.*s\n", what.c_str(), static_cast<int>(input.size()), input.data());
  std::abort();
}

}  // namespace gonogo::fuzz
