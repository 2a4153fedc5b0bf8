// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often a test tries something at random, and from which seed: fixed, printed, and changed by
// GONOGO_TRIALS and GONOGO_SEED. The default is small enough for every run; a night takes millions.
// Under the sanitizers it is a fifth, as that of RapidCheck (tests/CMakeLists.txt).
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <iterator>
#include <random>
#include <string_view>

namespace gonogo {

struct Trials {
  explicit Trials(long usual) : count(number("GONOGO_TRIALS", is_sanitized() ? usual / 5 : usual)) {
    const long seed = number("GONOGO_SEED", 20261122);
    std::printf("%ld trials, GONOGO_SEED=%ld\n", count, seed);
    chance.seed(static_cast<std::uint64_t>(seed));
  }

  // A whole number below `end`; one of a list; true once in so many.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(chance() % end); }
  template <typename List>
  const auto& one_of(const List& list) {
    return list[below(std::size(list))];
  }
  std::string_view one_of(std::initializer_list<std::string_view> texts) {
    return texts.begin()[below(texts.size())];
  }
  bool once_in(std::size_t times) { return below(times) == 0; }

  long count;
  std::mt19937_64 chance;

 private:
  static constexpr bool is_sanitized() {
#if defined(__SANITIZE_ADDRESS__)
    return true;
#elif defined(__has_feature)
    return __has_feature(address_sanitizer) != 0;
#else
    return false;
#endif
  }
  static long number(const char* name, long usual) {
    const char* const text = std::getenv(name);
    return text == nullptr ? usual : std::strtol(text, nullptr, 10);
  }
};

}  // namespace gonogo
