// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "fuzz/program/mutator/mutate.hpp"

namespace gonogo::program {
namespace {

constexpr std::size_t kMostBytes = 2048;
using Bytes = std::vector<std::uint8_t>;
using Offset = Bytes::difference_type;

void change_one(Dice& dice, Bytes& bytes) {
  std::uint8_t& byte = dice.pick(bytes);
  switch (dice.below(4)) {
    case 0:
      byte = static_cast<std::uint8_t>(byte ^ 1U << dice.below(8));
      break;
    case 1:
      byte = static_cast<std::uint8_t>(byte + 1 + dice.below(4));
      break;
    case 2:
      byte = static_cast<std::uint8_t>(byte - 1 - dice.below(4));
      break;
    default:
      byte = dice.byte();
  }
}

void insert_some(Dice& dice, Bytes& bytes) {
  const std::size_t count = 1 + dice.below(8);
  Bytes fresh(count);
  for (std::uint8_t& byte : fresh) byte = dice.byte();
  const auto at = static_cast<Offset>(dice.below(bytes.size() + 1));
  bytes.insert(bytes.begin() + at, fresh.begin(), fresh.end());
}

void cut_out(Dice& dice, Bytes& bytes) {
  const std::size_t begin = dice.below(bytes.size());
  const std::size_t count = std::min(1 + dice.below(16), bytes.size() - begin);
  const auto from = bytes.begin() + static_cast<Offset>(begin);
  bytes.erase(from, from + static_cast<Offset>(count));
}

// The head of one and the tail of the other.
void splice(Dice& dice, Bytes& bytes, const Bytes& other) {
  if (other.empty()) return;
  bytes.resize(dice.below(bytes.size() + 1));
  bytes.insert(bytes.end(), other.begin() + static_cast<Offset>(dice.below(other.size())),
               other.end());
}

}  // namespace

Bytes mutate_bytes(Dice& dice, Bytes bytes, const Bytes& other) {
  const std::size_t steps = std::array<std::size_t, 4>{1, 2, 4, 8}[dice.below(4)];
  for (std::size_t i = 0; i < steps; ++i) {
    if (bytes.empty()) {
      insert_some(dice, bytes);
      continue;
    }
    const std::size_t kind = dice.below(8);
    if (kind < 5) {
      change_one(dice, bytes);
    } else if (kind == 5) {
      insert_some(dice, bytes);
    } else if (kind == 6) {
      cut_out(dice, bytes);
    } else {
      splice(dice, bytes, other);
    }
  }
  bytes.resize(std::min(bytes.size(), kMostBytes));
  return bytes;
}

}  // namespace gonogo::program
