// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/generate/choices.hpp"

namespace gonogo::generate {

std::uint32_t Choices::next_byte() {
  if (random_) return static_cast<std::uint32_t>((*random_)() >> 56);
  if (bytes_.empty()) return 0;
  const std::uint8_t byte = bytes_.front();
  bytes_ = bytes_.subspan(1);
  ++used_;
  return byte;
}

// Before its bytes are taken.
void Choices::note(std::size_t bytes, std::uint64_t count) {
  if (noted_ != nullptr && bytes <= bytes_.size()) noted_->push_back({used_, bytes, count});
}

std::uint32_t Choices::below(std::uint32_t count) {
  if (count <= 1) return 0;
  note(count > 256 ? 2 : 1, count);
  std::uint32_t value = next_byte();
  if (count > 256) value = value << 8 | next_byte();
  return value % count;
}

std::int64_t Choices::between(std::int64_t low, std::int64_t high) {
  if (high <= low) return low;
  const std::uint64_t span = static_cast<std::uint64_t>(high) - static_cast<std::uint64_t>(low) + 1;
  std::size_t bytes = 0;
  for (std::uint64_t reach = 1; reach < span && reach != 0; reach <<= 8) ++bytes;
  note(bytes, span);
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value = value << 8 | next_byte();
  return low + static_cast<std::int64_t>(value % span);
}

}  // namespace gonogo::generate
