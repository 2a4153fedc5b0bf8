// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/sign_counters.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace gonogo::fuzz {
namespace {

// Some hundred signs a dialect. The engine sets them to 0 before an input and reads them behind it.
constexpr std::size_t kCounters = 4'096;
[[gnu::section("__libfuzzer_extra_counters"), gnu::used]] std::uint8_t counters[kCounters];

// The place of a sign, the same in every run.
std::size_t place_of(const reference::Decision& decision) {
  constexpr std::hash<std::string_view> kHash;
  const std::size_t expression =
      kHash(reference::clause_name(decision.clause)) * 31 + kHash(decision.what);
  return (expression * 3 + static_cast<std::size_t>(decision.sign + 1)) % kCounters;
}

}  // namespace

void SignCounters::note(const reference::Decision& decision) {
  std::uint8_t& counter = counters[place_of(decision)];
  if (counter != UINT8_MAX) ++counter;
}

}  // namespace gonogo::fuzz
