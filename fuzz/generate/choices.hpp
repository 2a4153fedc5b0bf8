// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where a generator gets its decisions from: a seed, or the bytes of a fuzzer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace gonogo::generate {

// A decision that bytes made.
struct NotedDecision {
  std::size_t at = 0;       // where its bytes begin
  std::size_t bytes = 0;    // how many it takes
  std::uint64_t count = 0;  // among how many, at least 2
  bool operator==(const NotedDecision&) const = default;
};

class Choices {
 public:
  // Endless decisions of a seed.
  explicit Choices(std::uint64_t seed) : random_(seed) {}
  // As many as there are bytes; 0 after that.
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  // A number in [0, count). REQUIRES: 0 < count <= 65536.
  std::uint32_t below(std::uint32_t count);
  // A number in [low, high]; low where that is empty. REQUIRES: high - low < 2^64 - 1.
  std::int64_t between(std::int64_t low, std::int64_t high);
  bool one_in(std::uint32_t count) { return below(count) == 0; }
  template <typename T>
  T pick(std::initializer_list<T> items) {
    return items.begin()[below(static_cast<std::uint32_t>(items.size()))];
  }
  template <typename List>
  const auto& pick(const List& list) {
    return list[below(static_cast<std::uint32_t>(std::size(list)))];
  }
  // From now on notes there the decisions whose bytes are all there. It must outlive this.
  void note_in(std::vector<NotedDecision>& decisions) { noted_ = &decisions; }
  // Whether the bytes are used up; never for a seed.
  bool exhausted() const { return !random_ && bytes_.empty(); }

 private:
  std::uint32_t next_byte();
  void note(std::size_t bytes, std::uint64_t count);

  std::optional<std::mt19937_64> random_;  // of a seed
  std::span<const std::uint8_t> bytes_;
  std::size_t used_ = 0;  // of the bytes
  std::vector<NotedDecision>* noted_ = nullptr;
};

inline std::uint32_t Choices::next_byte() {
  if (random_) return static_cast<std::uint32_t>((*random_)() >> 56);
  if (bytes_.empty()) return 0;
  const std::uint8_t byte = bytes_.front();
  bytes_ = bytes_.subspan(1);
  ++used_;
  return byte;
}

// Before its bytes are taken.
inline void Choices::note(std::size_t bytes, std::uint64_t count) {
  if (noted_ != nullptr && bytes <= bytes_.size()) noted_->push_back({used_, bytes, count});
}

inline std::uint32_t Choices::below(std::uint32_t count) {
  if (count <= 1) return 0;
  note(count > 256 ? 2 : 1, count);
  std::uint32_t value = next_byte();
  if (count > 256) value = value << 8 | next_byte();
  return value % count;
}

inline std::int64_t Choices::between(std::int64_t low, std::int64_t high) {
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
