// SPDX-License-Identifier: GPL-3.0-or-later
#include "corpus/io/sha256.hpp"

namespace gonogo::oracle {

Sha256::Sha256() {
  sha256_init(&context_);
}

void Sha256::update(std::string_view bytes) {
  sha256_update(&context_, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
}

void Sha256::update_line(std::string_view line) {
  update(line);
  update("\n");
}

std::array<std::uint8_t, SHA256_DIGEST_SIZE> Sha256::digest() {
  std::array<std::uint8_t, SHA256_DIGEST_SIZE> bytes{};
  sha256_digest(&context_, bytes.size(), bytes.data());
  return bytes;
}

std::string Sha256::hex() {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : digest()) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::uint64_t leading_bytes(std::string_view text) {
  Sha256 hash;
  hash.update(text);
  const auto digest = hash.digest();
  std::uint64_t first = 0;
  for (std::size_t i = 0; i < sizeof first; ++i) first = first << 8 | digest[i];
  return first;
}

}  // namespace gonogo::oracle
