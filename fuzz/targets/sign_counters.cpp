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
std::size_t place_of(std::string_view clause, std::string_view what, int sign) {
  constexpr std::hash<std::string_view> kHash;
  return ((kHash(clause) * 31 + kHash(what)) * 3 + static_cast<std::size_t>(sign + 1)) % kCounters;
}

}  // namespace

void SignCounters::note(reference::ClauseId clause, std::string_view what, int sign) {
  std::uint8_t& counter = counters[place_of(reference::clause_name(clause), what, sign)];
  if (counter != UINT8_MAX) ++counter;
}

}  // namespace gonogo::fuzz
