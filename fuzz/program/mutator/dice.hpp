// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers that are the same with every compiler and library: a hunt is repeated by its seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace gonogo::program {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : random_(seed) {}
  // In [0, count). REQUIRES: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  std::uint8_t byte() { return static_cast<std::uint8_t>(random_() >> 56); }
  template <typename Items>
  auto& pick(Items& items) {
    return items[below(items.size())];
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace gonogo::program
