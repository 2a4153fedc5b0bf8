// SPDX-License-Identifier: GPL-3.0-or-later
//
// The decisions of a generator as RapidCheck draws and shrinks them. Without its last bytes a
// program is shorter, and a smaller byte is an earlier choice (fuzz/generate/choices.hpp).
#pragma once

#include <rapidcheck.h>

#include <cstdint>
#include <random>
#include <vector>

namespace gonogo::generate {

using Decisions = std::vector<std::uint8_t>;

inline rc::Gen<Decisions> decisions() {
  // Hardly a program takes more; what is drawn behind them is the first choice.
  constexpr std::size_t kBytes = 4'096;
  const auto bytes_of = [](std::uint64_t seed) {
    std::mt19937_64 random(seed);
    Decisions bytes(kBytes);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() >> 56);
    return bytes;
  };
  // RapidCheck draws small numbers first, and of all sizes these are seeds.
  const auto seeds =
      rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
  return rc::gen::shrink(rc::gen::map(seeds, bytes_of), [](const Decisions& bytes) {
    return rc::seq::concat(rc::shrink::removeChunks(bytes),
                           rc::shrink::eachElement(bytes, [](std::uint8_t byte) {
                             return rc::shrink::towards<std::uint8_t>(byte, 0);
                           }));
  });
}

}  // namespace gonogo::generate
