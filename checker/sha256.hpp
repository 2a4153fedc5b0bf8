// SPDX-License-Identifier: GPL-3.0-or-later
//
// SHA-256 as FIPS 180-4 has it.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::checker {

class Sha256 {
 public:
  using Digest = std::array<std::uint8_t, 32>;

  void update(std::string_view bytes);
  // Ends the message; nothing may follow.
  Digest digest();
  std::string hex();

 private:
  void take_block();

  std::array<std::uint32_t, 8> state_ = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                         0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  std::array<std::uint8_t, 64> block_{};
  std::size_t filled_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace gonogo::checker
