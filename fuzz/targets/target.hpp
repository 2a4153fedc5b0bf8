// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
// libFuzzer's own mutations, with its dictionary and what it saw compared. Other engines have none.
extern "C" __attribute__((weak)) std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size,
                                                              std::size_t most);

namespace gonogo::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

// The fault that is planted in what the target tries, so that the bench itself can be checked: of a
// built-in expander, or one of the target's own. Empty: none.
inline std::string_view planted_fault() {
  static const char* const kFault = std::getenv("GONOGO_FUZZ_FAULT");
  return kFault == nullptr ? std::string_view() : kFault;
}

// A quarter of all mutations is the engine's own; the others are those of the target's structured
// mutator.
inline bool is_turn_of_engine(unsigned int seed) {
  return seed % 4 == 0;
}

// A finding: said on standard error, then an abort for the engine to catch.
[[noreturn]] inline void fail(const std::string& what, std::string_view input) {
  std::fprintf(stderr, "%s\n%.*s\n", what.c_str(), static_cast<int>(input.size()), input.data());
  std::abort();
}

}  // namespace gonogo::fuzz
