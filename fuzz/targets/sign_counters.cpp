// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/targets/sign_counters.hpp"

#include <cstddef>
#include <cstdint>

namespace gonogo::fuzz {
namespace {

// Some hundred signs a dialect. The engine sets them to 0 before an input and reads them behind it.
constexpr std::size_t kCounters = 4'096;
[[gnu::section("__libfuzzer_extra_counters"), gnu::used]] std::uint8_t counters[kCounters];

// The place of a sign, the same in every run and build.
std::size_t place_of(std::string_view clause, std::string_view what, int sign) {
  std::uint64_t hash = 0xCBF29CE484222325U;
  const auto mix = [&hash](std::uint8_t byte) { hash = (hash ^ byte) * 0x100000001B3U; };
  for (const char c : clause) mix(static_cast<std::uint8_t>(c));
  for (const char c : what) mix(static_cast<std::uint8_t>(c));
  mix(static_cast<std::uint8_t>(sign + 1));
  return static_cast<std::size_t>(hash >> 32U) % kCounters;
}

}  // namespace

void SignCounters::note(reference::ClauseId clause, std::string_view what, int sign) {
  std::uint8_t& counter = counters[place_of(reference::clause_name(clause), what, sign)];
  if (counter != UINT8_MAX) ++counter;
}

}  // namespace gonogo::fuzz
