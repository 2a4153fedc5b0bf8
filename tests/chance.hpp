// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often a test tries something at random, and from which seed: fixed, printed, and changed by
// GONOGO_TRIALS and GONOGO_SEED. The default is small enough for every run; a night takes millions.
// Under the sanitizers it is a fifth, as that of RapidCheck (tests/CMakeLists.txt).
#pragma once

#include <cstdint>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <random>
#include <span>
#include <string_view>
#include <utility>

#include "fuzz/generate/choices.hpp"

namespace gonogo {

namespace trials {

inline long number(const char* name, long usual) {
  const char* const text = std::getenv(name);
  return text == nullptr ? usual : std::strtol(text, nullptr, 10);
}

constexpr bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__)
  return true;
#elif defined(__has_feature)
  return __has_feature(address_sanitizer) != 0;
#else
  return false;
#endif
}

}  // namespace trials

inline long trial_count(long usual) {
  return trials::number("GONOGO_TRIALS", trials::is_sanitized() ? usual / 5 : usual);
}
inline std::uint64_t trial_seed() {
  return static_cast<std::uint64_t>(trials::number("GONOGO_SEED", 20261122));
}

// What a trial draws.
class Chance {
 public:
  // Endless; or as long as there are bytes, and the first choice after that.
  explicit Chance(std::uint64_t seed) : random_(seed), choices_(seed) {}
  explicit Chance(std::span<const std::uint8_t> bytes) : choices_(bytes) {}

  // A whole number below `end`; one of a list; true once in so many; any 64 bits.
  std::size_t below(std::size_t end) {
    if (random_) return static_cast<std::size_t>((*random_)() % end);
    return static_cast<std::size_t>(choices_.between(0, static_cast<std::int64_t>(end) - 1));
  }
  template <typename List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }
  std::string_view one_of(std::initializer_list<std::string_view> texts) {
    return texts.begin()[below(texts.size())];
  }
  bool once_in(std::size_t times) { return below(times) == 0; }
  std::uint64_t bits() { return std::uint64_t{below(1UL << 32U)} << 32U | below(1UL << 32U); }
  template <typename List>
  void shuffle(List& list) {
    for (std::size_t i = std::size(list); i > 1; --i) std::swap(list[i - 1], list[below(i)]);
  }
  // For a generator: of bytes, the rest of them.
  generate::Choices& choices() { return choices_; }

 private:
  std::optional<std::mt19937_64> random_;  // of a seed
  generate::Choices choices_;
};

}  // namespace gonogo
