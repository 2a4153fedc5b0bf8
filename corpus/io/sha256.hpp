// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nettle/sha2.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace gonogo::oracle {

// SHA-256 of bytes that come in parts.
class Sha256 {
 public:
  Sha256();
  void update(std::string_view bytes);
  // The bytes and a line end.
  void update_line(std::string_view line);
  // The 32 bytes; the object starts anew.
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest();
  // The same as 64 lower-case hexadecimal digits.
  std::string hex();

 private:
  sha256_ctx context_;
};

// The first 8 bytes of the hash of a text, as a number.
std::uint64_t leading_bytes(std::string_view text);

}  // namespace gonogo::oracle
