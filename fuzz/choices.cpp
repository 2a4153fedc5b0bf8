// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/choices.hpp"

namespace gonogo::fuzz {

std::uint32_t Choices::next_byte() {
  if (random_) return static_cast<std::uint32_t>((*random_)() >> 56);
  if (bytes_.empty()) return 0;
  const std::uint8_t byte = bytes_.front();
  bytes_ = bytes_.subspan(1);
  return byte;
}

std::uint32_t Choices::below(std::uint32_t count) {
  if (count <= 1) return 0;
  std::uint32_t value = next_byte();
  if (count > 256) value = value << 8 | next_byte();
  return value % count;
}

std::int64_t Choices::between(std::int64_t low, std::int64_t high) {
  const std::uint64_t span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
  std::uint64_t value = 0;
  for (std::uint64_t reach = 1; reach < span && reach != 0; reach <<= 8) {
    value = value << 8 | next_byte();
  }
  return low + static_cast<std::int64_t>(span == 0 ? value : value % span);
}

}  // namespace gonogo::fuzz
